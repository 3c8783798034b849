// Every call that can fail is made to: an error, nothing left behind, and the way on.
#include <gmock/gmock.h>

#include "fixture.h"
#include "osd/cpu_evaluator.h"
#include "osd/vulkan/memory_pool.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "spy.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using honeycomb::Test::must;
using honeycomb::Test::randomLimits;
using honeycomb::Test::randomNumbers;
using honeycomb::Test::randomTable;

using testing::HasSubstr;

// Large faces, whose steps need scratch, and limits, so that every kind of buffer is there.
struct Scene {
  std::vector<Far::LevelTable> levels{
      randomTable({.sourceCount = 300, .circulants = {{6, 60}}, .looseRows = 20}, 1),
      randomTable({.sourceCount = 380, .circulants = {{5, 108}}, .projected = {80}}, 2)};
  Far::LimitTable limits;
  std::vector<float> control = randomNumbers(900);
  std::vector<float> expected = expectedPoints(levels, control, {}, {});

  Scene() { limits.faces = randomLimits(levels.back().targetCount, {{4, 100}}); }
};

Result<Osd::VulkanSession> openSession(const Osd::VulkanDevice& device, const Osd::VulkanEvaluatorOptions& options,
                                       const Scene& scene) {
  auto evaluator = Osd::VulkanEvaluator::create(device, options);
  if (!evaluator) return tl::unexpected(evaluator.error());
  auto table =
      evaluator->upload(pointersTo(scene.levels), &scene.limits, {.faceLimits = {Osd::BufferDescriptor{}, {}}});
  if (!table) return tl::unexpected(table.error());
  return Osd::VulkanSession::create(*evaluator, std::move(*table));
}

// All that an evaluator does. A frame that fails is tried again, which must succeed.
Result<std::vector<float>> playTwoFrames(const Osd::VulkanDevice& device, const Osd::VulkanEvaluatorOptions& options,
                                         const Scene& scene) {
  auto session = openSession(device, options, scene);
  if (!session) return tl::unexpected(session.error());
  std::vector<float> refined(session->refined().size());
  for (int frame = 0; frame < 2; ++frame) {
    const auto ran = session->refine(scene.control, refined);
    if (ran) continue;
    must(session->refine(scene.control, refined));
    EXPECT_TRUE(sameBits(scene.expected, refined)) << "after a frame that failed";
    return tl::unexpected(ran.error());
  }
  return refined;
}

struct FaultCase {
  const char* name;
  Osd::VulkanEvaluatorOptions options;
  VkResult result;
  ErrorCode code;
};

class FaultsTest : public VulkanTest, public testing::WithParamInterface<FaultCase> {
 protected:
  // The calls of one function fail one after the other; returns how many there are.
  int failEachCallOf(const std::string& function) {
    for (int call = 1;; ++call) {
      Spy spy(context->device());
      spy.fail(function, call, GetParam().result);
      const auto refined = playTwoFrames(spy.device(), GetParam().options, scene);
      EXPECT_EQ(spy.alive(), 0) << function << " " << call;
      if (!spy.struck()) return call - 1;
      expectErrorOrRecovery(refined, function, call);
    }
  }

  // Where no whole block of memory is to be had, the buffer alone is asked for.
  void expectErrorOrRecovery(const Result<std::vector<float>>& refined, const std::string& function, int call) {
    if (!refined) {
      EXPECT_EQ(refined.error().code, GetParam().code) << function << " " << call << ": " << refined.error().message;
      return;
    }
    EXPECT_TRUE(function == "vkAllocateMemory" || function == "vkMapMemory") << function << " " << call;
    EXPECT_TRUE(sameBits(scene.expected, *refined)) << function << " " << call;
  }

  const Scene scene;
};

TEST_P(FaultsTest, EachCallThatFailsIsAnErrorAndLeavesNothingBehind) {
  int calls = 0;
  for (const std::string& function : Spy::fallible()) calls += failEachCallOf(function);
  EXPECT_GT(calls, 30) << "calls that can fail in two frames";
}

