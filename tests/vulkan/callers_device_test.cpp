// On the terms of an engine that owns the device, the command buffer and the buffers; and several such side by side.
#include <gmock/gmock.h>

#include <thread>

#include "counting_callbacks.h"
#include "engine.h"
#include "fixture.h"
#include "osd/cpu_evaluator.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "spy.h"
#include "tests/support/must.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::VulkanTests {
namespace {

namespace Meshes = honeycomb::Test;  // inside of tests, Test is GoogleTest's class

using testing::IsEmpty;

Osd::VulkanDevice deviceOf(const Engine& engine) {
  Osd::VulkanDevice device;
  device.instance = engine.instance();
  device.physicalDevice = engine.physicalDevice();
  device.device = engine.device();
  device.queue = engine.queue();
  device.queueFamily = engine.queueFamily();
  device.getInstanceProcAddr = engine.getInstanceProcAddr();
  device.getDeviceProcAddr = engine.getDeviceProcAddr();
  return device;
}

struct Body {
  Meshes::PolyMesh mesh;
  Far::Refinement refinement;
  explicit Body(const Meshes::PolyMesh& polygons)
      : mesh(polygons), refinement(Meshes::refined(polygons, Meshes::schemeCase(0.6).scheme, 3)) {}
};

// The control points of a frame, and what the serial evaluator makes of them.
std::vector<float> poseOf(const Body& body, float frame) {
  std::vector<float> points = Meshes::pack<float>(body.mesh.points);
  for (float& one : points) one *= 1.0F + frame / 7.0F;
  return points;
}

std::vector<float> serialPoints(const Body& body, const std::vector<float>& control) {
  const std::int32_t level = body.refinement.levelCount();
  std::vector<float> refined(static_cast<std::size_t>(3 * body.refinement.level(level).topology.vertexCount()));
  Meshes::must(Osd::SerialEvaluator().evaluate<float>(body.refinement, level, {control, {}}, {refined, {}}));
  return refined;
}

// Some frames of the engine's, with its own buffers and command buffer; the first that differs from serial is named.
testing::AssertionResult playIn(Engine& engine, const Body& body, int frames) {
  auto evaluator = Meshes::must(Osd::VulkanEvaluator::create(deviceOf(engine)));
  const auto table = Meshes::must(evaluator.upload(body.refinement));
  const auto control = engine.makeBuffer(table.bytesOf(Osd::PointBuffer::control));
  const auto refined = engine.makeBuffer(table.bytesOf(Osd::PointBuffer::refined));
  const auto binding = Meshes::must(evaluator.bind(
      table, {.control = {control.buffer, 0, control.bytes}, .refined = {refined.buffer, 0, refined.bytes}}));
  for (int frame = 0; frame < frames; ++frame) {
    const std::vector<float> points = poseOf(body, static_cast<float>(frame));
    std::ranges::copy(points, control.numbers);
    engine.frame([&](VkCommandBuffer commands) { evaluator.record(commands, binding); });
    const std::vector<float> expected = serialPoints(body, points);
    if (auto same = sameBits(expected, {refined.numbers, expected.size()}); !same) return same << ", frame " << frame;
  }
  return testing::AssertionSuccess();
}

TEST(CallersDevice, RefinesInTheCallersCommandBuffer) {
  std::vector<std::string> messages;
  {
    Engine engine(validationWanted(), messages);
    EXPECT_TRUE(playIn(engine, Body(Meshes::torus(12, 10)), 3));
  }
  EXPECT_THAT(messages, IsEmpty());
}

TEST(CallersDevice, FunctionsComeFromTheMachinesLoaderWhereNoneAreGiven) {
  std::vector<std::string> messages;
  Engine engine(validationWanted(), messages);
  Osd::VulkanDevice device = deviceOf(engine);
  device.getInstanceProcAddr = nullptr;
  device.getDeviceProcAddr = nullptr;
  auto evaluator = Meshes::must(Osd::VulkanEvaluator::create(device));
  EXPECT_TRUE(agrees(evaluator, {Meshes::randomTable({.sourceCount = 300, .circulants = {{6, 60}}})}, {}, {}));
}

TEST(CallersDevice, TwoDevicesOnTwoThreads) {
  const std::array<Body, 2> bodies{Body(Meshes::torus(12, 10)), Body(Meshes::grid(20, 9))};
  std::array<testing::AssertionResult, 2> same{testing::AssertionFailure(), testing::AssertionFailure()};
  std::array<std::vector<std::string>, 2> messages;
  const auto play = [&](std::size_t i) {
    Engine engine(validationWanted(), messages[i]);
    same[i] = playIn(engine, bodies[i], 20);
  };
  std::thread first(play, 0), second(play, 1);
  first.join();
  second.join();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(same[i]) << "device " << i;
    EXPECT_THAT(messages[i], IsEmpty()) << "device " << i;
  }
}

TEST(CallersDevice, AllHostMemoryComesFromTheCallersCallbacks) {
  CountingCallbacks counting;
  std::vector<std::string> messages;
  {
    Engine engine(validationWanted(), messages);
    Osd::VulkanDevice device = deviceOf(engine);
    device.allocator = counting.callbacks();
    Spy spy(device);
    auto evaluator = Meshes::must(Osd::VulkanEvaluator::create(spy.device(), {.stageEverything = true}));
    const Body body(Meshes::torus(12, 10));
    auto session = Meshes::must(Osd::VulkanSession::create(evaluator, body.refinement));
    const std::vector<float> control = poseOf(body, 0.0F);
    std::vector<float> refined(session.refined().size());
    Meshes::must(session.refine(control, refined));
    EXPECT_TRUE(sameBits(serialPoints(body, control), refined));
    EXPECT_GT(counting.live(), 0);
    EXPECT_EQ(spy.strangers(), 0) << "calls with other callbacks than the caller's";
  }
  EXPECT_EQ(counting.live(), 0);
  EXPECT_THAT(messages, IsEmpty());
}

TEST(CallersDevice, AFrameAllocatesNothing) {
  CountingCallbacks counting;
  std::vector<std::string> messages;
  Engine engine(validationWanted(), messages);
  Osd::VulkanDevice device = deviceOf(engine);
  device.allocator = counting.callbacks();
  auto evaluator = Meshes::must(Osd::VulkanEvaluator::create(device));
  const Body body(Meshes::torus(12, 10));
  auto session = Meshes::must(Osd::VulkanSession::create(evaluator, body.refinement));
  const Osd::VulkanTargets targets{.control = session.range(Osd::PointBuffer::control),
                                   .refined = session.range(Osd::PointBuffer::refined)};
  const auto binding = Meshes::must(evaluator.bind(session.table(), targets));
  const auto frame = [&] {
    Meshes::must(session.run());
    engine.frame([&](VkCommandBuffer commands) { evaluator.record(commands, binding); });
  };
  frame();
  const std::int64_t before = counting.calls();
  for (int i = 0; i < 10; ++i) frame();
  EXPECT_EQ(counting.calls(), before);
}

TEST(CallersDevice, AContextTakesInstanceAndDeviceFromTheCallbacksToo) {
  CountingCallbacks counting;
  {
    const auto context = Osd::VulkanContext::create({.allocator = counting.callbacks()});
    ASSERT_TRUE(context) << context.error().message;
    EXPECT_EQ(context->device().allocator, counting.callbacks());
    EXPECT_GT(counting.live(), 0);
  }
  EXPECT_EQ(counting.live(), 0);
}

}  // namespace
}  // namespace honeycomb::VulkanTests
