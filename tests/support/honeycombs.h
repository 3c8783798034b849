#pragma once

#include <cstdint>
#include <vector>

#include "tests/support/poly_mesh.h"

namespace honeycomb::Test {

/// Pieces of the planar honeycomb of regular hexagons with edges of length 1, open: a disc, a triangle, a
/// parallelogram, a disc with a hole, an L and a strip. Boundary hexagons have one to four vertices inside.
std::vector<PolyMesh> honeycombPatches();

/// An open three-valent mesh with a face (the first) of n sides whose m vertices inside stand in a row, n > m + 1, and
/// the faces round it; points at random.
PolyMesh flower(std::size_t m, std::size_t n);

/// The same open three-valent mesh for the same seed: a honeycomb step of a random mesh with some faces taken out, so
/// that faces have any number of vertices inside, in one row or several, or none.
PolyMesh randomThreeValent(std::uint64_t seed);

}  // namespace honeycomb::Test
