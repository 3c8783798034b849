#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "far/base/parallel.h"
#include "far/schemes/akleman.h"
#include "far/tables/tile_table.h"
#include "osd/cpu_evaluator.h"
#include "osd/tile_evaluator.h"
#include "tests/support/creased.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/must.h"
#include "tests/support/refined.h"
#include "tests/support/same_bits.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

using Instructions = Osd::CpuEvaluator::Instructions;

constexpr std::uint64_t kTiledMeshes = meshes(40);

template <class Real>
class Tiles : public testing::Test {};

using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Tiles, Reals);

template <class Real>
constexpr Real kUntouched = static_cast<Real>(-12345.5);

Far::TileTable tiled(const Far::Refinement& refinement, std::int32_t scratchPoints,
                     Far::TileOrder order = Far::TileOrder::levels, std::int32_t level = 0,
                     Far::TilePlaces places = Far::TilePlaces::faces) {
  auto tiles = Far::buildTileTable(refinement,
                                   {.level = level, .scratchPoints = scratchPoints, .order = order, .places = places});
  EXPECT_TRUE(tiles.has_value()) << (tiles ? "" : tiles.error().message);
  return std::move(*tiles);
}

template <class Real>
std::vector<Real> randomNumbers(std::int64_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Real> numbers(static_cast<std::size_t>(count));
  for (Real& x : numbers) x = static_cast<Real>(random.symmetric());
  return numbers;
}

/// Buffers of exactly the numbers the descriptors need, so that a sanitizer sees any step outside.
template <class Real>
struct Case {
  const Far::Refinement& refinement;
  Osd::BufferDescriptor in, out;
  std::vector<Real> control = randomNumbers<Real>(in.extent(refinement.level(0).pointCount()), 7);

  std::vector<Real> fresh(std::int32_t level) const {
    return std::vector<Real>(static_cast<std::size_t>(out.extent(refinement.level(level).pointCount())),
                             kUntouched<Real>);
  }
  std::vector<Real> chained(std::int32_t level) const {
    std::vector<Real> target = fresh(level);
    Osd::SerialEvaluator serial;
    EXPECT_TRUE(serial.evaluate(refinement, level, Osd::Points<Real>{control, in}, Osd::PointsOut<Real>{target, out}));
    return target;
  }
  std::vector<Real> byTiles(Osd::TileEvaluator& evaluator, const Far::TileTable& tiles, std::int32_t level,
                            std::optional<std::span<const std::int32_t>> only = {}) const {
    std::vector<Real> target = fresh(level);
    const auto done = evaluator.evaluate(refinement, tiles, level, Osd::Points<Real>{control, in},
                                         Osd::PointsOut<Real>{target, out}, Osd::TileRequest<Real>{{}, only});
    EXPECT_TRUE(done.has_value()) << (done ? "" : done.error().message);
    return target;
  }
};

/// Plain loops, vectors, and vectors that stream past the caches.
std::vector<Osd::TileEvaluatorOptions> allKinds(Osd::CpuEvaluator::Threads threads) {
  constexpr std::int64_t kNever = std::int64_t{1} << 60;
  return {{threads, Instructions::plain, kNever},
          {threads, Instructions::vectors, kNever},
          {threads, Instructions::vectors, 0}};
}

template <class Real>
void compareAllLevels(const Far::Refinement& refinement, std::int32_t scratchPoints, Random& random) {
  const Far::TileTable tilings[] = {
      tiled(refinement, scratchPoints),
      tiled(refinement, scratchPoints, Far::TileOrder::levels, 0, Far::TilePlaces::fours)};
  const auto length = static_cast<std::int32_t>(random.between(1, 5));
  const auto gap = [&] { return static_cast<std::int32_t>(random.chance(0.5) ? 0 : random.below(3)); };
  const Case<Real> test{refinement,
                        {static_cast<std::int32_t>(random.below(4)), length, length + gap()},
                        {static_cast<std::int32_t>(random.below(4)), length, length + gap()}};
  for (const Osd::TileEvaluatorOptions& options : allKinds(Osd::CpuEvaluator::Threads::one)) {
    Osd::TileEvaluator evaluator(options);
    for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
      const std::vector<Real> expected = test.chained(k);
      for (const Far::TileTable& tiles : tilings) {
        ASSERT_TRUE(sameBits(test.byTiles(evaluator, tiles, k), expected))
            << "level " << k << ", length " << length << ", vectors " << (options.instructions == Instructions::vectors)
            << ", streamed from " << options.streamedBytes << ", fours " << (tiles.places == Far::TilePlaces::fours);
      }
    }
  }
}

