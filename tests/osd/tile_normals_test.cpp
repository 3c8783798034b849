#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "far/schemes/akleman.h"
#include "far/schemes/midpoint.h"
#include "far/schemes/trisect.h"
#include "far/tables/normal_rule.h"
#include "osd/tile_evaluator.h"
#include "tests/osd/tile_surface.h"
#include "tests/support/creased.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/refined.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

constexpr std::uint64_t kMeshesWithNormals = meshes(40);

template <class Real>
class TileNormals : public testing::Test {};

using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(TileNormals, Reals);

template <class Real>
void compare(const Far::Refinement& refinement, std::int32_t scratchPoints, std::uint64_t seed) {
  const std::vector<Real> control = randomControl<Real>(refinement, seed);
  for (const auto places : {Far::TilePlaces::faces, Far::TilePlaces::fours}) {
    const auto tiles = Far::buildTileTable(
        refinement, {.scratchPoints = scratchPoints, .normals = Far::TileNormalKind::fast, .places = places});
    ASSERT_TRUE(tiles.has_value()) << tiles.error().message;
    ASSERT_NO_FATAL_FAILURE(expectOfTiles(refinement, *tiles, control, levelByLevel(refinement, control)));
  }
}

TYPED_TEST(TileNormals, AreThoseOfTheLevelsOnRandomMeshes) {
  for (std::uint64_t seed = 0; seed < kMeshesWithNormals; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto scratch = static_cast<std::int32_t>(64 + 97 * seed % 2000);
    ASSERT_NO_FATAL_FAILURE(
        compare<TypeParam>(refined(randomMesh(seed), schemeCase(NamedTension::paper).scheme, 3), scratch, seed));
  }
}

TYPED_TEST(TileNormals, AreThoseOfTheLevelsUnderEveryScheme) {
  for (const PolyMesh& mesh : {torus(12, 9), grid(9, 11)}) {
    for (const ListedScheme& scheme : listedSchemes()) {
      SCOPED_TRACE(scheme.name);
      ASSERT_NO_FATAL_FAILURE(compare<TypeParam>(refinedBy(scheme, toTopology(mesh), 3), 600, 3));
    }
  }
}

TEST(TileNormal, IsTheSameByEverySetOfInstructions) {
  forEachTarget([] {
    ASSERT_NO_FATAL_FAILURE(compare<float>(refined(torus(12, 9), schemeCase(NamedTension::paper).scheme, 3), 600, 3));
  });
}

/// Vectors leave out the terms of weight 0, plain loops add them: that may change the sign of a zero alone.
TEST(TileNormal, OfAFlatMeshHasTheSameZeros) {
  const Far::Refinement refinement = refined(torus(12, 9), schemeCase(NamedTension::paper).scheme, 1);
  Random random(11);
  std::vector<float> control = randomControl<float>(refinement, 11);
  for (std::size_t z = 2; z < control.size(); z += 3) control[z] = random.symmetric() < 0 ? -0.0F : 0.0F;
  const auto tiles = Far::buildTileTable(refinement, {.normals = Far::TileNormalKind::fast});
  ASSERT_TRUE(tiles.has_value()) << tiles.error().message;
  ASSERT_NO_FATAL_FAILURE(expectOfTiles(refinement, *tiles, control, levelByLevel(refinement, control)));
}

TYPED_TEST(TileNormals, AreThoseOfTheLevelsWithCreases) {
  for (const CreasedMesh& mesh : creasedMeshes(1.5)) {
    const auto refinement = Far::refine(creased(mesh.mesh, mesh.creases), *Far::akleman(), 3);
    ASSERT_NO_FATAL_FAILURE(compare<TypeParam>(*refinement, 300, 4)) << mesh.name;
  }
}

TYPED_TEST(TileNormals, OfWhatIsTooLargeForTilesAreFoundForAllOfThem) {
  for (const PolyMesh& mesh : {prism(1000), pillow(300), wheel(700), fan(700)}) {
    ASSERT_NO_FATAL_FAILURE(compare<TypeParam>(refined(mesh, schemeCase(NamedTension::paper).scheme, 3), 1000, 5));
  }
  for (const ListedScheme& scheme : listedSchemes()) {
    SCOPED_TRACE(scheme.name);
    ASSERT_NO_FATAL_FAILURE(compare<TypeParam>(refinedBy(scheme, toTopology(prism(400)), 2), 1000, 6));
  }
}

