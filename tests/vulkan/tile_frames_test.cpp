// Tiles in frames in flight: their bits, what a frame allocates, and every call that fails on the way there.
#include <gmock/gmock.h>

#include <deque>
#include <map>
#include <string>

#include "counting_callbacks.h"
#include "osd/tile_evaluator.h"
#include "osd/vulkan/frames.h"
#include "spy.h"
#include "tile_fixture.h"

namespace honeycomb::VulkanTests {
namespace {

using Osd::PointBuffer;

// A table with all that tiles come with: a level before them, faces too large for them, normals, a scratch buffer.
class TileFramesTest : public TilesTest {
 protected:
  TileFramesTest()
      : tiles(must(Far::buildTileTable(refinement, {.scratchPoints = 300, .normals = Far::TileNormalKind::fast}))) {}

  Result<Osd::VulkanFrames> open(Osd::VulkanEvaluator& on, std::uint32_t inFlight) const {
    const auto table = on.uploadTiles(refinement, tiles, optionsOf(run));
    if (!table) return tl::unexpected(table.error());
    return Osd::VulkanFrames::create(on, *table, {.framesInFlight = inFlight, .frame = {.timing = true}});
  }

  /// Of a frame that has been waited for.
  testing::AssertionResult right(const Osd::VulkanFrames& frames, const Osd::VulkanTicket& ticket,
                                 const std::vector<float>& pose) const {
    const Osd::FrameSlot& slot = *must(frames.results(ticket));
    const std::vector<float> points = chained(refinement, 3, run.layouts, pose);
    if (auto same = sameBits(points, slot.numbers(PointBuffer::refined)); !same) return same << ", points";
    return sameBits(chainedNormals(refinement, run, pose, points), slot.numbers(PointBuffer::vertexNormals))
           << ", normals";
  }

  /// Two frames with the times of the second, and whether they are right; the first error.
  Result<void> play(Osd::VulkanEvaluator& on) const {
    auto frames = open(on, 2);
    if (!frames) return tl::unexpected(frames.error());
    Osd::VulkanTicket ticket;
    for (int frame = 0; frame < 2; ++frame) {
      const auto sent = frames->submit(control);
      if (!sent) return tl::unexpected(sent.error());
      ticket = *sent;
    }
    if (const auto done = frames->wait(ticket); !done) return done;
    EXPECT_TRUE(right(*frames, ticket, control));
    const auto times = must(frames->results(ticket))->binding().levelTimes();
    if (!times) return tl::unexpected(times.error());
    return {};
  }

