// A device that several threads use: submissions take turns, and nothing waits for what another thread compiles.
#include <gmock/gmock.h>

#include <chrono>
#include <future>
#include <string_view>
#include <utility>

#include "fixture.h"
#include "osd/vulkan/frames.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Test::must;
using Test::randomNumbers;
using Test::randomTable;
using testing::HasSubstr;

constexpr int kRounds = 12;

/// Counts the turns that are taken, and the submissions that are made in one and out of one.
struct Turns {
  int taken = 0, within = 0, outside = 0;
  bool mine = false;
};
Turns turns;
PFN_vkQueueSubmit realSubmit = nullptr;
PFN_vkGetDeviceProcAddr realDeviceProc = nullptr;

VKAPI_ATTR VkResult VKAPI_CALL countedSubmit(VkQueue queue, std::uint32_t count, const VkSubmitInfo* infos,
                                             VkFence fence) {
  ++(turns.mine ? turns.within : turns.outside);
  return realSubmit(queue, count, infos, fence);
}

/// A driver that is still compiling when it is told to go on, or after a minute.
struct Compiler {
  bool slow = false;
  std::promise<void> begun;
  std::promise<void> goOn;
};
Compiler* compiler = nullptr;
PFN_vkCreateComputePipelines realCompile = nullptr;

