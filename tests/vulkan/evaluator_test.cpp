// The evaluator on the caller's terms: a device, command buffer and buffers that somebody else owns.
#include "osd/vulkan/evaluator.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "fixture.h"
#include "osd/vulkan/commands.h"
#include "osd/vulkan/errors.h"
#include "osd/vulkan/memory.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Test::randomNumbers;
using Test::randomTable;

using testing::HasSubstr;

class EvaluatorTest : public VulkanTest {
 protected:
  Osd::VulkanBuffer buffer(const Osd::VulkanEvaluator& evaluator, std::uint64_t bytes) {
    auto made = Osd::VulkanBuffer::create(evaluator.core(), bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                          Osd::MemoryUse::readback);
    if (!made) throw std::runtime_error(made.error().message);
    return std::move(*made);
  }
  // Levels of 300, 360 and 540 points.
  std::vector<Far::LevelTable> levels{randomTable({.sourceCount = 300, .circulants = {{6, 60}}}, 1),
                                      randomTable({.sourceCount = 360, .circulants = {{5, 108}}}, 2)};
};

TEST_F(EvaluatorTest, RecordsIntoTheCallersCommandBufferAndRange) {
  auto evaluator = makeEvaluator();
  const auto table = evaluator.upload(pointersTo(levels), nullptr);
  ASSERT_TRUE(table) << table.error().message;
  const Osd::VulkanBuffer source = buffer(evaluator, 8192), target = buffer(evaluator, 16384);
  std::ranges::fill(target.numbers(), 5.0F);
  const auto in = randomNumbers(900);
  std::ranges::copy(in, source.numbers().begin() + 64);
  auto binding =
      evaluator.bind(*table, {.control = {source.handle(), 256, 3600}, .refined = {target.handle(), 512, 6480}});
  ASSERT_TRUE(binding) << binding.error().message;
  auto commands = Osd::CommandRunner::create(evaluator.core());
  ASSERT_TRUE(commands && commands->begin(0));
  evaluator.record(commands->commandBuffer(), *binding);
  ASSERT_TRUE(commands->end() && commands->submit() && commands->wait());
  const auto written = target.numbers();
  EXPECT_TRUE(sameBits(expectedPoints(levels, in, {}, {}), written.subspan(128, 1620)));
  EXPECT_THAT(written.first(128), testing::Each(5.0F));
  EXPECT_THAT(written.subspan(128 + 1620), testing::Each(5.0F));
}

TEST_F(EvaluatorTest, TwoBindingsOfOneTableInOneCommandBuffer) {
  auto evaluator = makeEvaluator();
  const auto table = evaluator.upload(pointersTo(levels), nullptr);
  ASSERT_TRUE(table) << table.error().message;
  auto commands = Osd::CommandRunner::create(evaluator.core());
  ASSERT_TRUE(commands && commands->begin(0));
  std::vector<Osd::VulkanBuffer> sources, targets;
  std::vector<Osd::VulkanBinding> bindings;
  for (std::uint32_t i = 0; i < 2; ++i) {
    sources.push_back(buffer(evaluator, 3600));
    targets.push_back(buffer(evaluator, 6480));
    std::ranges::copy(randomNumbers(900, i), sources.back().numbers().begin());
    auto binding = evaluator.bind(*table, {.control = sources.back().range(), .refined = targets.back().range()});
    ASSERT_TRUE(binding) << binding.error().message;
    bindings.push_back(std::move(*binding));
    evaluator.record(commands->commandBuffer(), bindings.back());
  }
  ASSERT_TRUE(commands->end() && commands->submit() && commands->wait());
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(sameBits(expectedPoints(levels, randomNumbers(900, i), {}, {}), targets[i].numbers()))
        << "binding " << i;
  }
}

TEST_F(EvaluatorTest, TwoEvaluatorsOnOneDevice) {
  auto first = makeEvaluator(), second = makeEvaluator({.maxStorageBufferRange = 4096});
  EXPECT_TRUE(agrees(first, levels, {}, {}));
  EXPECT_TRUE(agrees(second, levels, {}, {}));
  EXPECT_TRUE(agrees(first, levels, {0, 2, 2}, {0, 2, 2}));
}

TEST_F(EvaluatorTest, TwoDevicesSideBySide) {
  auto other = Osd::VulkanContext::create({.validation = validationWanted()});
  ASSERT_TRUE(other) << other.error().message;
  auto here = makeEvaluator();
  auto there = Osd::VulkanEvaluator::create(other->device());
  ASSERT_TRUE(there) << there.error().message;
  EXPECT_TRUE(agrees(*there, levels, {}, {}));
  EXPECT_TRUE(agrees(here, levels, {}, {}));
  EXPECT_TRUE(agrees(*there, levels, {}, {}));
  EXPECT_THAT(other->messages(), testing::IsEmpty());
}

