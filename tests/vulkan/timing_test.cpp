// What each level took, by the device's own clock.
#include <gmock/gmock.h>

#include "fixture.h"
#include "osd/vulkan/frames.h"
#include "osd/vulkan/loader.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Test::randomLimits;
using Test::randomNumbers;
using Test::randomTable;
using testing::HasSubstr;

class TimingTest : public VulkanTest {
 protected:
  // The second level is a hundred times the first; a large face takes three steps, which are one level.
  const std::vector<Far::LevelTable> levels{
      randomTable({.sourceCount = 300, .circulants = {{6, 60}}, .projected = {700}}, 1),
      randomTable({.sourceCount = 1060, .circulants = {{6, 100000}}}, 2)};

  Osd::VulkanTable table(Osd::VulkanEvaluator& evaluator, const Far::LimitTable* limits = nullptr,
                         const Osd::VulkanTableOptions& options = {}) const {
    auto uploaded = evaluator.upload(pointersTo(levels), limits, options);
    if (!uploaded) throw std::runtime_error(uploaded.error().message);
    return std::move(*uploaded);
  }
};

TEST_F(TimingTest, EveryLevelHasATime) {
  auto evaluator = makeEvaluator();
  auto session = Osd::VulkanSession::create(evaluator, table(evaluator), {.timing = true});
  ASSERT_TRUE(session) << session.error().message;
  for (int frame = 0; frame < 3; ++frame) {
    ASSERT_TRUE(session->run());
    const auto times = session->binding().levelTimes();
    ASSERT_TRUE(times) << times.error().message;
    ASSERT_EQ(times->size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ((*times)[i].level, static_cast<std::int32_t>(i) + 1);
      EXPECT_FALSE((*times)[i].limits);
      EXPECT_GT((*times)[i].milliseconds, 0);
      EXPECT_LT((*times)[i].milliseconds, 60000);
    }
  }
}

TEST_F(TimingTest, LimitsAreTimedBesideTheirLevelAndLevelsAreCountedFromTheFirst) {
  auto evaluator = makeEvaluator();
  Far::LimitTable limits;
  limits.faces = randomLimits(levels.back().targetCount, {{4, 100}});
  const auto timed = table(evaluator, &limits, {.firstLevel = 3, .faceLimits = {Osd::BufferDescriptor{}, {}}});
  auto session = Osd::VulkanSession::create(evaluator, timed, {.timing = true});
  ASSERT_TRUE(session) << session.error().message;
  ASSERT_TRUE(session->run());
  const auto times = session->binding().levelTimes();
  ASSERT_TRUE(times) << times.error().message;
  ASSERT_EQ(times->size(), 3U);
  EXPECT_EQ((*times)[0].level, 4);
  EXPECT_EQ((*times)[2].level, 5);
  EXPECT_FALSE((*times)[1].limits);
  EXPECT_TRUE((*times)[2].limits);
}

TEST_F(TimingTest, TimedFramesInFlightHaveTimesOfTheirOwnAndTheSameBits) {
  auto evaluator = makeEvaluator();
  auto frames =
      Osd::VulkanFrames::create(evaluator, table(evaluator), {.framesInFlight = 2, .frame = {.timing = true}});
  ASSERT_TRUE(frames) << frames.error().message;
  const auto in = randomNumbers(900);
  const auto first = frames->submit(in), second = frames->submit(in);
  ASSERT_TRUE(first && second);
  ASSERT_TRUE(frames->wait(*second));
  for (const auto& ticket : {*first, *second}) {
    const Osd::FrameSlot& slot = **frames->results(ticket);
    EXPECT_TRUE(slot.binding().levelTimes());
    EXPECT_TRUE(sameBits(expectedPoints(levels, in, {}, {}), slot.numbers(Osd::PointBuffer::refined)));
  }
}

TEST_F(TimingTest, WithoutTimingOrBeforeAFrameThereAreNoTimes) {
  auto evaluator = makeEvaluator();
  auto untimed = *Osd::VulkanSession::create(evaluator, table(evaluator));
  ASSERT_TRUE(untimed.run());
  const auto off = untimed.binding().levelTimes();
  ASSERT_FALSE(off);
  EXPECT_THAT(off.error().message, HasSubstr("VulkanBindingOptions::timing"));
  auto timed = *Osd::VulkanSession::create(evaluator, table(evaluator), {.timing = true});
  const auto early = timed.binding().levelTimes();
  ASSERT_FALSE(early);
  EXPECT_EQ(early.error().code, ErrorCode::invalidOption);
}

// A device whose queue writes no timestamps.
VKAPI_ATTR void VKAPI_CALL familiesWithoutTimestamps(VkPhysicalDevice, std::uint32_t* count,
                                                     VkQueueFamilyProperties* families) {
  *count = 1;
  if (families != nullptr) families[0] = {VK_QUEUE_COMPUTE_BIT, 1, 0, {1, 1, 1}};
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL withoutTimestamps(VkInstance instance, const char* name) {
  if (std::string_view(name) == "vkGetPhysicalDeviceQueueFamilyProperties")
    return reinterpret_cast<PFN_vkVoidFunction>(familiesWithoutTimestamps);
  return (*Osd::loadVulkan())(instance, name);
}

TEST_F(TimingTest, AQueueWithoutTimestampsIsAnErrorThatSaysSo) {
  Osd::VulkanDevice device = context->device();
  device.getInstanceProcAddr = withoutTimestamps;
  auto evaluator = Osd::VulkanEvaluator::create(device);
  ASSERT_TRUE(evaluator) << evaluator.error().message;
  const auto refused = Osd::VulkanSession::create(*evaluator, table(*evaluator), {.timing = true});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_THAT(refused.error().message, HasSubstr("has no timestamps"));
  EXPECT_TRUE(Osd::VulkanSession::create(*evaluator, table(*evaluator)));
}

}  // namespace
}  // namespace honeycomb::VulkanTests
