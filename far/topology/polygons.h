#pragma once

#include <cstdint>
#include <vector>

namespace honeycomb::Far {

/// An edge along which the surface is to stay sharp for that many steps; from kSharp on for all of them.
struct Crease {
  std::int32_t vertex0 = 0;
  std::int32_t vertex1 = 0;
  double sharpness = 0;
};
/// As in OpenSubdiv, sharpness 10 is infinite.
constexpr double kSharp = 10;

/// A polygon mesh as a caller has it: face f is the loop of the vertices indices[faceOffsets[f]] to
/// indices[faceOffsets[f+1]-1], counter-clockwise seen from outside.
struct Polygons {
  std::int32_t vertexCount = 0;
  std::vector<std::int64_t> faceOffsets{0};  ///< faceCount + 1 ascending positions in `indices`
  std::vector<std::int32_t> indices;         ///< vertex of each corner
  std::vector<std::int32_t> corners;         ///< boundary vertices to be kept as corners by the brick boundary rule
  std::vector<Crease> creases;               ///< edges of the mesh; on a boundary they say nothing

  std::int64_t faceCount() const { return static_cast<std::int64_t>(faceOffsets.size()) - 1; }
  /// Appends a face.
  void addFace(const std::vector<std::int32_t>& loop) {
    indices.insert(indices.end(), loop.begin(), loop.end());
    faceOffsets.push_back(static_cast<std::int64_t>(indices.size()));
  }
};

}  // namespace honeycomb::Far
