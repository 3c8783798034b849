// Normals that tiles find on the device, fast and exact ones: the same bits as level after level on the CPU.
#include <gmock/gmock.h>

#include "far/schemes/akleman.h"
#include "tests/support/creased.h"
#include "tile_fixture.h"

namespace honeycomb::VulkanTests {
namespace {

using Far::TileNormalKind;
using testing::HasSubstr;

class TileNormalsTest : public TilesTest, public testing::WithParamInterface<TileNormalKind> {
 protected:
  // Packed normals, of tiles of a size that makes several of a small mesh.
  static TileRun run(std::int32_t scratchPoints = 600) {
    return {.scratchPoints = scratchPoints, .kind = GetParam(), .normals = kNormals[0]};
  }
  static TileRun sharedRun() {
    TileRun shared = run();
    shared.scratch = TileScratch::shared;
    return shared;
  }
  static bool exact() { return GetParam() == TileNormalKind::exact; }
  static Far::Refinement refinedTorus(std::size_t around, std::size_t along, std::int32_t levels = 3) {
    return aklemanOf(Meshes::torus(around, along), levels, exact());
  }
};

TEST_P(TileNormalsTest, OfClosedMeshesUnderEveryScheme) {
  agreeUnderEveryScheme(Meshes::torus(9, 7), run(), 0);
}

TEST_P(TileNormalsTest, OfOpenMeshesUnderEverySchemeAndBoundaryRule) {
  agreeUnderEveryScheme(Meshes::grid(7, 8), run(), 1);
}

TEST_P(TileNormalsTest, InSharedMemory) {
  for (const auto& mesh : {Meshes::torus(9, 7), Meshes::grid(7, 8)}) {
    EXPECT_TRUE(agree(aklemanOf(mesh, 3, exact()), sharedRun()));
  }
}

TEST_P(TileNormalsTest, OfPointsOfAnyStride) {
  const Far::Refinement refinement = refinedTorus(7, 6);
  const std::vector<BufferDescriptor> normals = {{1, 3, 3}, {0, 3, 3}, {1, 3, 4}};
  for (std::size_t i = 0; i < kPositions.size(); ++i) {
    TileRun strided = run();
    strided.layouts = kPositions[i];
    strided.normals = normals[i];
    EXPECT_TRUE(agree(refinement, strided))
        << "strides " << strided.layouts.refined.stride << ", " << normals[i].stride;
  }
}

TEST_P(TileNormalsTest, OfRandomMeshes) {
  for (std::uint64_t seed = 0; seed < Meshes::meshes(4); ++seed) {
    const auto scheme = schemeCase(Meshes::NamedTension::paper).scheme;
    EXPECT_TRUE(agree(Meshes::refined(Meshes::randomMesh(seed), scheme, 3, exact()), run())) << "seed " << seed;
  }
}

TEST_P(TileNormalsTest, WithCreases) {
  for (const Meshes::CreasedMesh& mesh : Meshes::creasedMeshes(1.5)) {
    const Far::Refinement refinement =
        must(Far::refine(Meshes::creased(mesh.mesh, mesh.creases), *Far::akleman(), 3, {.limits = exact()}));
    EXPECT_TRUE(agree(refinement, run())) << mesh.name;
  }
}

TEST_P(TileNormalsTest, OfWhatIsTooLargeForATile) {
  for (const Meshes::PolyMesh& mesh : {Meshes::prism(400), Meshes::wheel(300), Meshes::pillow(300), Meshes::fan(300)}) {
    EXPECT_TRUE(agree(aklemanOf(mesh, 2, exact()), run(1000)));
  }
}

TEST_P(TileNormalsTest, WhereThereIsNoTile) {
  const Far::Refinement refinement = aklemanOf(Meshes::pillow(300), 1, exact());
  ASSERT_TRUE(must(Far::buildTileTable(refinement)).tiles.empty());
  EXPECT_TRUE(agree(refinement, run(1000)));
}

TEST_P(TileNormalsTest, FromARootLevelBehindTheControlPoints) {
  const Far::Refinement refinement = refinedTorus(8, 8, 4);
  ASSERT_GT(must(Far::buildTileTable(refinement, {.scratchPoints = 300, .normals = GetParam()})).rootLevel, 0);
  EXPECT_TRUE(agree(refinement, run(300)));
}

TEST_P(TileNormalsTest, WhosePointsStandInFoursOfFaces) {
  TileRun fours = run();
  fours.places = Far::TilePlaces::fours;
  EXPECT_TRUE(agree(aklemanOf(Meshes::grid(9, 8), 3, exact()), fours));
}

TEST_P(TileNormalsTest, AreLeftOutWhereNotWanted) {
  const Far::Refinement refinement = refinedTorus(9, 7);
  for (const std::int32_t level : {1, 2, 3}) {
    TileRun points = run();
    points.normals.reset();
    points.level = level;
    EXPECT_TRUE(agree(refinement, points)) << "level " << level;
  }
}

TEST_P(TileNormalsTest, OverSeveralPagesAndTables) {
  const Far::Refinement refinement = refinedTorus(16, 12);
  const auto under = [&](const Osd::VulkanEvaluatorOptions& options, const Layouts& layouts) {
    evaluator.emplace(makeEvaluator(options));
    TileRun paged = run(500);
    paged.layouts = layouts;
    return agree(refinement, paged);
  };
  EXPECT_TRUE(under({.maxStorageBufferRange = 1 << 15}, kPositions[0])) << "three pages of points, three of normals";
  EXPECT_TRUE(under({.maxTexels = 4000}, kPositions[0])) << "a table of several texel buffers";
}

TEST_P(TileNormalsTest, OfChosenTilesAloneAreWritten) {
  const Far::Refinement refinement = refinedTorus(20, 15);
  const Far::TileTable tiles = must(Far::buildTileTable(refinement, {.scratchPoints = 1500, .normals = GetParam()}));
  ASSERT_GT(tiles.tiles.size(), 4U);
  const std::vector<std::int32_t> chosen = {1, 3};
  Osd::VulkanTileOptions options = optionsOf(run());
  options.only = chosen;
  Osd::VulkanSession session =
      must(Osd::VulkanSession::create(*evaluator, must(evaluator->uploadTiles(refinement, tiles, options))));
  const std::vector<float> control = controlOf(refinement, kPositions[0], 1);
  std::ranges::copy(control, session.control().begin());
  must(session.run());
  const std::vector<float> expected =
      chainedNormals(refinement, run(), control, chained(refinement, 3, kPositions[0], control));
  std::size_t written = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    // A point and its normal are written together, or neither is.
    const bool here = session.refined()[i] != 0.0F;
    ASSERT_EQ(session.vertexNormals()[i], here ? expected[i] : 0.0F) << "number " << i;
    written += here ? 1 : 0;
  }
  EXPECT_GT(written, 0U);
  EXPECT_LT(written, expected.size() / 2);
}

TEST_P(TileNormalsTest, InTheOrderOfTheTiles) {
  const Far::Refinement refinement = refinedTorus(12, 9);
  const Far::TileTable tiles = must(
      Far::buildTileTable(refinement, {.scratchPoints = 1500, .order = Far::TileOrder::tiles, .normals = GetParam()}));
  Osd::VulkanSession session =
      must(Osd::VulkanSession::create(*evaluator, must(evaluator->uploadTiles(refinement, tiles, optionsOf(run())))));
  const std::vector<float> control = controlOf(refinement, kPositions[0], 1);
  std::ranges::copy(control, session.control().begin());
  must(session.run());
  const std::vector<float> normals =
      chainedNormals(refinement, run(), control, chained(refinement, 3, kPositions[0], control));
  std::vector<float> expected;
  for (const std::int32_t point : tiles.written) {
    for (std::int32_t c = 0; c < 3; ++c) expected.push_back(normals[at(3 * point + c)]);
  }
  EXPECT_TRUE(sameBits(expected, session.vertexNormals()));
}

INSTANTIATE_TEST_SUITE_P(Both, TileNormalsTest, testing::Values(TileNormalKind::fast, TileNormalKind::exact),
                         [](const testing::TestParamInfo<TileNormalKind>& one) {
                           return one.param == TileNormalKind::fast ? "Fast" : "Exact";
                         });

TEST_F(TilesTest, RefuseNormalsThatTheyHaveNot) {
  const Far::Refinement refinement = aklemanOf(Meshes::cube(), 2);
  const auto refusal = [&](TileNormalKind kind, const Osd::VulkanTileOptions& options) {
    const Far::TileTable tiles = must(Far::buildTileTable(refinement, {.normals = kind}));
    const auto refused = evaluator->uploadTiles(refinement, tiles, options);
    EXPECT_FALSE(refused);
    EXPECT_EQ(refused ? ErrorCode{} : refused.error().code, ErrorCode::invalidOption);
    return refused ? std::string() : refused.error().message;
  };
  EXPECT_THAT(refusal(TileNormalKind::none, {.normals = kNormals[0]}), HasSubstr("TileOptions"));
  EXPECT_THAT(refusal(TileNormalKind::fast, {.level = 1, .normals = kNormals[0]}), HasSubstr("level 2 alone"));
  EXPECT_THAT(refusal(TileNormalKind::fast, {.normals = BufferDescriptor{0, 2, 2}}), HasSubstr("length 3"));
  EXPECT_THAT(refusal(TileNormalKind::fast, {.control = {0, 2, 2}, .refined = {0, 2, 2}, .normals = kNormals[0]}),
              HasSubstr("length 3 or 4"));
}

}  // namespace
}  // namespace honeycomb::VulkanTests