  const Far::Refinement refinement = aklemanOf(Meshes::prism(150), 3);
  const Far::TileTable tiles;
  const TileRun run{.kind = Far::TileNormalKind::fast, .normals = kNormals[0]};
  const std::vector<float> control = controlOf(refinement, run.layouts, 1);
};

TEST_F(TileFramesTest, GiveTheBitsOfOneFrameAfterAnother) {
  ASSERT_FALSE(tiles.shared.empty());
  ASSERT_GT(tiles.tiles.size(), 1U);
  auto frames = must(open(*evaluator, 3));
  std::deque<std::pair<Osd::VulkanTicket, std::vector<float>>> onTheWay;
  for (std::uint32_t frame = 0; frame < 7; ++frame) {
    if (onTheWay.size() == 3) {
      must(frames.wait(onTheWay.front().first));
      EXPECT_TRUE(right(frames, onTheWay.front().first, onTheWay.front().second)) << frame;
      onTheWay.pop_front();
    }
    const std::vector<float> pose = controlOf(refinement, run.layouts, frame);
    onTheWay.emplace_back(must(frames.submit(pose)), pose);
  }
  must(frames.wait(onTheWay.back().first));
  for (const auto& [ticket, pose] : onTheWay) EXPECT_TRUE(right(frames, ticket, pose));
}

TEST_F(TileFramesTest, AllocateNothingOnceTheyAreWarm) {
  // What the driver allocates for itself comes from the callbacks the device was made with: those are none.
  CountingCallbacks counting;
  Osd::VulkanDevice device = context->device();
  device.allocator = counting.callbacks();
  auto on = must(Osd::VulkanEvaluator::create(device));
  auto frames = must(open(on, 3));
  for (int frame = 0; frame < 4; ++frame) must(frames.submit(control));
  const std::int64_t before = counting.calls();
  EXPECT_GT(before, 0);
  Osd::VulkanTicket ticket;
  for (int frame = 0; frame < 12; ++frame) ticket = must(frames.submit(control));
  must(frames.wait(ticket));
  EXPECT_EQ(counting.calls(), before);
}

struct Fault {
  const char* name;
  VkResult result;
  ErrorCode code;
};

class TileFaultsTest : public TileFramesTest, public testing::WithParamInterface<Fault> {};

TEST_P(TileFaultsTest, EachCallThatFailsIsAnErrorAndLeavesNothingBehind) {
  Spy spy(context->device());
  auto on = must(Osd::VulkanEvaluator::create(spy.device(), {.stageEverything = true}));
  must(play(on));
  // What stays is the evaluator's, pipelines included: all others compile nothing.
  const std::int64_t resting = spy.alive();
  std::map<std::string, int> failed;
  for (const std::string& function : Spy::fallible()) {
    for (int call = 1;; ++call, ++failed[function]) {
      spy.fail(function, call, GetParam().result);
      const auto played = play(on);
      EXPECT_EQ(spy.alive(), resting) << function << " " << call;
      if (!spy.struck()) break;
      // A smaller block of memory is tried, and a destructor has nobody to tell that its wait failed.
      const bool recovers =
          function == "vkAllocateMemory" || function == "vkMapMemory" || function == "vkWaitSemaphores";
      EXPECT_TRUE(!played || recovers) << function << " " << call;
      EXPECT_EQ(played ? GetParam().code : played.error().code, GetParam().code) << function << " " << call;
    }
  }
  EXPECT_EQ(failed["vkCreateBufferView"], 3) << "the table, and in each frame the tiles' points";
  for (const char* one : {"vkCreateBuffer", "vkBindBufferMemory", "vkCreateDescriptorPool", "vkQueueSubmit",
                          "vkCreateQueryPool", "vkGetQueryPoolResults", "vkWaitForFences", "vkWaitSemaphores"}) {
    EXPECT_GT(failed[one], 0) << one;
  }
  spy.fail("none", 1, VK_SUCCESS);
  must(play(on));
}

INSTANTIATE_TEST_SUITE_P(All, TileFaultsTest,
                         testing::Values(Fault{"DeviceLost", VK_ERROR_DEVICE_LOST, ErrorCode::deviceLost},
                                         Fault{"OutOfHostMemory", VK_ERROR_OUT_OF_HOST_MEMORY, ErrorCode::outOfMemory}),
                         [](const testing::TestParamInfo<Fault>& one) { return one.param.name; });

TEST_F(TileFramesTest, AfterALostDeviceTheCpuGoesOnAndTheTilesAreUploadedToANewOne) {
  {
    Spy spy(context->device());
    auto lost = must(Osd::VulkanEvaluator::create(spy.device()));
    spy.fail("vkQueueSubmit", 2, VK_ERROR_DEVICE_LOST);
    const auto played = play(lost);
    ASSERT_FALSE(played);
    EXPECT_EQ(played.error().code, ErrorCode::deviceLost);
  }
  std::vector<float> points(at(run.layouts.refined.extent(refinement.last().pointCount()))), normals(points);
  must(Osd::TileEvaluator().evaluate<float>(refinement, tiles, 3, {control, {}}, {points, {}},
                                            {.normals = {normals, {}}}));
  EXPECT_TRUE(sameBits(chained(refinement, 3, run.layouts, control), points));
  EXPECT_TRUE(sameBits(chainedNormals(refinement, run, control, points), normals));
  auto another = must(Osd::VulkanContext::create({.validation = validationWanted()}));
  {
    auto on = must(Osd::VulkanEvaluator::create(another.device()));
    must(play(on));
  }
  EXPECT_THAT(another.messages(), testing::IsEmpty());
}

TEST_F(TileFramesTest, APipelineThatCantBeCompiledIsAnErrorAndIsTriedAgain) {
  Spy spy(context->device());
  auto on = must(Osd::VulkanEvaluator::create(spy.device()));
  int failures = 0;
  for (;; ++failures) {
    const std::int64_t before = spy.alive();
    spy.fail("vkCreateComputePipelines", failures % 2 + 1, VK_ERROR_OUT_OF_DEVICE_MEMORY);
    const auto table = on.uploadTiles(refinement, tiles, optionsOf(run));
    if (!spy.struck()) break;
    ASSERT_FALSE(table);
    EXPECT_EQ(table.error().code, ErrorCode::outOfMemory);
    EXPECT_EQ(spy.alive(), before + failures % 2) << "the pipelines that were compiled are kept";
  }
  EXPECT_GT(failures, 1);
  must(play(on));
}

}  // namespace
}  // namespace honeycomb::VulkanTests
