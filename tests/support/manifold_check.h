#pragma once

#include <string>
#include <vector>

#include "tests/support/poly_mesh.h"

namespace honeycomb::Test {

/// Are the loops an oriented manifold, possibly with boundary? A slow check with maps, apart from the product's own.
/// Vertices that no face uses don't matter. `why`, where given, receives the reason.
bool isManifold(const std::vector<Loop>& faces, std::string* why = nullptr);

/// V - E + F, with the vertices that faces use.
std::int64_t eulerCharacteristic(const std::vector<Loop>& faces);

/// Directed edges without an opposite one.
std::size_t boundaryEdgeCount(const std::vector<Loop>& faces);

}  // namespace honeycomb::Test
