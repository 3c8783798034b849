// Limits of the device lowered until small meshes cross them.
#include <gmock/gmock.h>

#include "fixture.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Test::randomTable;
using Test::TableShape;

using testing::HasSubstr;

class PagingTest : public VulkanTest {};

TEST_F(PagingTest, EveryBatchOverSeveralPages) {
  auto evaluator = makeEvaluator({.maxStorageBufferRange = 8192});
  ASSERT_EQ(evaluator.limits().pageBytes, 8192U);
  EXPECT_TRUE(
      agrees(evaluator, {randomTable({.sourceCount = 4000, .circulants = {{4, 1000}, {5, 700}, {64, 60}}})}, {}, {}));
  EXPECT_TRUE(
      agrees(evaluator, {randomTable({.sourceCount = 4000, .projected = {65, 300, 66, 70, 200, 330}})}, {}, {}));
  EXPECT_TRUE(agrees(evaluator, {randomTable({.sourceCount = 4000, .looseRows = 6000})}, {}, {}));
  EXPECT_TRUE(
      agrees(evaluator, {randomTable({.sourceCount = 4000, .projected = {65, 300, 66}, .summedRows = 3000})}, {}, {}));
  EXPECT_TRUE(agrees(
      evaluator, {randomTable({.sourceCount = 4000, .dense = {{1, 2500}, {2, 1500}, {4, 3000}, {16, 700}}})}, {}, {}));
  EXPECT_TRUE(agrees(
      evaluator,
      {randomTable(
          {.sourceCount = 4000, .circulants = {{6, 900}}, .projected = {100}, .dense = {{3, 900}}, .looseRows = 900})},
      {5, 3, 4}, {3, 3, 7}));
}

TEST_F(PagingTest, EveryLengthOverSeveralPages) {
  auto evaluator = makeEvaluator({.maxStorageBufferRange = 4096});
  const Far::LevelTable table = randomTable({.sourceCount = 1000,
                                             .circulants = {{3, 300}, {6, 300}},
                                             .projected = {70, 65},
                                             .dense = {{4, 400}},
                                             .looseRows = 400});
  for (const std::int32_t length : {1, 2, 4, 7}) {
    EXPECT_TRUE(agrees(evaluator, {table}, {1, length, length + 1}, {2, length, length + 2})) << "length " << length;
  }
}

TEST_F(PagingTest, AChainOfLevelsOverSeveralPages) {
  auto evaluator = makeEvaluator({.maxStorageBufferRange = 16384});
  std::vector<Far::LevelTable> levels;
  std::int32_t points = 500;
  for (std::uint32_t k = 0; k < 3; ++k) {
    levels.push_back(randomTable({.sourceCount = points, .circulants = {{6, points / 3}}, .looseRows = 40}, k));
    points = levels.back().targetCount;
  }
  EXPECT_TRUE(agrees(evaluator, levels, {}, {}));
}

TEST_F(PagingTest, RangesThatAreNoPowerOfTwoAreRoundedDown) {
  EXPECT_EQ(makeEvaluator({.maxStorageBufferRange = 10000}).limits().pageBytes, 8192U);
}

TEST_F(PagingTest, DispatchesInTwoDimensions) {
  auto evaluator = makeEvaluator({.maxWorkgroupsInRow = 3});
  const TableShape shape{.circulants = {{6, 2000}}, .projected = {3000, 700}, .dense = {{4, 1000}}, .looseRows = 1000};
  EXPECT_TRUE(agrees(evaluator, {randomTable(shape)}, {}, {}));
}

TEST_F(PagingTest, ASourceOfMorePagesThanCanBeBoundIsRefused) {
  auto evaluator = makeEvaluator({.maxStorageBufferRange = 4096});
  const Far::LevelTable fits = randomTable({.sourceCount = 2730, .circulants = {{3, 5}}});
  EXPECT_TRUE(evaluator.upload(std::vector{&fits}, nullptr));
  const Far::LevelTable passes = randomTable({.sourceCount = 2731, .circulants = {{3, 5}}});
  const auto refused = evaluator.upload(std::vector{&passes}, nullptr);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::tooLarge);
  EXPECT_THAT(refused.error().message, HasSubstr("32772 bytes can't be read"));
}

TEST_F(PagingTest, AFaceOfMoreTableThanAPageIsRefused) {
  auto evaluator = makeEvaluator({.maxStorageBufferRange = 4096});
  const Far::LevelTable table = randomTable({.sourceCount = 100, .projected = {400}});
  const auto refused = evaluator.upload(std::vector{&table}, nullptr);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::tooLarge);
}

TEST_F(PagingTest, ARangeTooSmallForTheAlignmentIsRefused) {
  const auto refused = Osd::VulkanEvaluator::create(context->device(), {.maxStorageBufferRange = 64});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
}

// The one test with a level past the real limit: 144 MB of output, and 144 MB of input to the next level.
TEST_F(PagingTest, LevelsPastTheDevicesOwnLimit) {
  auto evaluator = makeEvaluator();
  if (evaluator.limits().pageBytes > (std::uint64_t{1} << 27U)) GTEST_SKIP() << "the device binds more than 128 MiB";
  const Far::LevelTable large = randomTable({.sourceCount = 1000, .circulants = {{6, 2000000}}, .looseRows = 100});
  const Far::LevelTable small =
      randomTable({.sourceCount = large.targetCount, .circulants = {{6, 1000}}, .looseRows = 100});
  EXPECT_TRUE(agrees(evaluator, {large, small}, {}, {}));
  EXPECT_TRUE(agrees(evaluator, {large}, {}, {}));
}

}  // namespace
}  // namespace honeycomb::VulkanTests
