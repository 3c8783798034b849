#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/topology/polygons.h"

namespace honeycomb::Io {

/// A mesh as it was read: polygons of any side count as they stand in the file, positions in double. Texture
/// coordinates and normals have numbers of their own, so that corners of one vertex may differ (seams).
struct Mesh {
  Far::Polygons polygons;
  std::vector<double> positions;              ///< x y z per vertex
  std::vector<double> colours;                ///< r g b per vertex, white where the file names none; empty when it
                                              ///< names none at all
  std::vector<double> texcoords;              ///< u v each
  std::vector<double> normals;                ///< x y z each
  std::vector<std::int32_t> cornerTexcoords;  ///< per corner: one of them or -1; empty when the file names none
  std::vector<std::int32_t> cornerNormals;    ///< per corner: one of them or -1; empty when the file names none
  std::vector<std::int64_t> vertexLines;      ///< 1-based line of each vertex; empty for files that have no lines
  std::vector<std::int64_t> faceLines;        ///< the same of each face
  std::vector<std::int64_t> creaseLines;      ///< the same of each of polygons.creases
  std::vector<std::int64_t> cornerLines;      ///< the same of each of polygons.corners

  /// x y z of vertex v.
  std::span<const double> position(std::int64_t v) const {
    return std::span<const double>(positions).subspan(static_cast<std::size_t>(3 * v), 3);
  }
};

}  // namespace honeycomb::Io
