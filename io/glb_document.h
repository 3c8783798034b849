#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/frame_source.h"
#include "io/obj.h"

namespace honeycomb::Io {

/// The box round a frame's positions or differences.
struct GlbBounds {
  std::array<float, 3> least{};
  std::array<float, 3> most{};
};
/// Linear.
GlbBounds boundsOf(std::span<const float> points);

/// The parts of a .glb file but its frames: what glbLayout() describes.
class GlbDocument {
 public:
  GlbDocument(const ObjContent<float>& content, const FrameInfo& info);

  /// The vertex of the mesh that each vertex of the file is.
  const std::vector<std::int32_t>& vertices() const { return vertices_; }
  /// Everything in front of the frames.
  std::vector<std::byte> header(std::span<const GlbBounds> bounds) const;
  /// The JSON chunk's text, which begins at byte kJsonOffset, for the bounds of all frames; always as long.
  std::string json(std::span<const GlbBounds> bounds) const;
  std::int64_t fileBytes() const;

  static constexpr std::int64_t kJsonOffset = 20;

 private:
  /// A part of the binary chunk.
  struct Section {
    std::string attribute;  ///< of the mesh; empty: indices, times, weights
    std::string type;       ///< SCALAR, VEC2, VEC3
    int componentType = 0;
    int target = 0;  ///< 0: none
    std::int64_t count = 0;
    std::int64_t begin = 0, end = 0;  ///< bytes
  };
  void splitVertices(const ObjContent<float>& content);
  void addIndices(const ObjContent<float>& content);
  void addAttributes(const ObjContent<float>& content);
  void addAnimation();
  template <class Number>
  void add(Section section, const std::vector<Number>& numbers, std::int64_t width);
  std::string compose(std::span<const GlbBounds> bounds) const;
  std::int64_t frameBytes() const;

  FrameInfo info_;
  std::vector<std::int32_t> vertices_;
  std::vector<std::int32_t> texcoords_;       // of each vertex of the file, -1: none
  std::vector<std::uint32_t> cornerIndices_;  // the file's vertex of each corner
  std::vector<std::byte> binary_;
  std::vector<Section> sections_;  // indices, attributes, then times and weights where it moves
  std::vector<float> times_;
  std::size_t jsonBytes_ = 0;
};

}  // namespace honeycomb::Io
