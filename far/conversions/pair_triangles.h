#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/topology/polygons.h"

namespace honeycomb::Far {

/// Which two triangles may become a quad.
struct PairingLimits {
  double bend = 0.866;  ///< least cosine of the angle between their normals: 30 degrees
  double skew = 0.866;  ///< greatest |cosine| of a corner's angle: 30 to 150 degrees
};

/// Polygons some of whose triangles were joined to quads. Vertices are as before.
struct TrianglePairing {
  Polygons polygons;
  std::vector<std::int64_t> sourceCorners;  ///< per corner: which it was before
  std::vector<std::int64_t> sourceFaces;    ///< per face: the (lower) one it was
  std::int64_t quads = 0;                   ///< made
};

/// Undoes a triangulation: joins neighbouring triangles across their common edge, the squarest pairs first (by the
/// greatest |cosine| of their corners, then by the edge's lower corner), each triangle once. An edge stays where it is
/// creased, where the corners on either side of it have different `cornerKeys` (texture coordinates; empty: none),
/// where the quad would be bent, skewed or not convex, and where a vertex would be left with two edges inside the mesh.
/// The quad stands where the lower of its triangles stood. `positions`: x y z per vertex. Faces that are wrong stay as
/// they are. n log n.
TrianglePairing pairTriangles(const Polygons& polygons, std::span<const double> positions,
                              std::span<const std::int32_t> cornerKeys, const PairingLimits& limits = {});

}  // namespace honeycomb::Far
