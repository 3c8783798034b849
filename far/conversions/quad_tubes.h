#pragma once

#include <cstdint>
#include <vector>

#include "far/conversions/conversion_parts.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// Quads in closed rings, one ring upon the other, between two caps. Column i, line r:
///     line 2   ---+---------+---------+---   rim, bounded by a cap
///                 |  ring 1 |         |
///     line 1   ---+---------+---------+---   four quads at each of its vertices
///                 |  ring 0 |         |
///     line 0   ---+---------+---------+---   rim, bounded by a cap
///            column 0       1         2 .. and round to column 0
struct QuadTube {
  std::int32_t columns = 0;
  std::int32_t rings = 0;
  std::vector<std::int32_t> vertices;  ///< line by line: (rings + 1) x columns
  std::vector<std::int32_t> faces;     ///< the topology's, ring by ring; face i is between columns i and i + 1

  std::int32_t vertex(std::int32_t line, std::int32_t column) const {
    return vertices[static_cast<std::size_t>(line * columns + column % columns)];
  }
  std::int32_t face(std::int32_t ring, std::int32_t column) const {
    return faces[static_cast<std::size_t>(ring * columns + column % columns)];
  }
};

/// The tubes of a mesh, no two with a face in common: where they cross, as on a cube, that of the face with the lowest
/// caller's number, and there the one with the face's first edge on a rim. A rim is capped by one polygon, by faces
/// that aren't quads, or by nothing (a boundary). A vertex may be in a tube only once. Linear in the quads.
std::vector<QuadTube> findQuadTubes(const Topology& topology, const CallerFaces& faces);

}  // namespace honeycomb::Far
