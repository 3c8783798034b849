#pragma once

#include "far/conversions/conversion.h"
#include "tests/support/poly_mesh.h"

namespace honeycomb::Test {

/// The conversion's mesh, with the points carried over from the source's. Throws what an error says, which fails the
/// test.
PolyMesh converted(const Result<Far::Conversion>& conversion, const std::vector<Vec3>& points);

/// Three edges at each vertex; on a boundary two or three.
bool isThreeValent(const PolyMesh& mesh);

}  // namespace honeycomb::Test
