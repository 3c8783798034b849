#pragma once

#include <string>
#include <vector>

#include "tests/support/poly_mesh.h"

namespace honeycomb::Test {

/// The half-box scheme on a clamped boundary as polygons, straight from its formulas, apart from the product's code.
/// Tags of faces: I inside, B (L, R, q_1 .. q_m), C (L, J, R, q_1 .. q_m), T (R_f, L_g, v).
struct ClampedMesh {
  PolyMesh mesh;
  std::string tags;
};

/// The clamped structure of an open three-valent mesh.
ClampedMesh referenceClamp(const PolyMesh& mesh);

/// One step; `smooth`: corners of four and more inside vertices have a tangent plane.
ClampedMesh referenceClampedStep(const ClampedMesh& mesh, bool smooth);

}  // namespace honeycomb::Test
