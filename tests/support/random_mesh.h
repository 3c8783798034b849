#pragma once

#include <cstdint>
#include <vector>

#include "tests/support/poly_mesh.h"
#include "tests/support/random.h"

namespace honeycomb::Test {

enum class Border { closed, open };

/// A random oriented manifold and, when open, some of its boundary vertices to be tagged as corners.
struct RandomMesh {
  PolyMesh mesh;
  std::vector<std::size_t> cornerTags;
};

/// The same mesh for the same seed, everywhere: one to three components, sphere-like or with handles, faces of 3 to 64
/// sides, vertices of valence 2 and up, shuffled numbers, random positions in the cube [-1,1]^3.
/// Every component of an open mesh has a boundary; a closed mesh has none.
RandomMesh randomMesh(std::uint64_t seed, Border border);

/// How many random meshes (or sides of a face) a test takes that wants `count`: sanitizers slow it down several times,
/// and get an eighth.
constexpr std::uint64_t meshes(std::uint64_t count) {
#ifdef HONEYCOMB_SANITIZED
  return (count + 7) / 8;
#else
  return count;
#endif
}

/// Seeds with an even index are closed meshes, odd ones open.
inline Border borderOf(std::uint64_t seed) {
  return seed % 2 == 0 ? Border::closed : Border::open;
}
inline RandomMesh randomMesh(std::uint64_t seed) {
  return randomMesh(seed, borderOf(seed));
}

}  // namespace honeycomb::Test
