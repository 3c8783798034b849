// A test of the tests: that validation hears what is wrong. Synchronization validation of 1.3.239 doesn't report
// writes after writes between dispatches, but reads after writes, which is what levels do.
#include <gmock/gmock.h>

#include <array>
#include <cstddef>

#include "fixture.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Test::randomTable;

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> messagesOf(const Osd::VulkanEvaluatorOptions& options,
                                    const std::vector<Far::LevelTable>& levels) {
  auto context = Osd::VulkanContext::create({.validation = true});
  if (!context) throw std::runtime_error(context.error().message);
  auto evaluator = Osd::VulkanEvaluator::create(context->device(), options);
  if (!evaluator) throw std::runtime_error(evaluator.error().message);
  auto session = Osd::VulkanSession::create(*evaluator, *evaluator->upload(pointersTo(levels), nullptr));
  if (!session) throw std::runtime_error(session.error().message);
  if (const auto ran = session->run(); !ran) throw std::runtime_error(ran.error().message);
  return context->messages();
}

bool layerMissing() {
  const auto context = Osd::VulkanContext::create({.validation = true});
  return !context && context.error().code == ErrorCode::unsupported;
}

const std::vector<Far::LevelTable> kLevels{randomTable({.sourceCount = 300, .circulants = {{6, 60}}}, 1),
                                           randomTable({.sourceCount = 360, .circulants = {{5, 108}}}, 2)};
const std::vector<Far::LevelTable> kLargeFace{randomTable({.sourceCount = 300, .projected = {700}}, 1)};

TEST(SynchronizationTest, AMissingBarrierBetweenLevelsIsReported) {
  if (layerMissing()) GTEST_SKIP() << "VK_LAYER_KHRONOS_validation isn't installed";
  EXPECT_THAT(messagesOf({.leaveOutBarriers = true}, kLevels), Contains(HasSubstr("SYNC-HAZARD-READ-AFTER-WRITE")));
}

TEST(SynchronizationTest, AMissingBarrierBetweenTheStepsOfALargeFaceIsReported) {
  if (layerMissing()) GTEST_SKIP() << "VK_LAYER_KHRONOS_validation isn't installed";
  EXPECT_THAT(messagesOf({.leaveOutBarriers = true}, kLargeFace), Contains(HasSubstr("SYNC-HAZARD-READ-AFTER-WRITE")));
}

TEST(SynchronizationTest, WithTheBarriersNothingIsReported) {
  if (layerMissing()) GTEST_SKIP() << "VK_LAYER_KHRONOS_validation isn't installed";
  EXPECT_THAT(messagesOf({}, kLevels), IsEmpty());
  EXPECT_THAT(messagesOf({}, kLargeFace), IsEmpty());
  EXPECT_THAT(messagesOf({.stageEverything = true}, kLevels), IsEmpty());
}

// Memory for an object that is never destroyed, so that the test itself leaks nothing.
struct Arena {
  alignas(64) std::array<std::byte, 4096> bytes{};
  std::size_t used = 0;

  static void* allocate(void* arena, std::size_t size, std::size_t, VkSystemAllocationScope) {
    auto* self = static_cast<Arena*>(arena);
    const std::size_t place = self->used;
    self->used += (size + 63) / 64 * 64;
    return self->used <= self->bytes.size() ? self->bytes.data() + place : nullptr;
  }
  static void* reallocate(void*, void*, std::size_t, std::size_t, VkSystemAllocationScope) { return nullptr; }
  static void free(void*, void*) {}
  VkAllocationCallbacks callbacks() { return {this, allocate, reallocate, free, nullptr, nullptr}; }
};

TEST(SynchronizationTest, ALeakedObjectIsReportedWhenTheDeviceIsDestroyed) {
  if (layerMissing()) GTEST_SKIP() << "VK_LAYER_KHRONOS_validation isn't installed";
  auto context = Osd::VulkanContext::create({.validation = true});
  ASSERT_TRUE(context) << context.error().message;
  const auto functions = Osd::VulkanFunctions::load(context->device());
  ASSERT_TRUE(functions) << functions.error().message;
  VkFenceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  Arena arena;
  const VkAllocationCallbacks callbacks = arena.callbacks();
  VkFence leaked = VK_NULL_HANDLE;
  ASSERT_EQ(functions->vkCreateFence(context->device().device, &info, &callbacks, &leaked), VK_SUCCESS);
  const auto log = context->validationLog();
  { const Osd::VulkanContext ended = std::move(*context); }
  EXPECT_THAT(log->messages(), Contains(HasSubstr("has not been destroyed")));
}

}  // namespace
}  // namespace honeycomb::VulkanTests