VKAPI_ATTR VkResult VKAPI_CALL slowCompile(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                                           const VkComputePipelineCreateInfo* infos,
                                           const VkAllocationCallbacks* allocator, VkPipeline* made) {
  if (compiler != nullptr && std::exchange(compiler->slow, false)) {
    compiler->begun.set_value();
    compiler->goOn.get_future().wait_for(std::chrono::minutes(1));
  }
  return realCompile(device, cache, count, infos, allocator, made);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProc(VkDevice device, const char* name) {
  const PFN_vkVoidFunction real = realDeviceProc(device, name);
  if (name == std::string_view("vkQueueSubmit")) {
    realSubmit = reinterpret_cast<PFN_vkQueueSubmit>(real);
    return reinterpret_cast<PFN_vkVoidFunction>(countedSubmit);
  }
  if (name == std::string_view("vkCreateComputePipelines")) {
    realCompile = reinterpret_cast<PFN_vkCreateComputePipelines>(real);
    return reinterpret_cast<PFN_vkVoidFunction>(slowCompile);
  }
  return real;
}

/// The device with turns that are counted.
Osd::VulkanDevice watched(Osd::VulkanDevice device) {
  turns = {};
  const auto find =
      reinterpret_cast<PFN_vkGetDeviceProcAddr>(device.getInstanceProcAddr(device.instance, "vkGetDeviceProcAddr"));
  realDeviceProc = find;
  device.getDeviceProcAddr = deviceProc;
  device.queueLock = {[](void* all) {
                        ++static_cast<Turns*>(all)->taken;
                        static_cast<Turns*>(all)->mine = true;
                      },
                      [](void* all) { static_cast<Turns*>(all)->mine = false; }, &turns};
  return device;
}

class SharingTest : public VulkanTest {
 protected:
  const std::vector<Far::LevelTable> levels{randomTable({.sourceCount = 300, .circulants = {{6, 60}}}, 1),
                                            randomTable({.sourceCount = 360, .circulants = {{5, 108}}}, 2)};

  Osd::VulkanTable table(Osd::VulkanEvaluator& evaluator) const {
    return must(evaluator.upload(pointersTo(levels), nullptr));
  }
  /// Uploads the tables and refines with them, once and again; the first that isn't right.
  testing::AssertionResult uploads(Osd::VulkanEvaluator evaluator) const {
    for (int i = 0; i < kRounds; ++i) {
      auto session = must(Osd::VulkanSession::create(evaluator, table(evaluator)));
      const std::vector<float> control = randomNumbers(900, static_cast<std::uint32_t>(i));
      std::ranges::copy(control, session.control().begin());
      must(session.run());
      if (auto same = sameBits(expectedPoints(levels, control, {}, {}), session.refined()); !same) return same;
    }
    return testing::AssertionSuccess();
  }
};

TEST_F(SharingTest, TheQueuesLockIsTakenAroundEverySubmissionAndNothingElse) {
  auto evaluator = must(Osd::VulkanEvaluator::create(watched(context->device()), {.stageEverything = true}));
  const auto uploaded = table(evaluator);
  const int uploads = turns.within;
  EXPECT_GT(uploads, 0);
  auto session = must(Osd::VulkanSession::create(evaluator, uploaded));
  must(session.run());
  const int runs = turns.within;
  EXPECT_GT(runs, uploads);
  auto frames = must(Osd::VulkanFrames::create(evaluator, uploaded));
  const auto ticket = must(frames.submit(randomNumbers(900, 1)));
  must(frames.wait(ticket));
  EXPECT_GT(turns.within, runs);
  EXPECT_EQ(turns.outside, 0);
  EXPECT_EQ(turns.taken, turns.within);
  EXPECT_FALSE(turns.mine) << "given back";
}

TEST_F(SharingTest, OneFunctionOfTwoOfALockIsRefused) {
  Osd::VulkanDevice device = context->device();
  device.queueLock.give = nullptr;
  const auto refused = Osd::VulkanEvaluator::create(device);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
  EXPECT_THAT(refused.error().message, HasSubstr("give both"));
}

// On the `validation` preset its checks of threads see a queue that two use at once.
TEST_F(SharingTest, OneThreadUploadsWhileAnotherSubmitsFrames) {
  ASSERT_TRUE(context->device().queueLock.given()) << "a context's queue is ready to be shared";
  auto evaluator = makeEvaluator({.stageEverything = true});
  auto frames = must(Osd::VulkanFrames::create(evaluator, table(evaluator)));
  auto uploading = std::async(std::launch::async, [&] { return uploads(evaluator); });
  const auto submitted = [&](std::uint32_t seed) -> testing::AssertionResult {
    const auto ticket = must(frames.submit(randomNumbers(900, seed)));
    must(frames.wait(ticket));
    return sameBits(expectedPoints(levels, randomNumbers(900, seed), {}, {}),
                    must(frames.results(ticket))->numbers(Osd::PointBuffer::refined));
  };
  for (std::uint32_t i = 0; i < 5 * kRounds; ++i) EXPECT_TRUE(submitted(i)) << "frame " << i;
  EXPECT_TRUE(uploading.get());
}

TEST_F(SharingTest, FramesAreRecordedAndSubmittedWhileAnotherTableIsCompiled) {
  Compiler driver;
  compiler = &driver;
  auto evaluator = must(Osd::VulkanEvaluator::create(watched(context->device())));
  auto session = must(Osd::VulkanSession::create(evaluator, table(evaluator)));
  const Osd::VulkanTargets targets{.control = session.range(Osd::PointBuffer::control),
                                   .refined = session.range(Osd::PointBuffer::refined)};
  const std::vector<Far::LevelTable> others{randomTable({.sourceCount = 300, .circulants = {{9, 60}}}, 3)};
  const std::size_t before = evaluator.pipelineCount();
  driver.slow = true;
  auto compiling =
      std::async(std::launch::async, [&] { return evaluator.upload(pointersTo(others), nullptr).has_value(); });
  auto begun = driver.begun.get_future();
  ASSERT_EQ(begun.wait_for(std::chrono::minutes(1)), std::future_status::ready);
  must(session.run());
  EXPECT_TRUE(evaluator.bind(session.table(), targets));
  EXPECT_EQ(evaluator.pipelineCount(), before) << "it is being compiled still";
  driver.goOn.set_value();
  EXPECT_TRUE(compiling.get());
  EXPECT_GT(evaluator.pipelineCount(), before);
  compiler = nullptr;
}

}  // namespace
}  // namespace honeycomb::VulkanTests