TYPED_TEST(Tiles, GiveTheBitsOfTheChainOnRandomMeshes) {
  for (std::uint64_t seed = 0; seed < kTiledMeshes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const RandomMesh mesh = randomMesh(seed);
    const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 3);
    const auto scratch = static_cast<std::int32_t>(random.between(64, 2000));
    ASSERT_NO_FATAL_FAILURE(compareAllLevels<TypeParam>(refinement, scratch, random));
  }
}

TYPED_TEST(Tiles, GiveTheBitsOfTheChainUnderEveryScheme) {
  Random random(5);
  for (const PolyMesh& mesh : {torus(12, 9), grid(9, 11)}) {
    for (const ListedScheme& scheme : listedSchemes()) {
      SCOPED_TRACE(scheme.name);
      ASSERT_NO_FATAL_FAILURE(compareAllLevels<TypeParam>(refinedBy(scheme, toTopology(mesh), 3), 600, random));
    }
  }
}

TEST(Tile, GivesTheBitsOfTheChainByEverySetOfInstructions) {
  Random random(11);
  const Far::Refinement quads = refined(torus(12, 9), schemeCase(NamedTension::paper).scheme, 3);
  const Far::Refinement mixed = refined(randomMesh(3), schemeCase(NamedTension::paper).scheme, 3);
  forEachTarget([&] {
    for (int buffers = 0; buffers < 8; ++buffers) {
      ASSERT_NO_FATAL_FAILURE(compareAllLevels<float>(quads, 600, random));
      ASSERT_NO_FATAL_FAILURE(compareAllLevels<float>(mixed, 600, random));
    }
  });
}

TYPED_TEST(Tiles, GiveTheBitsOfTheChainWithCreases) {
  Random random(6);
  for (const double sharpness : {1.5, 10.0}) {
    for (const CreasedMesh& mesh : creasedMeshes(sharpness)) {
      const auto refinement = Far::refine(creased(mesh.mesh, mesh.creases), *Far::akleman(), 3);
      ASSERT_TRUE(refinement.has_value());
      ASSERT_NO_FATAL_FAILURE(compareAllLevels<TypeParam>(*refinement, 300, random)) << mesh.name;
    }
  }
}

TYPED_TEST(Tiles, LeaveWhatIsTooLargeToAllOfThem) {
  // A face of 4,096 sides beside another, a vertex with 2,000 faces, a boundary vertex with 700: alone on their mesh.
  Random random(8);
  for (const PolyMesh& mesh : {prism(4096), pillow(300), wheel(2000), fan(700)}) {
    const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 3);
    const Far::TileTable tiles = tiled(refinement, 1000);
    EXPECT_FALSE(tiles.shared.empty());
    EXPECT_LE(tiles.largestTile, 4000) << "tiles hold more than they were meant to";
    ASSERT_NO_FATAL_FAILURE(compareAllLevels<TypeParam>(refinement, 1000, random));
  }
}

TYPED_TEST(Tiles, GiveTheBitsOfTheChainWhereRowsReadTheSumsOfLargeFaces) {
  Random random(9);
  for (const PolyMesh& mesh : {prism(500), pillow(100)}) {
    for (const ListedScheme& scheme : listedSchemes()) {
      if (!scheme.name.starts_with("zhang-wang")) continue;
      SCOPED_TRACE(scheme.name);
      const Far::Refinement refinement = refinedBy(scheme, toTopology(mesh), 3);
      ASSERT_GT(refinement.level(1).table.summed.rowCount(), 0);
      ASSERT_NO_FATAL_FAILURE(compareAllLevels<TypeParam>(refinement, 600, random));
    }
  }
}

