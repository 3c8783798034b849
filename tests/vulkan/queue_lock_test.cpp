// A queue that several threads use: what is submitted to it takes turns with what its owner submits.
#include <gmock/gmock.h>

#include <future>
#include <string_view>

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

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProc(VkDevice device, const char* name) {
  const PFN_vkVoidFunction real = realDeviceProc(device, name);
  if (name != std::string_view("vkQueueSubmit")) return real;
  realSubmit = reinterpret_cast<PFN_vkQueueSubmit>(real);
  return reinterpret_cast<PFN_vkVoidFunction>(countedSubmit);
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

class QueueLockTest : public VulkanTest {
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

TEST_F(QueueLockTest, IsTakenAroundEverySubmissionAndNothingElse) {
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

TEST_F(QueueLockTest, OneFunctionOfTwoIsRefused) {
  Osd::VulkanDevice device = context->device();
  device.queueLock.give = nullptr;
  const auto refused = Osd::VulkanEvaluator::create(device);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
  EXPECT_THAT(refused.error().message, HasSubstr("give both"));
}

// On the `validation` preset its checks of threads see a queue that two use at once.
TEST_F(QueueLockTest, OneThreadUploadsWhileAnotherSubmitsFrames) {
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

}  // namespace
}  // namespace honeycomb::VulkanTests
