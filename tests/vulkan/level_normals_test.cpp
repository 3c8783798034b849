// Fast normals found on the device level after level: the same bits as those of the CPU.
#include <gmock/gmock.h>

#include "far/schemes/akleman.h"
#include "tests/support/creased.h"
#include "tests/support/random_mesh.h"
#include "tile_fixture.h"

namespace honeycomb::VulkanTests {
namespace {

using testing::HasSubstr;

class LevelNormalsTest : public TilesTest {
 protected:
  static TileRun run(std::size_t layout = 0) {
    return {.layouts = kPositions[layout % kPositions.size()],
            .kind = Far::TileNormalKind::fast,
            .normals = kNormals[layout % kNormals.size()]};
  }
  static Osd::VulkanTableOptions levelOptionsOf(const TileRun& run) {
    return {.control = run.layouts.control,
            .refined = run.layouts.refined,
            .vertexLimits = {.normals = run.normals},
            .normalKind = Far::TileNormalKind::fast};
  }

  testing::AssertionResult agreeByLevels(const Far::Refinement& refinement, const TileRun& run) {
    const auto table = evaluator->upload(refinement, levelOptionsOf(run));
    if (!table) return testing::AssertionFailure() << table.error().message;
    Osd::VulkanSession session = must(Osd::VulkanSession::create(*evaluator, *table));
    return sameFrames(refinement, session, run);
  }
};

TEST_F(LevelNormalsTest, UnderEverySchemeAndBoundaryRuleClosedAndOpen) {
  const auto& schemes = Meshes::listedSchemes();
  for (const Meshes::PolyMesh& mesh : {Meshes::torus(6, 5), Meshes::grid(5, 4)}) {
    for (std::size_t i = 0; i < schemes.size(); i += schemeStep()) {
      SCOPED_TRACE(schemes[i].name);
      ASSERT_TRUE(agreeByLevels(Meshes::refinedBy(schemes[i], Meshes::toTopology(mesh), 3), run(i)));
    }
  }
}

TEST_F(LevelNormalsTest, OfRandomMeshesWithCreasesAndLargeFaces) {
  const auto scheme = schemeCase(Meshes::NamedTension::paper).scheme;
  for (std::uint64_t seed = 0; seed < Meshes::meshes(4); ++seed) {
    EXPECT_TRUE(agreeByLevels(Meshes::refined(Meshes::randomMesh(seed), scheme, 3), run(seed))) << "seed " << seed;
  }
  for (const Meshes::CreasedMesh& mesh : Meshes::creasedMeshes(1.5)) {
    const Far::Refinement refinement = must(Far::refine(Meshes::creased(mesh.mesh, mesh.creases), *Far::akleman(), 2));
    EXPECT_TRUE(agreeByLevels(refinement, run())) << mesh.name;
  }
  for (const Meshes::PolyMesh& mesh : {Meshes::prism(400), Meshes::wheel(300), Meshes::pillow(300), Meshes::fan(300)}) {
    EXPECT_TRUE(agreeByLevels(aklemanOf(mesh, 2), run()));
  }
}

TEST_F(LevelNormalsTest, OverSeveralPagesAndInTwoDimensions) {
  evaluator.emplace(makeEvaluator({.maxStorageBufferRange = 1 << 14, .maxWorkgroupsInRow = 3}));
  for (std::size_t layout = 0; layout < kPositions.size(); ++layout) {
    EXPECT_TRUE(agreeByLevels(aklemanOf(Meshes::torus(12, 9), 3), run(layout))) << "layout " << layout;
  }
  EXPECT_TRUE(agreeByLevels(aklemanOf(Meshes::wheel(300), 2), run()));
}

TEST_F(LevelNormalsTest, OfALevelBeforeTheLast) {
  const Far::Refinement all = aklemanOf(Meshes::grid(5, 4), 3);
  Osd::VulkanTableOptions options = levelOptionsOf(run());
  options.lastLevel = 2;
  Osd::VulkanSession session = must(Osd::VulkanSession::create(*evaluator, must(evaluator->upload(all, options))));
  EXPECT_TRUE(sameFrames(aklemanOf(Meshes::grid(5, 4), 2), session, run()));
}

TEST_F(LevelNormalsTest, BesideExactLimitsOfPointsAndFaces) {
  const Far::Refinement refinement = aklemanOf(Meshes::torus(6, 5), 2, true);
  Osd::VulkanTableOptions options = levelOptionsOf(run());
  options.vertexLimits.positions = BufferDescriptor{};
  options.faceLimits.normals = BufferDescriptor{};
  Osd::VulkanSession session =
      must(Osd::VulkanSession::create(*evaluator, must(evaluator->upload(refinement, options))));
  const std::vector<float> control = controlOf(refinement, kPositions[0], 2);
  std::vector<float> vertices(session.vertexPositions().size()), faces(session.faceNormals().size());
  const std::vector<float> points = chained(refinement, 2, kPositions[0], control);
  must(Osd::SerialEvaluator().vertexLimits<float>(refinement.limits(), {points, {}}, {vertices, {}}, {}));
  must(Osd::SerialEvaluator().faceLimits<float>(refinement.limits(), {points, {}}, {}, {faces, {}}));
  EXPECT_TRUE(sameFrames(refinement, session, run()));
  EXPECT_TRUE(sameBits(vertices, session.vertexPositions())) << "of the second frame";
  EXPECT_TRUE(sameBits(faces, session.faceNormals())) << "of the second frame";
}

TEST_F(LevelNormalsTest, RefuseWhatTheyCannotBeFoundFrom) {
  const Far::Refinement refinement = aklemanOf(Meshes::cube(), 2);
  const auto refusal = [&](auto change) {
    Osd::VulkanTableOptions options = levelOptionsOf(run());
    change(options);
    const auto refused = evaluator->upload(refinement, options);
    EXPECT_EQ(refused ? ErrorCode{} : refused.error().code, ErrorCode::invalidOption);
    return refused ? std::string() : refused.error().message;
  };
  using Options = Osd::VulkanTableOptions;
  EXPECT_THAT(refusal([](Options& o) { o.firstLevel = 1; }), HasSubstr("begin with level 0"));
  EXPECT_THAT(refusal([](Options& o) { o.normalKind = Far::TileNormalKind::none; }), HasSubstr("fast or exact"));
  EXPECT_THAT(refusal([](Options& o) { o.control = o.refined = {0, 2, 2}; }), HasSubstr("length 3 or 4"));
  const auto levels = evaluator->upload(std::array{&refinement.level(1).table}, nullptr, levelOptionsOf(run()));
  ASSERT_FALSE(levels);
  EXPECT_THAT(levels.error().message, HasSubstr("upload the refinement"));
}

}  // namespace
}  // namespace honeycomb::VulkanTests