TYPED_TEST(Tiles, GiveTheBitsOfTheChainWhereManyCreasesEndAtALargeFace) {
  Random random(10);
  for (const CreasedMesh& c : meetingCreases(100, 1.5)) {
    const Far::Refinement refinement = Far::refine(creased(c.mesh, c.creases), *Far::akleman(), 3).value();
    ASSERT_GT(refinement.level(1).table.summed.rowCount() + refinement.level(2).table.summed.rowCount(), 0);
    ASSERT_NO_FATAL_FAILURE(compareAllLevels<TypeParam>(refinement, 600, random)) << c.name;
  }
}

TYPED_TEST(Tiles, AreTheSameOnAnyNumberOfThreads) {
  const PolyMesh mesh = torus(50, 40);
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 3);
  const Far::TileTable tiles = tiled(refinement, 2000);
  {
    const Parallel::ThreadLimit limit(1);
    const Far::TileTable alone = tiled(refinement, 2000);
    EXPECT_EQ(alone.indices, tiles.indices);
    EXPECT_EQ(alone.imports, tiles.imports);
    EXPECT_EQ(alone.outputs, tiles.outputs);
  }
  const Case<TypeParam> test{refinement, {0, 3, 3}, {0, 3, 3}};
  const std::vector<TypeParam> expected = test.chained(3);
  for (const Osd::TileEvaluatorOptions& options : allKinds(Osd::CpuEvaluator::Threads::all)) {
    Osd::TileEvaluator evaluator(options);
    for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(sameBits(test.byTiles(evaluator, tiles, 3), expected));
  }
}

TYPED_TEST(Tiles, InTheirOwnOrderWriteEachPointOnce) {
  for (const PolyMesh& mesh : {torus(20, 15), prism(500), grid(12, 13)}) {
    const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 3);
    const Far::TileTable tiles = tiled(refinement, 1500, Far::TileOrder::tiles);
    std::vector<std::int32_t> all(tiles.written.begin(), tiles.written.end());
    std::ranges::sort(all);
    std::vector<std::int32_t> each(static_cast<std::size_t>(refinement.last().pointCount()));
    std::iota(each.begin(), each.end(), 0);
    ASSERT_EQ(all, each);
    const Case<TypeParam> test{refinement, {0, 3, 3}, {0, 3, 3}};
    const std::vector<TypeParam> chained = test.chained(3);
    std::vector<TypeParam> expected(chained.size());
    for (std::size_t i = 0; i < tiles.written.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        expected[3 * i + c] = chained[3 * static_cast<std::size_t>(tiles.written[i]) + c];
      }
    }
    for (const Osd::TileEvaluatorOptions& options : allKinds(Osd::CpuEvaluator::Threads::one)) {
      Osd::TileEvaluator evaluator(options);
      EXPECT_TRUE(sameBits(test.byTiles(evaluator, tiles, 3), expected));
    }
  }
}

TYPED_TEST(Tiles, GiveTheChosenPointsAndTouchNoOthers) {
  const Far::Refinement refinement = refined(torus(30, 20), schemeCase(NamedTension::paper).scheme, 3);
  const Far::TileTable tiles = tiled(refinement, 800);
  ASSERT_GT(tiles.tiles.size(), 10u);
  const Case<TypeParam> test{refinement, {0, 3, 3}, {0, 3, 3}};
  for (const std::int32_t level : {2, 3}) {
    const std::vector<TypeParam> whole = test.chained(level);
    const std::vector<std::int32_t> wanted = {0, 17, 55};
    const std::vector<std::int32_t> chosen = tiles.tilesOf(level, wanted);
    ASSERT_LE(chosen.size(), wanted.size());
    Osd::TileEvaluator evaluator;
    const std::vector<TypeParam> some = test.byTiles(evaluator, tiles, level, chosen);
    for (const std::int32_t point : wanted) {
      for (std::int32_t c = 0; c < 3; ++c) EXPECT_EQ(at(some, 3 * point + c), at(whole, 3 * point + c));
    }
    std::size_t touched = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (some[i] == kUntouched<TypeParam>) continue;
      ++touched;
      ASSERT_EQ(some[i], whole[i]);
    }
    EXPECT_LT(touched, whole.size() / 3) << "a few tiles cost as much as all";
  }
  Osd::TileEvaluator evaluator;
  const std::vector<TypeParam> none = test.byTiles(evaluator, tiles, 3, std::span<const std::int32_t>{});
  EXPECT_TRUE(sameBits(none, test.fresh(3)));
}

