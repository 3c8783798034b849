#include <gtest/gtest.h>

#include <set>

#include "tests/support/golden.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

const std::vector<std::string>& closedShapes() {
  static const std::vector<std::string> shapes = {"tetrahedron", "cube", "dodecahedron", "hexprism", "torus", "mixed"};
  return shapes;
}

std::int32_t nonHexagons(const Far::Topology& t) {
  std::int32_t count = 0;
  for (std::int32_t f = 0; f < t.faceCount(); ++f) count += t.sides(f) == 6 ? 0 : 1;
  return count;
}

std::int32_t irregularVertices(const Far::Topology& t) {
  std::int32_t count = 0;
  for (std::int32_t v = 0; v < t.vertexCount(); ++v) count += t.valence(v) == 3 ? 0 : 1;
  return count;
}

void checkClosedCounts(const Far::Refinement& refinement) {
  const std::int32_t irregular =
      nonHexagons(refinement.level(0).topology) + irregularVertices(refinement.level(0).topology);
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
    const Far::Topology& before = refinement.level(k - 1).topology;
    const Far::Topology& after = refinement.level(k).topology;
    ASSERT_EQ(after.vertexCount(), 2 * before.edgeCount());
    ASSERT_EQ(after.edgeCount(), 3 * before.edgeCount());
    ASSERT_EQ(after.faceCount(), before.faceCount() + before.vertexCount());
    ASSERT_EQ(after.halfEdgeCount(), 3 * before.halfEdgeCount());
    ASSERT_EQ(after.eulerCharacteristic(), before.eulerCharacteristic());
    ASSERT_EQ(irregularVertices(after), 0);
    ASSERT_EQ(nonHexagons(after), irregular);
  }
}

TEST(Counts, OfClosedGoldenShapesFollowTheFormulas) {
  for (const std::string& shape : closedShapes()) {
    SCOPED_TRACE(shape);
    ASSERT_NO_FATAL_FAILURE(
        checkClosedCounts(refined(readGoldenMesh(shape + ".obj"), schemeCase(NamedTension::paper).scheme, 4)));
  }
}

TEST(Counts, OfClosedRandomMeshesFollowTheFormulas) {
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_NO_FATAL_FAILURE(
        checkClosedCounts(refined(randomMesh(seed, Border::closed), schemeCase(NamedTension::paper).scheme, 3)));
  }
}

TEST(Counts, EulersCharacteristicIsConstantOnOpenMeshes) {
  for (const auto boundary : {ReferenceBoundary::brick, ReferenceBoundary::eq16}) {
    const SchemeCase scheme = schemeCase(NamedTension::paper, boundary);
    for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
      const Far::Refinement refinement = refined(randomMesh(seed, Border::open), scheme.scheme, 3);
      for (std::int32_t k = 1; k <= 3; ++k) {
        ASSERT_EQ(refinement.level(k).topology.eulerCharacteristic(),
                  refinement.level(0).topology.eulerCharacteristic())
            << scheme.name << ", seed " << seed << ", level " << k;
      }
    }
  }
}

TEST(Counts, BrickMakesEveryVertexThreeValent) {
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    const RandomMesh random = randomMesh(seed, Border::open);
    const Far::Refinement refinement = refined(random.mesh, schemeCase(NamedTension::paper).scheme, 3);
    for (std::int32_t k = 1; k <= 3; ++k) {
      ASSERT_EQ(irregularVertices(refinement.level(k).topology), 0) << "seed " << seed << ", level " << k;
    }
  }
}

TEST(Counts, BrickBoundaryGrowsByOneTwoThreeHalvesTwo) {
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    const RandomMesh random = randomMesh(seed, Border::open);
    const Far::Refinement refinement = refined(random.mesh, schemeCase(NamedTension::paper).scheme, 4);
    const std::int32_t edges = refinement.level(0).topology.boundaryEdgeCount();
    ASSERT_GT(edges, 0);
    const std::vector<std::int32_t> factors = {1, 1, 2, 3, 6};
    for (std::int32_t k = 0; k <= 4; ++k) {
      ASSERT_EQ(refinement.level(k).topology.boundaryEdgeCount(), at(factors, k) * edges)
          << "seed " << seed << ", level " << k;
    }
  }
}

TEST(Counts, Eq16BoundaryOfTheHoneycombGrowsLikeFibonacciNumbers) {
  const SchemeCase scheme = schemeCase(NamedTension::paper, ReferenceBoundary::eq16);
  const Far::Refinement refinement = refined(readGoldenMesh("grid.obj"), scheme.scheme, 5);
  const std::vector<std::int32_t> expected = {18, 32, 50, 82, 132, 214};
  for (std::int32_t k = 0; k <= 5; ++k) {
    EXPECT_EQ(refinement.level(k).topology.boundaryEdgeCount(), at(expected, k)) << "level " << k;
  }
}

TEST(Counts, DodecahedronBecomesASoccerBall) {
  const Far::Refinement refinement = refined(dodecahedron(), schemeCase(NamedTension::paper).scheme, 1);
  const Far::Topology& ball = refinement.level(1).topology;
  EXPECT_EQ(ball.vertexCount(), 60);
  EXPECT_EQ(ball.edgeCount(), 90);
  EXPECT_EQ(ball.faceCount(), 32);
  std::int32_t pentagons = 0;
  for (std::int32_t f = 0; f < ball.faceCount(); ++f) pentagons += ball.sides(f) == 5 ? 1 : 0;
  EXPECT_EQ(pentagons, 12);
  EXPECT_EQ(nonHexagons(ball), 12);
  for (std::int32_t h = 0; h < ball.halfEdgeCount(); ++h) {
    if (ball.sides(ball.face(h)) != 5) continue;
    EXPECT_EQ(ball.sides(ball.face(ball.twin(h))), 6) << "a pentagon touches a pentagon at half-edge " << h;
  }
}

TEST(Counts, FaceRatioOfTheDodecahedronTendsToThree) {
  const Far::Refinement refinement = refined(dodecahedron(), schemeCase(NamedTension::paper).scheme, 6);
  const std::vector<double> expected = {2.6667, 2.8750, 2.9565, 2.9853, 2.9951, 2.9984};
  for (std::int32_t k = 1; k <= 6; ++k) {
    const double ratio = static_cast<double>(refinement.level(k).topology.faceCount()) /
                         static_cast<double>(refinement.level(k - 1).topology.faceCount());
    EXPECT_NEAR(ratio, at(expected, k - 1), 5e-5);
  }
}

}  // namespace
}  // namespace honeycomb::Test
