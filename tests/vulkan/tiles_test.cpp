// Tiles on the device: the same bits as the serial evaluator's, level after level.
#include <gmock/gmock.h>

#include <thread>

#include "far/base/index.h"
#include "far/schemes/akleman.h"
#include "far/tables/tile_table.h"
#include "osd/cpu_evaluator.h"
#include "osd/vulkan/session.h"
#include "tests/support/creased.h"
#include "tests/support/must.h"
#include "tests/support/random_refinements.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"
#include "tile_fixture.h"

namespace honeycomb::VulkanTests {
namespace {

using testing::HasSubstr;

TEST_F(TilesTest, OfClosedMeshesUnderEveryScheme) {
  agreeUnderEveryScheme(Meshes::torus(9, 7), {}, 0);
}

TEST_F(TilesTest, OfOpenMeshesUnderEverySchemeAndBoundaryRule) {
  agreeUnderEveryScheme(Meshes::grid(7, 8), {}, 1);
}

TEST_F(TilesTest, InSharedMemoryUnderEverySchemeAndBoundaryRule) {
  agreeUnderEveryScheme(Meshes::grid(7, 8), {.scratch = TileScratch::shared}, 2);
}

TEST_F(TilesTest, OfPointsOfAnyLengthAndStride) {
  const Far::Refinement refinement = aklemanOf(Meshes::grid(9, 8), 3);
  for (const TileScratch scratch : {TileScratch::buffer, TileScratch::shared}) {
    for (const auto* list : {&kPositions, &kPrimvars}) {
      for (const Layouts& layouts : *list) {
        EXPECT_TRUE(agree(refinement, {.scratch = scratch, .layouts = layouts}))
            << "length " << layouts.refined.length << ", stride " << layouts.refined.stride;
      }
    }
  }
}

// Schemes by turns, with and without creases, level after level and by tiles. HONEYCOMB_FUZZ_ROUNDS takes more of them.
TEST_F(TilesTest, OfRandomMeshes) {
  Meshes::forRandomRefinementsByTurns(Meshes::fuzzRounds(2), [this](const Meshes::RandomRefinement& random) {
    SCOPED_TRACE(random.name);
    Meshes::Random& choice = random.choice;
    TileRun run;
    run.scratchPoints = static_cast<std::int32_t>(choice.between(64, 1000));
    run.layouts = kPositions[choice.below(kPositions.size())];
    run.places = choice.chance(0.5) ? Far::TilePlaces::fours : Far::TilePlaces::faces;
    run.kind = choice.chance(0.5) ? Far::TileNormalKind::exact : Far::TileNormalKind::fast;
    run.normals = kNormals[choice.below(kNormals.size())];
    const auto byLevels = agreeByLevels(random.refinement, run.layouts);
    const auto byTiles = agree(random.refinement, run);
    EXPECT_TRUE(byLevels);
    EXPECT_TRUE(byTiles) << run.scratchPoints << " points a tile";
    return byLevels && byTiles;
  });
}

TEST_F(TilesTest, WithCreases) {
  for (const Meshes::CreasedMesh& mesh : Meshes::creasedMeshes(1.5)) {
    const Far::Refinement refinement = must(Far::refine(Meshes::creased(mesh.mesh, mesh.creases), *Far::akleman(), 3));
    EXPECT_TRUE(agree(refinement, {.scratchPoints = 300})) << mesh.name;
  }
}

TEST_F(TilesTest, WithManyCreasesThatEndAtALargeFace) {
  for (const Meshes::CreasedMesh& mesh : Meshes::meetingCreases(100, 1.5)) {
    const Far::Refinement refinement = must(Far::refine(Meshes::creased(mesh.mesh, mesh.creases), *Far::akleman(), 2));
    EXPECT_TRUE(agree(refinement, {.scratchPoints = 300})) << mesh.name;
  }
}

TEST_F(TilesTest, OfFacesWithAnyNumberOfSides) {
  for (const std::size_t sides : {3U, 5U, 7U, 9U, 10U, 33U, 64U}) {
    const Far::Refinement refinement = aklemanOf(Meshes::prism(sides), 2);
    for (const TileScratch scratch : {TileScratch::buffer, TileScratch::shared}) {
      EXPECT_TRUE(agree(refinement, {.scratch = scratch})) << sides << " sides";
    }
  }
}

TEST_F(TilesTest, OfWhatIsTooLargeForATile) {
  for (const Meshes::PolyMesh& mesh : {Meshes::prism(1500), Meshes::wheel(700), Meshes::fan(300)}) {
    const Far::Refinement refinement = aklemanOf(mesh, 3);
    ASSERT_FALSE(must(Far::buildTileTable(refinement, {.scratchPoints = 1000})).shared.empty());
    for (const std::int32_t level : {1, 2, 3}) {
      EXPECT_TRUE(agree(refinement, {.scratchPoints = 1000, .level = level}));
    }
    EXPECT_TRUE(
        agree(refinement, {.scratchPoints = 1000, .scratch = TileScratch::shared, .layouts = kPrimvars.back()}));
  }
}

TEST_F(TilesTest, FromARootLevelBehindTheControlPoints) {
  const Far::Refinement refinement = aklemanOf(Meshes::torus(8, 8), 5);
  ASSERT_GT(must(Far::buildTileTable(refinement, {.scratchPoints = 300})).rootLevel, 1);
  for (const std::int32_t level : {1, 3, 5}) EXPECT_TRUE(agree(refinement, {.scratchPoints = 300, .level = level}));
}

TEST_F(TilesTest, WhosePointsStandInFoursOfFaces) {
  const Far::Refinement refinement = aklemanOf(Meshes::grid(9, 8), 3);
  for (const std::int32_t level : {2, 3}) {
    EXPECT_TRUE(agree(refinement, {.level = level, .places = Far::TilePlaces::fours}));
  }
}

TEST_F(TilesTest, OnADeviceWhoseSubgroupsMayBePartlyFilled) {
  ASSERT_TRUE(context->device().fullSubgroups) << "lavapipe has the features";
  Osd::VulkanDevice device = context->device();
  device.fullSubgroups = false;
  evaluator.emplace(must(Osd::VulkanEvaluator::create(device)));
  EXPECT_TRUE(agree(aklemanOf(Meshes::grid(9, 8), 3), {}));
}

// The context enables what they need; which of both it takes depends on the machine.
TEST_F(TilesTest, OnADeviceWithAndWithoutLongStores) {
  for (const bool longStores : {false, true}) {
    SCOPED_TRACE(longStores ? "with long stores" : "without");
    Osd::VulkanDevice device = context->device();
    device.longStores = longStores;
    evaluator.emplace(must(Osd::VulkanEvaluator::create(device)));
    for (const auto* list : {&kPositions, &kPrimvars}) {
      for (const Layouts& layouts : *list) {
        EXPECT_TRUE(agree(aklemanOf(Meshes::grid(9, 8), 3), {.layouts = layouts}))
            << "length " << layouts.refined.length << ", stride " << layouts.refined.stride;
      }
    }
    for (const std::size_t sides : {3U, 7U, 8U}) EXPECT_TRUE(agree(aklemanOf(Meshes::prism(sides), 2), {}));
    EXPECT_TRUE(agree(aklemanOf(Meshes::fan(300), 2), {.scratchPoints = 1000})) << "with shared points";
  }
}

TEST_F(TilesTest, WhoseFacesHaveOtherWeightsAtEveryLevel) {
  std::vector<Far::Scheme> schemes;
  for (const double corner : {0.6, 0.7, 0.5})
    schemes.push_back(must(Far::akleman({.tension = {.rule = Far::Tension::Rule::constant, .value = corner}})));
  const Far::Refinement refinement = Meshes::refinedBy(Meshes::toTopology(Meshes::torus(9, 7)), schemes);
  for (const std::int32_t level : {2, 3}) EXPECT_TRUE(agree(refinement, {.level = level}));
}

// A CPU's workgroups run tile after tile, and llvmpipe ends loops that take too many turns together.
TEST_F(TilesTest, OfSoManyLargeFacesThatAWorkgroupsLoopsTurnOften) {
  const Meshes::PolyMesh prism = Meshes::prism(60);
  Meshes::PolyMesh mesh;
  for (int copy = 0; copy < 240; ++copy) Meshes::append(mesh, prism);
  const Far::Refinement refinement = aklemanOf(mesh, 2);
  EXPECT_TRUE(agree(refinement, {.scratchPoints = 8192}));
  evaluator.emplace(makeEvaluator({.maxWorkgroupsInRow = 1}));
  EXPECT_TRUE(agree(refinement, {.scratchPoints = 8192})) << "several dispatches";
}

TEST_F(TilesTest, AreCutForTheThreadsOfACpu) {
  const Far::TileOptions options = evaluator->tileOptions();
  EXPECT_EQ(options.scratchPoints, evaluator->tilePoints());
  EXPECT_EQ(options.workers, static_cast<std::int32_t>(std::thread::hardware_concurrency()));
  EXPECT_GE(options.fewestTiles, 2 * options.workers);
  const Far::TileTable tiles = must(Far::buildTileTable(aklemanOf(Meshes::torus(60, 50), 4), options));
  // 38 tiles are as many as keep enough points.
  if (options.workers <= 16) {
    EXPECT_EQ(tiles.tiles.size() % at(options.workers), 0U);
  }
}

TEST_F(TilesTest, OfASingleFace) {
  EXPECT_TRUE(agree(aklemanOf(Meshes::cube(), 1), {}));
  EXPECT_TRUE(agree(aklemanOf(Meshes::grid(1, 1), 2), {}));
}

TEST_F(TilesTest, InTheirOwnOrder) {
  const Far::Refinement refinement = aklemanOf(Meshes::torus(20, 15), 3);
  const Far::TileTable tiles =
      must(Far::buildTileTable(refinement, {.scratchPoints = 1500, .order = Far::TileOrder::tiles}));
  Osd::VulkanSession session =
      must(Osd::VulkanSession::create(*evaluator, must(evaluator->uploadTiles(refinement, tiles))));
  const std::vector<float> control = controlOf(refinement, kPositions[0], 1);
  std::ranges::copy(control, session.control().begin());
  must(session.run());
  const std::vector<float> points = chained(refinement, 3, kPositions[0], control);
  std::vector<float> expected;
  for (const std::int32_t point : tiles.written) {
    for (std::int32_t c = 0; c < 3; ++c) expected.push_back(points[at(3 * point + c)]);
  }
  EXPECT_TRUE(sameBits(expected, session.refined()));
}

TEST_F(TilesTest, ChosenOnesGiveTheirPointsAndTouchNoOthers) {
  const Far::Refinement refinement = aklemanOf(Meshes::torus(30, 20), 3);
  const Far::TileTable tiles = must(Far::buildTileTable(refinement, {.scratchPoints = 800}));
  const std::vector<std::int32_t> wanted = {0, 17, 55};
  const std::vector<std::int32_t> chosen = tiles.tilesOf(3, wanted);
  Osd::VulkanSession session =
      must(Osd::VulkanSession::create(*evaluator, must(evaluator->uploadTiles(refinement, tiles, {.only = chosen}))));
  const std::vector<float> control = controlOf(refinement, kPositions[0], 1);
  std::ranges::copy(control, session.control().begin());
  must(session.run());
  const std::vector<float> whole = chained(refinement, 3, kPositions[0], control);
  const auto some = session.refined();
  for (const std::int32_t point : wanted) EXPECT_EQ(some[at(3 * point)], whole[at(3 * point)]);
  std::size_t touched = 0;
  for (std::size_t i = 0; i < some.size(); ++i) {
    if (some[i] == 0.0F) continue;
    ++touched;
    ASSERT_EQ(some[i], whole[i]);
  }
  EXPECT_LT(touched, whole.size() / 3) << "a few tiles cost as much as all";
}

TEST_F(TilesTest, NoneChosenWriteNothing) {
  const Far::Refinement refinement = aklemanOf(Meshes::cube(), 2);
  const Far::TileTable tiles = must(Far::buildTileTable(refinement));
  const std::vector<std::int32_t> none;
  auto table = must(evaluator->uploadTiles(refinement, tiles, {.only = none}));
  EXPECT_EQ(table.dispatchCount(), 0U);
  Osd::VulkanSession session = must(Osd::VulkanSession::create(*evaluator, std::move(table), {.timing = true}));
  must(session.run());
  EXPECT_THAT(session.refined(), testing::Each(0.0F));
  EXPECT_TRUE(session.binding().levelTimes());
}

TEST_F(TilesTest, AreTimedAsOneBehindTheLevelsBeforeThem) {
  const Far::Refinement refinement = aklemanOf(Meshes::torus(8, 8), 5);
  const Far::TileTable tiles = must(Far::buildTileTable(refinement, {.scratchPoints = 300}));
  Osd::VulkanSession session =
      must(Osd::VulkanSession::create(*evaluator, must(evaluator->uploadTiles(refinement, tiles)), {.timing = true}));
  must(session.run());
  const auto times = must(session.binding().levelTimes());
  ASSERT_EQ(times.size(), at(tiles.rootLevel + 1));
  EXPECT_EQ(times.back().level, tiles.rootLevel + 1);
  EXPECT_FALSE(times.back().limits);
}

TEST_F(TilesTest, OverSeveralPagesTablesAndDispatches) {
  const Far::Refinement refinement = aklemanOf(Meshes::torus(30, 20), 3);
  const auto under = [&](const Osd::VulkanEvaluatorOptions& options, const Layouts& layouts) {
    evaluator.emplace(makeEvaluator(options));
    return agree(refinement, {.scratchPoints = 400, .layouts = layouts});
  };
  EXPECT_TRUE(under({.maxStorageBufferRange = 1 << 16}, kPositions[0])) << "a target of five pages";
  EXPECT_TRUE(under({.maxStorageBufferRange = 1 << 16}, kPositions[2]));
  EXPECT_TRUE(under({.maxTexels = 2000}, kPositions[0])) << "a table of several texel buffers";
  EXPECT_TRUE(under({.maxWorkgroupsInRow = 2}, kPositions[0])) << "several tiles a workgroup";
  EXPECT_TRUE(under({.stageEverything = true}, kPositions[0]));
}

TEST_F(TilesTest, RefuseWhatTheDeviceCannotBind) {
  const Far::Refinement refinement = aklemanOf(Meshes::torus(30, 20), 3);
  const Far::TileTable tiles = must(Far::buildTileTable(refinement, {.scratchPoints = 8192}));
  const auto refusal = [&](const Osd::VulkanEvaluatorOptions& device, const Osd::VulkanTileOptions& options) {
    auto refused = makeEvaluator(device).uploadTiles(refinement, tiles, options);
    EXPECT_FALSE(refused);
    return refused ? Error{} : refused.error();
  };
  const Error pages = refusal({.maxStorageBufferRange = 1 << 14}, {});
  EXPECT_EQ(pages.code, ErrorCode::tooLarge);
  EXPECT_THAT(pages.message, HasSubstr("refine level by level"));
  EXPECT_EQ(refusal({.maxTexels = 100}, {}).code, ErrorCode::tooLarge);
  const Error shared = refusal({}, {.scratch = TileScratch::shared});
  EXPECT_EQ(shared.code, ErrorCode::tooLarge);
  EXPECT_THAT(shared.message, HasSubstr("TileScratch::buffer"));
}

TEST_F(TilesTest, RefuseWhatTheTilesHaveNot) {
  const Far::Refinement refinement = aklemanOf(Meshes::cube(), 2);
  const Far::TileTable tiles = must(Far::buildTileTable(refinement));
  const auto code = [&](const Osd::VulkanTileOptions& options) {
    const auto refused = evaluator->uploadTiles(refinement, tiles, options);
    EXPECT_FALSE(refused);
    return refused ? ErrorCode{} : refused.error().code;
  };
  const std::vector<std::int32_t> twice = {0, 0};
  EXPECT_EQ(code({.level = 3}), ErrorCode::invalidOption);
  EXPECT_EQ(code({.level = -1}), ErrorCode::invalidOption);
  EXPECT_EQ(code({.refined = {0, 4, 4}}), ErrorCode::invalidOption);
  EXPECT_EQ(code({.only = twice}), ErrorCode::invalidOption);
}

TEST_F(TilesTest, OfTheSizeForTheDeviceFitWhereTheyAreMeantFor) {
  const Far::Refinement refinement = aklemanOf(Meshes::torus(40, 40), 3);
  for (const TileScratch scratch : {TileScratch::automatic, TileScratch::buffer, TileScratch::shared}) {
    EXPECT_TRUE(agree(refinement, {.scratchPoints = evaluator->tilePoints(scratch), .scratch = scratch}));
  }
}

}  // namespace
}  // namespace honeycomb::VulkanTests