INSTANTIATE_TEST_SUITE_P(
    All, FaultsTest,
    testing::Values(FaultCase{"DeviceLost", {.stageEverything = true}, VK_ERROR_DEVICE_LOST, ErrorCode::deviceLost},
                    FaultCase{"OutOfDeviceMemory",
                              {.stageEverything = true},
                              VK_ERROR_OUT_OF_DEVICE_MEMORY,
                              ErrorCode::outOfMemory},
                    FaultCase{"OutOfHostMemory", {}, VK_ERROR_OUT_OF_HOST_MEMORY, ErrorCode::outOfMemory}),
    [](const testing::TestParamInfo<FaultCase>& one) { return one.param.name; });

class OneFaultTest : public VulkanTest {
 protected:
  const Scene scene;
};

TEST_F(OneFaultTest, MemoryThatCantBeMappedIsAnError) {
  Spy spy(context->device());
  // No room for more than the buffer itself, so that there is no second try.
  auto evaluator = must(Osd::VulkanEvaluator::create(spy.device(), {.maxDeviceBytes = 1 << 20}));
  spy.fail("vkMapMemory", 1, VK_ERROR_MEMORY_MAP_FAILED);
  const auto refused =
      Osd::VulkanBuffer::create(evaluator.core(), 4096, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Osd::MemoryUse::upload);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::outOfMemory);
  EXPECT_THAT(refused.error().message, HasSubstr("failed to map memory: VK_ERROR_MEMORY_MAP_FAILED"));
  EXPECT_EQ(evaluator.core()->pool->usage().blocks, 0U);
}

TEST_F(OneFaultTest, APipelineThatCantBeCompiledIsAnErrorAndIsTriedAgain) {
  Spy spy(context->device());
  auto evaluator = must(Osd::VulkanEvaluator::create(spy.device()));
  spy.fail("vkCreateComputePipelines", 2, VK_ERROR_INVALID_SHADER_NV);
  const auto refused = evaluator.upload(pointersTo(scene.levels), nullptr);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_THAT(refused.error().message, HasSubstr("create a compute pipeline: VK_ERROR_INVALID_SHADER_NV"));
  EXPECT_TRUE(agrees(evaluator, scene.levels, {}, {}));
}

TEST_F(OneFaultTest, AFunctionThatIsMissingIsNamed) {
  const auto expectNamed = [this](const char* name) {
    Spy spy(context->device());
    spy.hide(name);
    const auto refused = Osd::VulkanEvaluator::create(spy.device());
    ASSERT_FALSE(refused) << name;
    EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
    EXPECT_THAT(refused.error().message, HasSubstr(std::string("no function ") + name + ":"));
  };
#define HONEYCOMB_EXPECT(name) expectNamed(#name);
  HONEYCOMB_VULKAN_INSTANCE_FUNCTIONS(HONEYCOMB_EXPECT)
  HONEYCOMB_VULKAN_DEVICE_FUNCTIONS(HONEYCOMB_EXPECT)
#undef HONEYCOMB_EXPECT
}

TEST_F(OneFaultTest, AfterALostDeviceTheCpuGoesOnAndAnEvaluatorIsBuiltOnANewDevice) {
  auto lost = std::make_unique<Spy>(context->device());
  lost->fail("vkQueueSubmit", 2, VK_ERROR_DEVICE_LOST);
  const auto refined = playTwoFrames(lost->device(), {}, scene);
  ASSERT_FALSE(refined);
  EXPECT_EQ(refined.error().code, ErrorCode::deviceLost);
  lost.reset();
  const Far::Refinement refinement({{{}, {}}, {{}, scene.levels[0]}, {{}, scene.levels[1]}}, {});
  std::vector<float> onCpu(scene.expected.size());
  must(Osd::SerialEvaluator().evaluate<float>(refinement, 2, {scene.control, {}}, {onCpu, {}}));
  EXPECT_TRUE(sameBits(scene.expected, onCpu));
  auto another = must(Osd::VulkanContext::create({.validation = validationWanted()}));
  const auto again = playTwoFrames(another.device(), {}, scene);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_TRUE(sameBits(scene.expected, *again));
  EXPECT_THAT(another.messages(), testing::IsEmpty());
}

}  // namespace
}  // namespace honeycomb::VulkanTests
