// A host that waits for its own CPU asks while that is worth it, and sleeps else.
#include "osd/vulkan/cpu_wait.h"

#include <gtest/gtest.h>

#include <thread>

#include "fixture.h"
#include "osd/vulkan/commands.h"
#include "osd/vulkan/context.h"
#include "osd/vulkan/evaluator.h"
#include "spy.h"
#include "tests/support/must.h"

namespace honeycomb::VulkanTests {
namespace {

using honeycomb::Test::must;
using Osd::CpuWait;
using Osd::VulkanEvaluator;

constexpr auto kShortTurn = [] {};
constexpr auto kLongTurn = [] { std::this_thread::sleep_for(CpuWait::kLongTurn); };

TEST(CpuWaitTest, AsksUntilItIsDone) {
  CpuWait wait;
  int asked = 0;
  EXPECT_TRUE(wait.ask([&] { return ++asked == 5; }, kShortTurn));
  EXPECT_EQ(asked, 5);
}

TEST(CpuWaitTest, LetsTheCallerSleepOnceItHasTheProcessorToItself) {
  CpuWait wait;
  EXPECT_FALSE(wait.ask([] { return false; }, kShortTurn));
  EXPECT_TRUE(wait.ask([] { return true; }, kShortTurn)) << "the next wait asks again";
}

TEST(CpuWaitTest, SleepsForSomeWaitsBehindALongTurnOfOthers) {
  CpuWait wait;
  int asked = 0;
  EXPECT_FALSE(wait.ask([&] { return ++asked == 0; }, kLongTurn));
  EXPECT_EQ(asked, 1);
  for (std::uint32_t i = 0; i < CpuWait::kSleepingWaits; ++i) EXPECT_FALSE(wait.ask([] { return true; }, kShortTurn));
  EXPECT_TRUE(wait.ask([] { return true; }, kShortTurn));
}

TEST(CpuWaitTest, LeavesWhatAskingFailsWithToTheWait) {
  auto context = must(Osd::VulkanContext::create({.validation = validationWanted()}));
  Spy spy(context.device());
  const auto runner = must(VulkanEvaluator::create(spy.device()));
  auto commands = must(Osd::CommandRunner::create(runner.core()));
  must(commands.begin(0));
  must(commands.end());
  spy.fail("vkGetFenceStatus", 1, VK_ERROR_OUT_OF_HOST_MEMORY);
  must(commands.submit());
  must(commands.wait());
  EXPECT_TRUE(spy.struck());
}

}  // namespace
}  // namespace honeycomb::VulkanTests
