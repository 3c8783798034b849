// Every access of the kernels checked on the device itself, with robustBufferAccess off.
#include <gmock/gmock.h>

#include "fixture.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using honeycomb::Test::must;
using honeycomb::Test::randomLimits;
using honeycomb::Test::randomNumbers;
using honeycomb::Test::randomTable;

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

// Every kernel: small and large faces, rows of both kinds, limits.
std::vector<Far::LevelTable> everyBatch() {
  return {randomTable(
      {.sourceCount = 300, .circulants = {{6, 60}, {20, 3}}, .projected = {80}, .dense = {{4, 30}}, .looseRows = 20})};
}

// What validation says of a frame; nothing is said where it can't check.
std::vector<std::string> messagesOf(const std::vector<Far::LevelTable>& levels) {
  auto context = must(Osd::VulkanContext::create({.deviceValidation = true}));
  {
    auto evaluator = must(Osd::VulkanEvaluator::create(context.device()));
    Far::LimitTable limits;
    limits.faces = randomLimits(levels.back().targetCount, {{4, 100}});
    const Osd::BufferDescriptor packed;
    auto session = must(Osd::VulkanSession::create(
        evaluator, must(evaluator.upload(pointersTo(levels), &limits, {.faceLimits = {packed, packed}}))));
    const auto control = randomNumbers(900);
    std::ranges::copy(control, session.control().begin());
    must(session.run());
  }
  return context.messages();
}

// The layer is missing, or too old to check on this device: then it says so itself when a device is made.
std::string whyNot() {
  const auto context = Osd::VulkanContext::create({.deviceValidation = true});
  if (!context) return context.error().message;
  const auto messages = context->messages();
  return messages.empty() ? "" : messages.front();
}

TEST(DeviceValidation, NoKernelReadsOrWritesPastItsBuffers) {
  if (const std::string why = whyNot(); !why.empty()) GTEST_SKIP() << why;
  EXPECT_THAT(messagesOf(everyBatch()), IsEmpty());
}

TEST(DeviceValidation, AReadPastTheControlPointsIsReported) {
  if (const std::string why = whyNot(); !why.empty()) GTEST_SKIP() << why;
  std::vector<Far::LevelTable> levels = everyBatch();
  levels[0].indices.edit()[5] = levels[0].sourceCount;
  EXPECT_THAT(messagesOf(levels), Contains(HasSubstr("out of bounds")));
}

TEST(DeviceValidation, AWritePastTheRefinedPointsIsReported) {
  if (const std::string why = whyNot(); !why.empty()) GTEST_SKIP() << why;
  std::vector<Far::LevelTable> levels = everyBatch();
  levels[0].loose.outputs[3] = levels[0].targetCount;
  EXPECT_THAT(messagesOf(levels), Contains(HasSubstr("out of bounds")));
}

}  // namespace
}  // namespace honeycomb::VulkanTests
