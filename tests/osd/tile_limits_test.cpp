#include <gtest/gtest.h>

#include "far/schemes/akleman.h"
#include "far/schemes/half_box.h"
#include "far/schemes/zhang_wang.h"
#include "osd/tile_evaluator.h"
#include "tests/osd/tile_surface.h"
#include "tests/support/creased.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/must.h"
#include "tests/support/refined.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

using Far::TileNormalKind;
using Far::TileOrder;

constexpr std::uint64_t kMeshesWithLimits = meshes(40);

template <class Real>
class TileLimits : public testing::Test {};

using LimitReals = testing::Types<float, double>;
TYPED_TEST_SUITE(TileLimits, LimitReals);

/// The same surface with point i where the tiles write it.
template <class Real>
TileSurface<Real> inOrderOf(const Far::TileTable& tiles, const TileSurface<Real>& surface) {
  TileSurface<Real> ordered = surface;
  for (std::size_t i = 0; i < tiles.written.size(); ++i) {
    const auto from = 3 * static_cast<std::ptrdiff_t>(tiles.written[i]);
    std::copy_n(surface.points.begin() + from, 3, ordered.points.begin() + 3 * static_cast<std::ptrdiff_t>(i));
    std::copy_n(surface.normals.begin() + from, 3, ordered.normals.begin() + 3 * static_cast<std::ptrdiff_t>(i));
  }
  return ordered;
}

template <class Real>
void compareLimits(const Far::Refinement& refinement, std::int32_t scratchPoints, std::uint64_t seed) {
  const std::vector<Real> control = randomControl<Real>(refinement, seed);
  const TileSurface<Real> expected = withLimits(refinement, control);
  for (const auto& [order, places] :
       {std::pair(TileOrder::levels, Far::TilePlaces::faces), std::pair(TileOrder::levels, Far::TilePlaces::fours),
        std::pair(TileOrder::tiles, Far::TilePlaces::fours)}) {
    SCOPED_TRACE(std::string(order == TileOrder::tiles ? "tile" : "level") + " order, " +
                 (places == Far::TilePlaces::fours ? "fours" : "faces"));
    const auto tiles = Far::buildTileTable(
        refinement,
        {.scratchPoints = scratchPoints, .order = order, .normals = TileNormalKind::exact, .places = places});
    ASSERT_TRUE(tiles.has_value()) << tiles.error().message;
    ASSERT_NO_FATAL_FAILURE(expectOfTiles(refinement, *tiles, control, inOrderOf(*tiles, expected)));
  }
}

TYPED_TEST(TileLimits, AreThoseOfTheChainOnRandomMeshes) {
  for (std::uint64_t seed = 0; seed < kMeshesWithLimits; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto scratch = static_cast<std::int32_t>(64 + 397 * seed % 6000);
    const Far::Refinement refinement = refined(randomMesh(seed), schemeCase(NamedTension::paper).scheme, 3, true);
    ASSERT_NO_FATAL_FAILURE(compareLimits<TypeParam>(refinement, scratch, seed));
  }
}

TYPED_TEST(TileLimits, AreThoseOfTheChainUnderEveryScheme) {
  for (const PolyMesh& mesh : {torus(12, 9), grid(9, 11)}) {
    for (const ListedScheme& scheme : listedSchemes()) {
      for (const std::int32_t levels : {1, 3}) {
        SCOPED_TRACE(scheme.name + ", levels " + std::to_string(levels));
        ASSERT_NO_FATAL_FAILURE(compareLimits<TypeParam>(refinedBy(scheme, toTopology(mesh), levels, true), 1500, 3));
      }
    }
  }
}

Far::TileTable exactTiles(const Far::Refinement& refinement, Far::TilePlaces places) {
  return must(
      Far::buildTileTable(refinement, {.scratchPoints = 4000, .normals = TileNormalKind::exact, .places = places}));
}

TEST(TileLimit, IsFoundGoingRoundFacesWhereTheyAreClosed) {
  for (const PolyMesh& mesh : {torus(12, 9), cube(), dodecahedron()}) {
    const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 3, {}, true);
    const Far::TileTable tiles = exactTiles(refinement, Far::TilePlaces::fours);
    EXPECT_EQ(std::ssize(tiles.limits.windows), refinement.last().topology.vertexCount());
    EXPECT_TRUE(tiles.limits.frames.empty());
    EXPECT_TRUE(exactTiles(refinement, Far::TilePlaces::faces).limits.rings.empty());
  }
}

TEST(TileLimit, IsFoundGoingRoundTheFacesThatAreFarFromABoundary) {
  const Far::Refinement refinement = refined(grid(12, 12), schemeCase(NamedTension::paper).scheme, 3, {}, true);
  const Far::TileTable tiles = exactTiles(refinement, Far::TilePlaces::fours);
  EXPECT_GT(std::ssize(tiles.limits.windows), refinement.last().topology.vertexCount() / 2);
  EXPECT_FALSE(tiles.limits.frames.empty());
}

TEST(TileLimit, IsTheSameByEverySetOfInstructions) {
  forEachTarget([] {
    ASSERT_NO_FATAL_FAILURE(
        compareLimits<float>(refined(torus(12, 9), schemeCase(NamedTension::paper).scheme, 2, {}, true), 1500, 3));
  });
}

TYPED_TEST(TileLimits, AreThoseOfTheChainWithCreases) {
  for (const CreasedMesh& mesh : creasedMeshes(1.5)) {
    const auto refinement = Far::refine(creased(mesh.mesh, mesh.creases), *Far::akleman(), 3, {.limits = true});
    ASSERT_NO_FATAL_FAILURE(compareLimits<TypeParam>(*refinement, 900, 4)) << mesh.name;
  }
}

