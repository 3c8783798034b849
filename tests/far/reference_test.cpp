#include <gtest/gtest.h>

#include "tests/support/manifold_check.h"
#include "tests/support/mesh_compare.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

/// Both implementations, level by level.
void compareWithReference(const PolyMesh& mesh, const std::vector<std::size_t>& tags, const SchemeCase& scheme,
                          std::int32_t levels) {
  const Far::Refinement refinement = refined(mesh, scheme.scheme, levels, tags);
  ReferenceMesh reference = referenceStart(mesh, tags);
  for (std::int32_t k = 1; k <= levels; ++k) {
    reference = referenceZip(reference, scheme.reference);
    ASSERT_TRUE(isManifold(reference.mesh.faces));
    const MeshMatch match = matchMeshes(reference.mesh, levelMesh(refinement, k, mesh.points), 1e-11);
    ASSERT_TRUE(match.same) << scheme.name << ", level " << k << ": " << match.why;
  }
}

SchemeCase randomScheme(Random& random, ReferenceBoundary boundary) {
  const double t = random.chance(0.5) ? 0.5 : random.unit();
  const double s = random.chance(0.5) ? 0.25 : random.unit();
  switch (random.below(3)) {
    case 0:
      return schemeCase(NamedTension::paper, boundary, t, s);
    case 1:
      return schemeCase(NamedTension::sqrt3, boundary, t, s);
    default:
      return schemeCase(0.05 + 0.9 * random.unit(), boundary, t, s);
  }
}

void compareRandomMeshes(ReferenceBoundary boundary, bool corners) {
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomMesh random = randomMesh(seed);
    Random choice(seed + 1000);
    const std::int32_t levels = random.mesh.faces.size() < 40 ? 3 : 2;
    ASSERT_NO_FATAL_FAILURE(compareWithReference(random.mesh, corners ? random.cornerTags : std::vector<std::size_t>{},
                                                 randomScheme(choice, boundary), levels));
  }
}

TEST(ZipAgainstReference, BrickOnRandomMeshes) {
  compareRandomMeshes(ReferenceBoundary::brick, false);
}

TEST(ZipAgainstReference, BrickWithCornersOnRandomMeshes) {
  compareRandomMeshes(ReferenceBoundary::brick, true);
}

TEST(ZipAgainstReference, Eq16OnRandomMeshes) {
  compareRandomMeshes(ReferenceBoundary::eq16, false);
}

TEST(ZipAgainstReference, DropOnRandomMeshes) {
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomMesh random = randomMesh(seed);
    Random choice(seed + 2000);
    const SchemeCase scheme = randomScheme(choice, ReferenceBoundary::drop);
    std::int32_t levels = 0;
    ReferenceMesh reference = referenceStart(random.mesh, {});
    while (levels < 3 && !reference.mesh.faces.empty()) {
      reference = referenceZip(reference, scheme.reference);
      levels += reference.mesh.faces.empty() ? 0 : 1;
    }
    ASSERT_NO_FATAL_FAILURE(compareWithReference(random.mesh, {}, scheme, levels));
    compared += static_cast<std::uint64_t>(levels);
  }
  EXPECT_GT(compared, meshes(200) * 3 / 2);
}

TEST(ZipAgainstReference, LargeWholeFaces) {
  for (const std::size_t sides : {63U, 64U, 65U, 66U, 257U, 300U}) {
    SCOPED_TRACE(std::to_string(sides) + " sides");
    ASSERT_NO_FATAL_FAILURE(compareWithReference(prism(sides), {}, schemeCase(NamedTension::paper), 2));
    ASSERT_NO_FATAL_FAILURE(compareWithReference(wheel(sides), {}, schemeCase(NamedTension::sqrt3), 2));
  }
}

TEST(ZipAgainstReference, LargeHalfFaces) {
  // A boundary vertex of n faces becomes a half face of 2n + 2 sides, then one of 2n + 1, and so on.
  for (const std::size_t faces : {16U, 30U, 31U, 32U, 33U, 70U}) {
    SCOPED_TRACE(std::to_string(faces) + " faces");
    ASSERT_NO_FATAL_FAILURE(compareWithReference(fan(faces), {}, schemeCase(NamedTension::paper), 4));
    ASSERT_NO_FATAL_FAILURE(compareWithReference(fan(faces), {0}, schemeCase(NamedTension::paper), 4));
    ASSERT_NO_FATAL_FAILURE(compareWithReference(fan(faces), {}, schemeCase(0.7, ReferenceBoundary::brick, 0.3), 4));
  }
}

TEST(ZipAgainstReference, SmallestMeshes) {
  const PolyMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.25}}, {{0, 1, 2}}};
  for (const auto boundary : {ReferenceBoundary::brick, ReferenceBoundary::eq16}) {
    const SchemeCase scheme = schemeCase(NamedTension::paper, boundary);
    ASSERT_NO_FATAL_FAILURE(compareWithReference(triangle, {}, scheme, 4)) << scheme.name;
    ASSERT_NO_FATAL_FAILURE(compareWithReference(grid(1, 2), {}, scheme, 4)) << scheme.name;
    ASSERT_NO_FATAL_FAILURE(compareWithReference(pillow(3), {}, scheme, 3)) << scheme.name;
  }
  const SchemeCase brick = schemeCase(NamedTension::paper);
  ASSERT_NO_FATAL_FAILURE(compareWithReference(triangle, {0}, brick, 4));
  ASSERT_NO_FATAL_FAILURE(compareWithReference(triangle, {0, 1, 2}, brick, 4));
  ASSERT_NO_FATAL_FAILURE(compareWithReference(grid(2, 2), {0, 2, 6, 8}, brick, 4));
}

}  // namespace
}  // namespace honeycomb::Test
