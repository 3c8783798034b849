// As on a discrete GPU: nothing is shared, tables and points are copied by commands.
#include "fixture.h"
#include "osd/vulkan/session.h"
#include "reference.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Test::randomLimits;
using Test::randomNumbers;
using Test::randomTable;
using Test::TableShape;

class StagingTest : public VulkanTest {};

TEST_F(StagingTest, DeviceMemoryIsNotMapped) {
  auto evaluator = makeEvaluator({.stageEverything = true});
  const auto staged =
      Osd::SharedBuffer::create(evaluator.core(), 64, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Osd::MemoryUse::readback);
  ASSERT_TRUE(staged) << staged.error().message;
  EXPECT_TRUE(staged->staged());
  EXPECT_EQ(staged->bytes().size(), 64U);
}

TEST_F(StagingTest, GivesTheSameBits) {
  auto evaluator = makeEvaluator({.stageEverything = true});
  const TableShape shape{.circulants = {{4, 50}, {5, 33}, {6, 100}}, .projected = {65, 700}, .looseRows = 77};
  EXPECT_TRUE(agrees(evaluator, {randomTable(shape)}, {}, {}));
  EXPECT_TRUE(agrees(evaluator, {randomTable(shape)}, {5, 3, 4}, {2, 3, 7}));
}

TEST_F(StagingTest, LimitsComeBackAsWell) {
  auto evaluator = makeEvaluator({.stageEverything = true});
  const Far::LevelTable level = randomTable({.sourceCount = 300, .circulants = {{4, 100}}});
  Far::LimitTable limits;
  limits.faces = randomLimits(level.targetCount, {{4, 100}});
  const Osd::BufferDescriptor desc{1, 3, 4};
  auto session = Osd::VulkanSession::create(
      evaluator, *evaluator.upload(std::vector{&level}, &limits, {.faceLimits = {desc, desc}}));
  ASSERT_TRUE(session) << session.error().message;
  const auto in = randomNumbers(900);
  std::ranges::copy(in, session->control().begin());
  ASSERT_TRUE(session->run());
  std::vector<float> positions(static_cast<std::size_t>(desc.extent(100))), normals(positions.size());
  evaluateLimits(limits.faces, expectedPoints({level}, in, {}, {}), {}, positions, desc, normals, desc);
  EXPECT_TRUE(sameBits(positions, session->facePositions()));
  EXPECT_TRUE(sameBits(normals, session->faceNormals()));
}

}  // namespace
}  // namespace honeycomb::VulkanTests