TYPED_TEST(TileNormals, AreFoundWhereThereIsNoTile) {
  const Far::Refinement refinement = refined(pillow(300), schemeCase(NamedTension::paper).scheme, 1);
  ASSERT_TRUE(Far::buildTileTable(refinement)->tiles.empty());
  ASSERT_NO_FATAL_FAILURE(compare<TypeParam>(refinement, 1000, 7));
}

TYPED_TEST(TileNormals, CostLinearTimeAroundAVertexOfManyFaces) {
  // Every edge of the hub has a point of its own, beside all of the hub's faces.
  for (const auto& scheme : {Far::midpoint(), *Far::trisect()}) {
    const Far::Refinement refinement = refined(wheel(3000), scheme, 1);
    const auto table = Far::buildNormalTable(refinement, 1);
    EXPECT_LT(table->faces.size() / static_cast<std::size_t>(refinement.last().pointCount()), 80u);
    ASSERT_NO_FATAL_FAILURE(compare<TypeParam>(refinement, 1000, 8));
  }
}

double degreesBetween(const float* a, const Vec3& b) {
  const double dot = double{a[0]} * b[0] + double{a[1]} * b[1] + double{a[2]} * b[2];
  return std::acos(std::clamp(dot, -1.0, 1.0)) * 180 / std::numbers::pi;
}

TEST(TileNormal, IsWithinAHalfDegreeOfTheExactNormalOnAverage) {
  // A rough torus at level 4; the exact normal is that of the vertex's child face.
  PolyMesh mesh = torus(16, 12);
  Random random(9);
  for (Vec3& p : mesh.points) {
    for (double& x : p) x += 0.1 * random.symmetric();
  }
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 4, {}, true);
  const TileSurface<float> fast = levelByLevel(refinement, pack<float>(mesh.points));
  const Limits exact = vertexLimits<double>(refinement, levelPoints<double>(refinement, 4, mesh.points));
  double sum = 0;
  double worst = 0;
  for (std::size_t v = 0; v < exact.normals.size(); ++v) {
    const double angle = degreesBetween(fast.normals.data() + 3 * v, exact.normals[v]);
    sum += angle;
    worst = std::max(worst, angle);
  }
  EXPECT_LT(sum / static_cast<double>(exact.normals.size()), 1.0);
  EXPECT_LT(worst, 15.0);
}

/// What a closed mesh's tile writes is of faces whose corners its steps read: frames of their own have only those round
/// it.
TEST(TileNormal, OfATilesOwnFacesNeedsNoCornersOfItsOwn) {
  const Far::Refinement refinement = refined(torus(24, 20), schemeCase(NamedTension::paper).scheme, 3);
  const auto tiles = Far::buildTileTable(refinement, {.scratchPoints = 4000, .normals = Far::TileNormalKind::fast});
  ASSERT_TRUE(tiles.has_value()) << tiles.error().message;
  std::int32_t born = 0;
  for (std::size_t s = 0; s < tiles->steps.size(); ++s) {
    if (tiles->normals.born[s].firstNormal >= 0) born += tiles->steps[s].count;
  }
  EXPECT_EQ(born, refinement.level(2).topology.faceCount());
  std::int32_t framed = 0;
  for (const Far::TileFrames& frames : tiles->normals.frames) framed += frames.count;
  EXPECT_GT(framed, 0);
  EXPECT_LT(framed, born / 2);
}

TEST(TileNormal, IsRefusedWhereTheTilesHaveNone) {
  const Far::Refinement refinement = refined(cube(), schemeCase(NamedTension::paper).scheme, 2);
  const std::vector<float> control(24);
  TileSurface<float> surface = emptySurface<float>(refinement);
  Osd::TileEvaluator evaluator;
  const auto evaluate = [&](const Far::TileTable& tiles, std::int32_t level, std::size_t numbers) {
    return evaluator.evaluate<float>(refinement, tiles, level, {control, {}}, {surface.points, {}},
                                     {{std::span(surface.normals).first(numbers), {}}, {}});
  };
  const auto without = Far::buildTileTable(refinement);
  const auto with = Far::buildTileTable(refinement, {.normals = Far::TileNormalKind::fast});
  EXPECT_TRUE(evaluate(*with, 2, surface.normals.size()).has_value());
  EXPECT_FALSE(evaluate(*without, 2, surface.normals.size()).has_value());
  EXPECT_FALSE(evaluate(*with, 1, surface.normals.size()).has_value());
  EXPECT_FALSE(evaluate(*with, 2, surface.normals.size() - 1).has_value());
}

}  // namespace
}  // namespace honeycomb::Test
