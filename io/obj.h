#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "far/base/result.h"
#include "io/mesh.h"

namespace honeycomb::Io {

/// Reads a Wavefront OBJ file; groups, objects, materials, smoothing and unknown statements are passed over: negative
/// indices, v/vt/vn in all forms, CRLF, comments, continued lines, any line length. A positive index may name what the
/// file defines further down. A vertex may carry a weight w, which is passed over, and a colour; a weight or a missing
/// v of a texture coordinate is passed over or 0. Tags for creases and corners: see ObjTags. Linear in the file's size.
/// Errors: unreadable; invalidFile with the message "FILE:LINE: what and what to do" and the line as element, for
/// binary garbage, numbers that can't be read, faces of fewer than three sides, a zero index, an index out of range,
/// tags that can't be read or obeyed, and with "FILE: ..." for no vertices or no faces; invalidPositions (element: the
/// vertex, counted from 0) for NaN or infinity in a position, the same in anything else being invalidFile; tooLarge
/// past 2^31 - 1 vertices or corners; outOfMemory. Whether the polygons form a manifold, and whether creases lie on
/// their edges, is Far::Topology's business.
Result<Mesh> readObj(const std::filesystem::path& path);

/// The same from a text in memory; `name` stands for the file in messages. `maxElements` limits vertices and corners.
Result<Mesh> parseObj(std::string_view text, std::string_view name,
                      std::int64_t maxElements = std::numeric_limits<std::int32_t>::max());

/// What writeObj writes. Points are `Real` x y z packed; polygons as face offsets into vertex numbers.
template <class Real>
struct ObjContent {
  std::span<const Real> positions;
  std::span<const Real> normals;              ///< one a vertex (written as vn and v//vn) or empty
  std::span<const std::int32_t> faceOffsets;  ///< faces + 1
  std::span<const std::int32_t> faceVertices;
  std::span<const Real> colours = {};                  ///< r g b per vertex (written behind its position) or empty
  std::span<const Real> texcoords = {};                ///< u v each
  std::span<const std::int32_t> cornerTexcoords = {};  ///< per corner: one of them, -1 for none; or empty
};

/// Writes an OBJ with coordinates that read back to the same bits (9 significant digits for float, 17 for double).
/// The file appears under `path` only when whole. Errors: unwritable; before anything is written: invalidOption for
/// spans whose lengths don't fit together, invalidMesh (element: the face) for a vertex or texture coordinate out of
/// range, invalidPositions (element: the vertex or texture coordinate) for NaN or infinity, which no reader takes.
template <class Real>
Result<void> writeObj(const std::filesystem::path& path, const ObjContent<Real>& content);

}  // namespace honeycomb::Io