TYPED_TEST(Tiles, MakeAllPointsOfATableThatMakesMoreThanItsLevelHasVertices) {
  // As a tessellation's, whose tangents stand behind its points: here each point a second time.
  const Far::Refinement first = refined(torus(8, 7), schemeCase(NamedTension::paper).scheme, 1);
  Far::Level level{first.last().topology, {}};
  const std::int32_t count = first.last().pointCount();
  level.table.sourceCount = count;
  level.table.targetCount = 2 * count;
  level.table.dense = {{1, count, 0, 0, 0}, {1, count, 0, count, 0}};
  for (std::int32_t i = 0; i < count; ++i) level.table.indices.edit().push_back(i);
  level.table.weights = {1};
  level.table.weightsSingle = {1};
  const Far::Refinement refinement = Far::Refinement(first).followedBy(std::move(level));
  const Far::TileTable tiles = tiled(refinement, 300);
  const std::vector<TypeParam> control = randomNumbers<TypeParam>(3 * refinement.level(0).pointCount(), 9);
  std::vector<TypeParam> expected(static_cast<std::size_t>(6 * count)), target(expected.size());
  const Osd::Points<TypeParam> in{control, {}};
  Osd::SerialEvaluator serial;
  ASSERT_TRUE(serial.evaluate(refinement, 2, in, Osd::PointsOut<TypeParam>{expected, {}}));
  Osd::TileEvaluator evaluator;
  ASSERT_TRUE(evaluator.evaluate(refinement, tiles, 2, in, Osd::PointsOut<TypeParam>{target, {}}));
  EXPECT_TRUE(sameBits(target, expected));
  const auto half = std::span(target).first(target.size() / 2);
  EXPECT_FALSE(evaluator.evaluate(refinement, tiles, 2, in, Osd::PointsOut<TypeParam>{half, {}}));
}

TEST(TileTable, StartsFromALevelThatTilesOfASoundSizeReachTheLastFrom) {
  const Far::Refinement refinement = refined(torus(8, 8), schemeCase(NamedTension::paper).scheme, 5);
  EXPECT_EQ(tiled(refinement, 32000).rootLevel, 0);
  EXPECT_GT(tiled(refinement, 500).rootLevel, 0);
  EXPECT_EQ(tiled(refinement, 8192, Far::TileOrder::levels, 2).lastLevel, 2);
}

TEST(TileTable, HoldsFewPointsTwice) {
  // Of a mesh of 10,000 quads, level 3: points evaluated below the last level, and indices an output.
  const Far::Refinement refinement = refined(torus(100, 100), schemeCase(NamedTension::paper).scheme, 3);
  const Far::TileTable tiles = tiled(refinement, 8192);
  double held = 0;
  for (const Far::Tile& tile : tiles.tiles) held += tile.pointCount - tile.importCount;
  const double needed = refinement.level(1).pointCount() + refinement.level(2).pointCount();
  EXPECT_LT(held / needed, 1.2);
  EXPECT_LT(static_cast<double>(tiles.byteCount()) / refinement.last().pointCount(), 3.5);
}

TEST(TileTable, HasANumberForTwoCornersOfWhatBecomesOfAVertex) {
  const Far::Refinement refinement = refined(torus(30, 20), schemeCase(NamedTension::paper).scheme, 4);
  const auto faces = must(Far::buildTileTable(refinement));
  const auto fours = must(Far::buildTileTable(refinement, {.places = Far::TilePlaces::fours}));
  for (const Far::TileStep& step : faces.steps) EXPECT_FALSE(step.pairs);
  for (const Far::TileStep& step : fours.steps) EXPECT_EQ(step.pairs, step.level > fours.rootLevel + 1);
  EXPECT_LT(10 * fours.indices.size(), 6 * faces.indices.size());
}