// Four vertices are written together, the second of which does not stand behind the first.
TEST(TileLimit, GoesToItsVertexWhereThoseOfAGroupDoNotAscend) {
  const RandomMesh mesh = randomMesh(104);
  Random choice(104);
  const Far::Topology control = randomlyCreased(mesh, choice, {0.5, 1.25, 2, Far::kSharp});
  Far::ZhangWangOptions options;
  options.pull.rule = Far::CentralPull::Rule::kobbelt;
  options.vertexPull = 0.25;
  options.boundary = Far::BoundaryRule::brick;
  compareLimits<float>(refinedBy(control, must(Far::zhangWang(control, 2, options)), true), 165, 1);
}

TYPED_TEST(TileLimits, OfWhatIsTooLargeForTilesAreFoundForAllOfThem) {
  for (const PolyMesh& mesh : {prism(1000), pillow(300), wheel(700), fan(700)}) {
    const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 2, {}, true);
    ASSERT_NO_FATAL_FAILURE(compareLimits<TypeParam>(refinement, 1000, 5));
  }
  for (const ListedScheme& scheme : listedSchemes()) {
    SCOPED_TRACE(scheme.name);
    ASSERT_NO_FATAL_FAILURE(compareLimits<TypeParam>(refinedBy(scheme, toTopology(prism(400)), 2, true), 1000, 6));
  }
}

TYPED_TEST(TileLimits, AreFoundWhereThereIsNoTile) {
  const Far::Refinement refinement = refined(pillow(300), schemeCase(NamedTension::paper).scheme, 1, {}, true);
  ASSERT_TRUE(Far::buildTileTable(refinement)->tiles.empty());
  ASSERT_NO_FATAL_FAILURE(compareLimits<TypeParam>(refinement, 1000, 7));
}

TYPED_TEST(TileLimits, OfChosenTilesAloneAreWritten) {
  using Real = TypeParam;
  const Far::Refinement refinement = refined(grid(20, 20), schemeCase(NamedTension::paper).scheme, 3, {}, true);
  const auto tiles = Far::buildTileTable(refinement, {.scratchPoints = 1500, .normals = TileNormalKind::exact});
  ASSERT_GT(tiles->tiles.size(), 4u);
  const std::vector<Real> control = randomControl<Real>(refinement, 8);
  const TileSurface<Real> expected = withLimits(refinement, control);
  const std::vector<std::int32_t> chosen{1, 3};
  TileSurface<Real> surface = emptySurface<Real>(refinement);
  Osd::TileEvaluator evaluator;
  ASSERT_TRUE(evaluator.evaluate(refinement, *tiles, 3, Osd::Points<Real>{control, {}},
                                 Osd::PointsOut<Real>{surface.points, {}},
                                 Osd::TileRequest<Real>{Osd::PointsOut<Real>{surface.normals, {}}, chosen}));
  std::size_t written = 0;
  for (std::size_t i = 0; i < surface.normals.size(); i += 3) {
    // A point and its normal are written together, or neither is.
    const bool here = surface.points[i] != Real{7};
    const std::span<const Real> normal = std::span(surface.normals).subspan(i, 3);
    const std::vector<Real> wanted =
        here ? std::vector<Real>(expected.normals.begin() + static_cast<std::ptrdiff_t>(i),
                                 expected.normals.begin() + static_cast<std::ptrdiff_t>(i) + 3)
             : std::vector<Real>(3, Real{7});
    ASSERT_TRUE(std::equal(normal.begin(), normal.end(), wanted.begin())) << "point " << i / 3;
    written += here ? 1 : 0;
  }
  EXPECT_GT(written, 0u);
  EXPECT_LT(written, surface.normals.size() / 6);
}

TEST(TileLimit, TablesGivePointsOfAnyLevelWithoutNormals) {
  const Far::Refinement refinement = refined(torus(10, 9), schemeCase(NamedTension::paper).scheme, 3, {}, true);
  const auto tiles = Far::buildTileTable(refinement, {.scratchPoints = 2000, .normals = TileNormalKind::exact});
  const std::vector<float> control = randomControl<float>(refinement, 9);
  for (std::int32_t level = 1; level <= 3; ++level) {
    std::vector<float> expected(3 * static_cast<std::size_t>(refinement.level(level).pointCount()));
    std::vector<float> points(expected.size());
    ASSERT_TRUE(Osd::SerialEvaluator().evaluate<float>(refinement, level, {control, {}}, {expected, {}}));
    Osd::TileEvaluator evaluator;
    ASSERT_TRUE(evaluator.evaluate<float>(refinement, *tiles, level, {control, {}}, {points, {}}));
    EXPECT_TRUE(sameBits(points, expected)) << "level " << level;
  }
}

TEST(TileLimit, IsRefusedWhereThereAreNoLimits) {
  const Far::Refinement without = refined(cube(), schemeCase(NamedTension::paper).scheme, 2);
  EXPECT_FALSE(Far::buildTileTable(without, {.normals = TileNormalKind::exact}).has_value());
  const Far::Refinement with = refined(cube(), schemeCase(NamedTension::paper).scheme, 2, {}, true);
  EXPECT_TRUE(Far::buildTileTable(with, {.normals = TileNormalKind::exact}).has_value());
  EXPECT_FALSE(Far::buildTileTable(with, {.level = 1, .normals = TileNormalKind::exact}).has_value());
}

}  // namespace
}  // namespace honeycomb::Test