TEST_F(EvaluatorTest, ARefinementsLevelsByRange) {
  auto evaluator = makeEvaluator();
  const Far::Refinement refinement({{{}, {}}, {{}, levels[0]}, {{}, levels[1]}}, {});
  const auto all = evaluator.upload(refinement), second = evaluator.upload(refinement, {.firstLevel = 1});
  const auto first = evaluator.upload(refinement, {.lastLevel = 1});
  ASSERT_TRUE(all && first && second);
  EXPECT_EQ(all->controlCount(), 300);
  EXPECT_EQ(all->refinedCount(), 540);
  EXPECT_EQ(first->refinedCount(), 360);
  EXPECT_EQ(second->controlCount(), 360);
  EXPECT_EQ(all->dispatchCount(), 2U);
  for (const Osd::VulkanTableOptions& wrong :
       {Osd::VulkanTableOptions{.lastLevel = 0}, {.lastLevel = 3}, {.firstLevel = -1}, {.firstLevel = 2}}) {
    const auto refused = evaluator.upload(refinement, wrong);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
  }
}

TEST_F(EvaluatorTest, RefusesLevelsThatDoNotFollowEachOther) {
  auto evaluator = makeEvaluator();
  const auto refused = evaluator.upload(std::vector{&levels[1], &levels[0]}, nullptr);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "level 2 of the Vulkan table reads 300 points, the level before has 540");
  EXPECT_FALSE(evaluator.upload(std::vector<const Far::LevelTable*>{}, nullptr));
  const Far::LevelTable empty;
  EXPECT_FALSE(evaluator.upload(std::vector{&empty}, nullptr));
}

TEST_F(EvaluatorTest, RefusesUnsoundDescriptors) {
  auto evaluator = makeEvaluator();
  for (const Osd::BufferDescriptor& wrong : {Osd::BufferDescriptor{-1, 3, 3}, {0, 0, 3}, {0, 3, 2}, {0, 4, 4}}) {
    const auto refused = evaluator.upload(pointersTo(levels), nullptr, {.control = wrong});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
  }
}

TEST_F(EvaluatorTest, RefusesBuffersThatAreMissingShortOrMisaligned) {
  auto evaluator = makeEvaluator();
  const auto table = evaluator.upload(pointersTo(levels), nullptr);
  ASSERT_TRUE(table) << table.error().message;
  const Osd::VulkanBuffer source = buffer(evaluator, 4096), target = buffer(evaluator, 8192);
  const auto refusal = [&](const Osd::VulkanTargets& targets) {
    const auto binding = evaluator.bind(*table, targets);
    return binding ? std::string("bound") : binding.error().message;
  };
  EXPECT_THAT(refusal({.control = source.range()}), HasSubstr("a buffer for the refined points is needed"));
  EXPECT_THAT(refusal({.control = {source.handle(), 0, 3599}, .refined = target.range()}),
              HasSubstr("the buffer for the control points has 3599 bytes, 3600 are needed"));
  EXPECT_THAT(refusal({.control = {source.handle(), 4, 3600}, .refined = target.range()}),
              HasSubstr("begins at byte 4"));
  EXPECT_EQ(refusal({.control = {source.handle(), 0, 3600}, .refined = {target.handle(), 0, 6480}}), "bound");
}

TEST_F(EvaluatorTest, RefusesHandlesThatAreNull) {
  for (Osd::VulkanDevice device : {Osd::VulkanDevice{}, context->device()}) {
    device.queue = VK_NULL_HANDLE;
    const auto refused = Osd::VulkanEvaluator::create(device);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
  }
}

TEST_F(EvaluatorTest, MoreMemoryThanThereIsIsAnError) {
  auto evaluator = makeEvaluator();
  const auto refused = Osd::VulkanBuffer::create(evaluator.core(), std::uint64_t{1} << 50U,
                                                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Osd::MemoryUse::device);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::outOfMemory);
  EXPECT_THAT(refused.error().message, HasSubstr("1125899906842624 bytes asked for"));
}

TEST(VulkanErrors, TellTheClassesApart) {
  EXPECT_EQ(Osd::vulkanError(VK_ERROR_DEVICE_LOST, "submit commands").code, ErrorCode::deviceLost);
  EXPECT_EQ(Osd::vulkanError(VK_ERROR_OUT_OF_DEVICE_MEMORY, "x").code, ErrorCode::outOfMemory);
  EXPECT_EQ(Osd::vulkanError(VK_ERROR_OUT_OF_HOST_MEMORY, "x").code, ErrorCode::outOfMemory);
  EXPECT_EQ(Osd::vulkanError(VK_ERROR_FEATURE_NOT_PRESENT, "x").code, ErrorCode::unsupported);
  EXPECT_EQ(Osd::vulkanError(VK_ERROR_INCOMPATIBLE_DRIVER, "x").code, ErrorCode::noDevice);
  EXPECT_EQ(
      Osd::vulkanError(VK_ERROR_DEVICE_LOST, "submit commands").message,
      "Vulkan failed to submit commands: VK_ERROR_DEVICE_LOST (-4); create the device anew, or use a CPU backend");
}

}  // namespace
}  // namespace honeycomb::VulkanTests
