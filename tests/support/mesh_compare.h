#pragma once

#include <string>
#include <vector>

#include "tests/support/poly_mesh.h"

namespace honeycomb::Test {

/// How one mesh lies on another that is the same up to numbering and rotation of the loops.
struct MeshMatch {
  bool same = false;
  std::string why;                     ///< what differs
  std::vector<std::size_t> vertexMap;  ///< vertex of a -> vertex of b
  std::vector<std::size_t> faceMap;    ///< face of a -> face of b
  double maxDistance = 0;              ///< largest distance of a vertex from its partner
};

/// Lays a on b, both manifolds: partners lie within `tolerance`, loops map onto loops with their orientation. Points
/// that coincide are told apart by walking over the edges from a first pair of corners.
MeshMatch matchMeshes(const PolyMesh& a, const PolyMesh& b, double tolerance);

}  // namespace honeycomb::Test
