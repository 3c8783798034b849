// Frames in flight, timing and the file of pipelines: every call that can fail is made to.
#include <gmock/gmock.h>

#include <filesystem>

#include "fixture.h"
#include "osd/vulkan/frames.h"
#include "runs.h"
#include "spy.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using honeycomb::Test::must;
using honeycomb::Test::randomNumbers;
using honeycomb::Test::randomTable;

class FramesFaultsTest : public VulkanTest, public testing::WithParamInterface<VkResult> {
 protected:
  void SetUp() override {
    VulkanTest::SetUp();
    file = std::filesystem::path(testing::TempDir()) / ("frames_faults_" + std::to_string(-GetParam()) + ".bin");
    std::filesystem::remove(file);
  }
  void TearDown() override {
    std::filesystem::remove(file);
    VulkanTest::TearDown();
  }

  Result<Osd::VulkanFrames> open(const Osd::VulkanDevice& device) const {
    auto evaluator = Osd::VulkanEvaluator::create(device, {.pipelineCache = file, .stageEverything = true});
    if (!evaluator) return tl::unexpected(evaluator.error());
    const auto table = evaluator->upload(pointersTo(levels), nullptr);
    if (!table) return tl::unexpected(table.error());
    return Osd::VulkanFrames::create(*evaluator, *table, {.framesInFlight = 2, .frame = {.timing = true}});
  }

  /// Three frames in two slots. What fails is tried again, which must succeed; the first error is returned.
  Result<void> play(const Osd::VulkanDevice& device) const {
    auto frames = open(device);
    if (!frames) return tl::unexpected(frames.error());
    Result<void> first;
    const auto again = [&first](auto call) {
      auto result = call();
      if (!result && first) first = tl::unexpected(result.error());
      return result ? must(std::move(result)) : must(call());
    };
    Osd::VulkanTicket ticket;
    for (int frame = 0; frame < 3; ++frame) ticket = again([&] { return frames->submit(control); });
    again([&] { return frames->finished(ticket); });
    again([&] { return frames->wait(ticket).map([] { return true; }); });
    const Osd::FrameSlot& slot = *must(frames->results(ticket));
    EXPECT_EQ(again([&] { return slot.binding().levelTimes(); }).size(), levels.size());
    EXPECT_TRUE(sameBits(expectedPoints(levels, control, {}, {}), slot.numbers(Osd::PointBuffer::refined)));
    return first;
  }

  const std::vector<Far::LevelTable> levels{
      randomTable({.sourceCount = 300, .circulants = {{6, 60}}, .looseRows = 20}, 1),
      randomTable({.sourceCount = 380, .circulants = {{5, 108}}}, 2)};
  const std::vector<float> control = randomNumbers(900);
  std::filesystem::path file;
};

/// Whose failures go unnoticed: another way is tried, a file isn't written, or the frames end (the third wait).
bool recovers(const std::string& function, int call) {
  if (function == "vkWaitSemaphores") return call == 3;
  return function == "vkAllocateMemory" || function == "vkMapMemory" || function == "vkCreatePipelineCache" ||
         function == "vkGetPipelineCacheData";
}

TEST_P(FramesFaultsTest, EachCallThatFailsIsAnErrorAndLeavesNothingBehind) {
  int calls = 0;
  for (const std::string& function : Spy::fallible()) {
    for (int call = 1;; ++call, ++calls) {
      Spy spy(context->device());
      spy.fail(function, call, GetParam());
      const auto played = play(spy.device());
      EXPECT_EQ(spy.alive(), 0) << function << " " << call;
      if (!spy.struck()) break;
      EXPECT_TRUE(!played || recovers(function, call)) << function << " " << call;
    }
  }
  EXPECT_GT(calls, 40) << "calls that can fail in three frames";
}

INSTANTIATE_TEST_SUITE_P(All, FramesFaultsTest, testing::Values(VK_ERROR_DEVICE_LOST, VK_ERROR_OUT_OF_HOST_MEMORY),
                         [](const testing::TestParamInfo<VkResult>& one) {
                           return one.param == VK_ERROR_DEVICE_LOST ? "DeviceLost" : "OutOfHostMemory";
                         });

}  // namespace
}  // namespace honeycomb::VulkanTests