TEST(TileTable, HasTilesForAllThreadsOfOneSize) {
  const Far::Refinement refinement = refined(torus(60, 50), schemeCase(NamedTension::paper).scheme, 4);
  const auto sizes = [&](const Far::TileOptions& options) {
    std::vector<std::int32_t> own;
    for (const Far::Tile& tile : must(Far::buildTileTable(refinement, options)).tiles) {
      own.push_back(tile.pointCount - tile.importCount);
    }
    return own;
  };
  EXPECT_EQ(sizes({.scratchPoints = 32768}).size(), 7U);
  const std::vector<std::int32_t> own = sizes({.scratchPoints = 32768, .fewestTiles = 12});
  EXPECT_EQ(own.size(), 12U);
  EXPECT_LT(std::ranges::max(own), 1.2 * std::ranges::min(own)) << "no tile is left over";
  // 159,000 points are kept: a hundred tiles would be too small.
  EXPECT_EQ(sizes({.scratchPoints = 32768, .fewestTiles = 100}).size(), 38U);
  EXPECT_EQ(sizes({.scratchPoints = 32768, .workers = 2}).size(), 8U) << "as many for each thread";
  EXPECT_EQ(sizes({.scratchPoints = 32768, .workers = 5}).size(), 10U);
  EXPECT_EQ(sizes({.scratchPoints = 32768, .fewestTiles = 100, .workers = 16}).size(), 32U);
  EXPECT_EQ(sizes({.scratchPoints = 32768, .workers = 40}).size(), 7U) << "forty would be too small";
}

TEST(TileTable, RefusesLevelsAndSizesOutOfRange) {
  const Far::Refinement refinement = refined(cube(), schemeCase(NamedTension::paper).scheme, 2);
  EXPECT_EQ(Far::buildTileTable(refinement, {.level = 3}).error().message, "level 3 is out of range; use 1 to 2");
  EXPECT_FALSE(Far::buildTileTable(refinement, {.scratchPoints = 63}).has_value());
  EXPECT_FALSE(Far::buildTileTable(refinement, {.scratchPoints = 32769}).has_value());
  EXPECT_FALSE(Far::buildTileTable(refinement, {.fewestTiles = 0}).has_value());
  EXPECT_FALSE(Far::buildTileTable(refinement, {.workers = 0}).has_value());
  EXPECT_FALSE(Far::buildTileTable(refined(cube(), schemeCase(NamedTension::paper).scheme, 0)).has_value());
}

TEST(TileEvaluator, RefusesWhatItCannotDo) {
  const Far::Refinement refinement = refined(cube(), schemeCase(NamedTension::paper).scheme, 2);
  const std::vector<float> control(24);
  std::vector<float> refined(1000);
  const Osd::Points<float> in{control, {}};
  const Osd::PointsOut<float> out{refined, {}};
  Osd::TileEvaluator evaluator;
  const Far::TileTable tiles = tiled(refinement, 500);
  EXPECT_FALSE(evaluator.evaluate(refinement, tiles, 0, in, out).has_value());
  EXPECT_FALSE(evaluator.evaluate(refinement, tiles, 3, in, out).has_value());
  EXPECT_FALSE(evaluator.evaluate(refinement, tiles, 2, in, {std::span(refined).first(30), {}}).has_value());
  EXPECT_FALSE(evaluator.evaluate(refinement, tiled(refinement, 500, Far::TileOrder::tiles), 1, in, out).has_value());
  const auto chosen = [&](const std::vector<std::int32_t>& only) {
    return evaluator.evaluate(refinement, tiles, 2, in, out, {{}, only}).has_value();
  };
  EXPECT_TRUE(chosen({0}));
  EXPECT_FALSE(chosen({-1}));
  EXPECT_FALSE(chosen({0, 0}));
  EXPECT_FALSE(chosen({static_cast<std::int32_t>(tiles.tiles.size())}));
}

}  // namespace
}  // namespace honeycomb::Test
