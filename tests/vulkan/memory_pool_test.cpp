// Buffers share blocks of device memory, within a budget.
#include "osd/vulkan/memory_pool.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <thread>

#include "fixture.h"
#include "osd/vulkan/memory.h"
#include "spy.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using honeycomb::Test::must;
using Osd::MemoryPool;
using Osd::VulkanBuffer;

using testing::HasSubstr;

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20U;

Result<VulkanBuffer> makeUpload(const Osd::VulkanEvaluator& evaluator, std::uint64_t bytes) {
  return VulkanBuffer::create(evaluator.core(), bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Osd::MemoryUse::upload);
}

Osd::MemoryUsage usageOf(const Osd::VulkanEvaluator& evaluator) {
  return evaluator.core()->pool->usage();
}

bool holds(const VulkanBuffer& buffer, std::byte value) {
  return std::ranges::all_of(buffer.bytes(), [value](std::byte one) { return one == value; });
}

class MemoryPoolTest : public VulkanTest {};

TEST_F(MemoryPoolTest, SmallBuffersShareABlockThatGoesWithTheLast) {
  auto evaluator = makeEvaluator();
  {
    std::vector<VulkanBuffer> buffers;
    for (int i = 0; i < 100; ++i) {
      buffers.push_back(must(makeUpload(evaluator, 1000 + 7 * static_cast<std::uint64_t>(i))));
      std::ranges::fill(buffers.back().bytes(), static_cast<std::byte>(i));
    }
    EXPECT_EQ(usageOf(evaluator).blocks, 1U);
    EXPECT_EQ(usageOf(evaluator).held, MemoryPool::kLeastBlock);
    for (int i = 0; i < 100; ++i) {
      EXPECT_TRUE(holds(buffers[static_cast<std::size_t>(i)], static_cast<std::byte>(i))) << "buffer " << i;
    }
  }
  EXPECT_EQ(usageOf(evaluator).blocks, 0U);
  EXPECT_EQ(usageOf(evaluator).held, 0U);
}

TEST_F(MemoryPoolTest, WhatIsGivenBackIsUsedAgain) {
  auto evaluator = makeEvaluator();
  std::vector<VulkanBuffer> buffers;
  for (int i = 0; i < 4; ++i) buffers.push_back(must(makeUpload(evaluator, kMiB)));
  ASSERT_EQ(usageOf(evaluator).blocks, 1U);
  // The two in the middle leave one gap, which a buffer of two fits into.
  buffers.erase(buffers.begin() + 1, buffers.begin() + 3);
  buffers.push_back(must(makeUpload(evaluator, 2 * kMiB)));
  EXPECT_EQ(usageOf(evaluator).blocks, 1U);
  EXPECT_EQ(usageOf(evaluator).used, 4 * kMiB);
  buffers.push_back(must(makeUpload(evaluator, 1)));
  EXPECT_EQ(usageOf(evaluator).blocks, 2U);
}

TEST_F(MemoryPoolTest, BlocksDoubleAndLargeBuffersHaveTheirOwn) {
  auto evaluator = makeEvaluator();
  const VulkanBuffer first = must(makeUpload(evaluator, 3 * kMiB)), second = must(makeUpload(evaluator, 3 * kMiB));
  EXPECT_EQ(usageOf(evaluator).held, 3 * MemoryPool::kLeastBlock);
  const VulkanBuffer large = must(makeUpload(evaluator, MemoryPool::kLargestBlock / 2 + 4096));
  EXPECT_EQ(usageOf(evaluator).blocks, 3U);
  EXPECT_EQ(usageOf(evaluator).held, 3 * MemoryPool::kLeastBlock + large.size());
}

TEST_F(MemoryPoolTest, FromSeveralThreads) {
  auto evaluator = makeEvaluator();
  std::vector<int> wrong(4, 0);
  const auto work = [&](std::size_t thread) {
    std::mt19937 random(static_cast<std::uint32_t>(thread));
    std::vector<VulkanBuffer> buffers(8);
    for (int step = 0; step < 40; ++step) {
      const std::size_t place = random() % buffers.size();
      const auto value = static_cast<std::byte>(thread * buffers.size() + place);
      if (!holds(buffers[place], value)) ++wrong[thread];
      buffers[place] = VulkanBuffer();
      buffers[place] = must(makeUpload(evaluator, 1 + random() % 100000));
      std::ranges::fill(buffers[place].bytes(), value);
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < wrong.size(); ++i) threads.emplace_back(work, i);
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(wrong, testing::Each(0));
  EXPECT_EQ(usageOf(evaluator).blocks, 0U);
}

TEST_F(MemoryPoolTest, TheCallersBudgetHoldsForAllBuffersTogether) {
  auto evaluator = makeEvaluator({.maxDeviceBytes = 6 * kMiB});
  const VulkanBuffer first = must(makeUpload(evaluator, kMiB));
  const auto refused = makeUpload(evaluator, 5 * kMiB);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::outOfMemory);
  EXPECT_EQ(refused.error().message,
            "out of Vulkan device memory: 5242880 bytes asked for, 4194304 of 6291456 are in use "
            "(VulkanEvaluatorOptions::maxDeviceBytes); refine fewer levels, free tables and sessions, raise it, or use "
            "a CPU backend");
  EXPECT_TRUE(makeUpload(evaluator, 3 * kMiB)) << "the block has room";
}

TEST_F(MemoryPoolTest, WhereABlockPassesTheBudgetTheBufferAloneMayFit) {
  auto evaluator = makeEvaluator({.maxDeviceBytes = kMiB});
  const auto made = makeUpload(evaluator, kMiB / 2);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(usageOf(evaluator).held, kMiB / 2);
}

TEST_F(MemoryPoolTest, TheDevicesBudgetIsAskedEachTime) {
  Spy spy(context->device());
  spy.setExtension(true);
  auto evaluator = must(Osd::VulkanEvaluator::create(spy.device()));
  spy.setBudget(90 * kMiB, 100 * kMiB);
  const auto refused = makeUpload(evaluator, 11 * kMiB);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::outOfMemory);
  EXPECT_THAT(
      refused.error().message,
      HasSubstr("11534336 bytes asked for, 94371840 of 104857600 are in use (the budget of the device's heap)"));
  EXPECT_EQ(spy.calls("vkAllocateMemory"), 0);
  spy.setBudget(0, 100 * kMiB);
  EXPECT_TRUE(makeUpload(evaluator, 11 * kMiB));
}

TEST_F(MemoryPoolTest, WithoutABudgetTheHeapsSizeCounts) {
  Spy spy(context->device());
  spy.setExtension(false);
  auto evaluator = must(Osd::VulkanEvaluator::create(spy.device()));
  spy.setBudget(90 * kMiB, 100 * kMiB);
  EXPECT_TRUE(makeUpload(evaluator, 11 * kMiB)) << "the device tells no budget";
  const auto refused = makeUpload(evaluator, std::uint64_t{1} << 50U);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("the size of the device's heap"));
}

TEST_F(MemoryPoolTest, ATablesUploadPastTheBudgetIsAnErrorAndHoldsNothing) {
  auto evaluator = makeEvaluator({.maxDeviceBytes = 1000});
  const Far::LevelTable level = honeycomb::Test::randomTable({.sourceCount = 300, .circulants = {{6, 60}}});
  const auto refused = evaluator.upload(std::vector{&level}, nullptr);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::outOfMemory);
  EXPECT_EQ(usageOf(evaluator).blocks, 0U);
}

}  // namespace
}  // namespace honeycomb::VulkanTests
