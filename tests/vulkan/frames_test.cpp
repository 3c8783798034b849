// Several frames on their way: the bits of one after another, and an order that others can wait for.
#include "osd/vulkan/frames.h"

#include <gmock/gmock.h>

#include <chrono>
#include <deque>
#include <thread>

#include "fixture.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Osd::PointBuffer;
using Osd::VulkanFrames;
using Osd::VulkanFramesOptions;
using Osd::VulkanTicket;
using Test::randomNumbers;
using Test::randomTable;
using testing::HasSubstr;

class FramesTest : public VulkanTest {
 protected:
  // Three levels and a large face: both scratch buffers and the partial sums are shared by the frames.
  const std::vector<Far::LevelTable> levels{
      randomTable({.sourceCount = 300, .circulants = {{6, 60}}, .projected = {80}}, 1),
      randomTable({.sourceCount = 440, .circulants = {{5, 88}}}, 2),
      randomTable({.sourceCount = 440, .circulants = {{5, 108}}, .projected = {80}, .looseRows = 20}, 3)};

  Osd::VulkanTable table(Osd::VulkanEvaluator& evaluator) const {
    auto uploaded = evaluator.upload(pointersTo(levels), nullptr);
    if (!uploaded) throw std::runtime_error(uploaded.error().message);
    return std::move(*uploaded);
  }
  VulkanFrames frames(Osd::VulkanEvaluator& evaluator, const VulkanFramesOptions& options = {}) const {
    auto made = VulkanFrames::create(evaluator, table(evaluator), options);
    if (!made) throw std::runtime_error(made.error().message);
    return std::move(*made);
  }
  static VulkanTicket submit(VulkanFrames& frames, std::uint32_t seed, const Osd::VulkanFrameSync& sync = {}) {
    const auto ticket = frames.submit(randomNumbers(900, seed), sync);
    if (!ticket) throw std::runtime_error(ticket.error().message);
    return *ticket;
  }
  /// Waits for the frame and compares its results with the reference's.
  testing::AssertionResult right(const VulkanFrames& frames, const VulkanTicket& ticket, std::uint32_t seed) const {
    if (const auto done = frames.wait(ticket); !done) return testing::AssertionFailure() << done.error().message;
    const auto slot = frames.results(ticket);
    if (!slot) return testing::AssertionFailure() << slot.error().message;
    return sameBits(expectedPoints(levels, randomNumbers(900, seed), {}, {}), (*slot)->numbers(PointBuffer::refined))
           << ", frame " << ticket.value;
  }
  /// Twenty frames, each collected when the ring is full.
  testing::AssertionResult streams(const Osd::VulkanEvaluatorOptions& options, std::uint32_t inFlight) {
    auto evaluator = makeEvaluator(options);
    auto ring = frames(evaluator, {.framesInFlight = inFlight});
    std::deque<std::pair<VulkanTicket, std::uint32_t>> onTheWay;
    for (std::uint32_t frame = 0; frame < 20; ++frame) {
      if (onTheWay.size() == inFlight) {
        if (auto same = right(ring, onTheWay.front().first, onTheWay.front().second); !same) return same;
        onTheWay.pop_front();
      }
      onTheWay.emplace_back(submit(ring, frame), frame);
    }
    for (const auto& [ticket, frame] : onTheWay)
      if (auto same = right(ring, ticket, frame); !same) return same;
    return testing::AssertionSuccess();
  }
};

TEST_F(FramesTest, GiveTheBitsOfOneFrameAfterAnother) {
  for (const std::uint32_t inFlight : {1U, 2U, 3U, 7U}) EXPECT_TRUE(streams({}, inFlight)) << inFlight << " in flight";
}

TEST_F(FramesTest, GiveTheSameBitsWhereNoMemoryIsShared) {
  for (const std::uint32_t inFlight : {1U, 3U}) {
    EXPECT_TRUE(streams({.stageEverything = true}, inFlight)) << inFlight << " in flight";
  }
}

TEST_F(FramesTest, ResultsAreKeptUntilTheirBuffersAreUsedAgain) {
  auto evaluator = makeEvaluator();
  auto ring = frames(evaluator, {.framesInFlight = 2});
  const VulkanTicket first = submit(ring, 1), second = submit(ring, 2);
  EXPECT_TRUE(right(ring, second, 2));
  EXPECT_TRUE(right(ring, first, 1));
  const VulkanTicket third = submit(ring, 3);
  EXPECT_TRUE(ring.wait(first));
  const auto gone = ring.results(first);
  ASSERT_FALSE(gone);
  EXPECT_EQ(gone.error().code, ErrorCode::invalidOption);
  EXPECT_THAT(gone.error().message, HasSubstr("the results of frame 1 are overwritten"));
  EXPECT_TRUE(right(ring, second, 2));
  EXPECT_TRUE(right(ring, third, 3));
}

TEST_F(FramesTest, KnowTheirOwnTicketsOnly) {
  auto evaluator = makeEvaluator();
  auto ring = frames(evaluator), other = frames(evaluator);
  const VulkanTicket foreign = submit(other, 1), own = submit(ring, 1);
  for (const VulkanTicket& wrong : {foreign, VulkanTicket{}, VulkanTicket{own.semaphore, own.value + 1}}) {
    EXPECT_FALSE(ring.results(wrong));
    EXPECT_FALSE(ring.wait(wrong));
    EXPECT_FALSE(ring.finished(wrong));
  }
  EXPECT_TRUE(ring.results(own));
}

TEST_F(FramesTest, FramesInFlightShareTheirScratch) {
  auto evaluator = makeEvaluator();
  auto ring = frames(evaluator, {.framesInFlight = 2});
  const VulkanTicket first = submit(ring, 1), second = submit(ring, 2);
  const Osd::VulkanBinding& one = (*ring.results(first))->binding();
  const Osd::VulkanBinding& two = (*ring.results(second))->binding();
  EXPECT_GT(one.scratchBytes(), 0U);
  EXPECT_TRUE(two.sharesScratch(one));
  const auto otherTable = table(evaluator);
  const auto refused = Osd::FrameSlot::create(evaluator, otherTable, {}, *ring.results(first));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
}

TEST_F(FramesTest, NeedTheFeatureAndSayItsName) {
  Osd::VulkanDevice device = context->device();
  ASSERT_TRUE(device.timelineSemaphore);
  device.timelineSemaphore = false;
  auto evaluator = Osd::VulkanEvaluator::create(device);
  ASSERT_TRUE(evaluator) << evaluator.error().message;
  const auto refused = VulkanFrames::create(*evaluator, table(*evaluator));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_THAT(refused.error().message, HasSubstr("timelineSemaphore"));
}

TEST_F(FramesTest, RefuseNumbersOfFramesTheyCannotHave) {
  auto evaluator = makeEvaluator();
  for (const std::uint32_t inFlight : {0U, Osd::kMostFramesInFlight + 1}) {
    const auto refused = VulkanFrames::create(evaluator, table(evaluator), {.framesInFlight = inFlight});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
    EXPECT_THAT(refused.error().message, HasSubstr("give 1 to 16"));
  }
}

TEST_F(FramesTest, RefuseFramesThatWereNotBegunOrHaveAnotherSize) {
  auto evaluator = makeEvaluator();
  auto ring = frames(evaluator);
  EXPECT_FALSE(ring.submit());
  EXPECT_FALSE(ring.submit(randomNumbers(897)));
  EXPECT_TRUE(ring.submit(randomNumbers(900)));
  EXPECT_FALSE(ring.submit());
}

TEST_F(FramesTest, WaitForTheirFramesWhenTheyEndOrAreReplaced) {
  auto evaluator = makeEvaluator();
  auto ring = frames(evaluator);
  submit(ring, 1);
  VulkanFrames moved = std::move(ring);
  submit(moved, 2);
  moved = frames(evaluator, {.framesInFlight = 1});
  EXPECT_TRUE(right(moved, submit(moved, 3), 3));
}

/// A function of the device that evaluators have no use for.
template <class Function>
Function deviceFunction(const Osd::VulkanCore& core, const char* name) {
  Function function = nullptr;
  Osd::FunctionLoader::create(core.device)->ofDevice(name, function);
  return function;
}

/// A timeline semaphore of the caller's.
class OwnSemaphore {
 public:
  explicit OwnSemaphore(const Osd::VulkanEvaluator& evaluator)
      : core_(evaluator.core()), timeline_(*Osd::Timeline::create(core_)) {}

  VkSemaphore get() const { return timeline_.semaphore(); }
  bool reached(std::uint64_t value) const { return *timeline_.reached(value); }
  void wait(std::uint64_t value) const { EXPECT_TRUE(timeline_.wait(value)); }
  void signal(std::uint64_t value) const {
    VkSemaphoreSignalInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SIGNAL_INFO;
    info.semaphore = get();
    info.value = value;
    const auto signalSemaphore = deviceFunction<PFN_vkSignalSemaphore>(*core_, "vkSignalSemaphore");
    EXPECT_EQ(signalSemaphore(core_->device.device, &info), VK_SUCCESS);
  }

 private:
  std::shared_ptr<const Osd::VulkanCore> core_;
  Osd::Timeline timeline_;
};

TEST_F(FramesTest, WaitForTheCallersSemaphoresAndSignalThem) {
  auto evaluator = makeEvaluator();
  const OwnSemaphore before(evaluator), after(evaluator);
  auto ring = frames(evaluator);
  const std::array waits{Osd::VulkanSemaphoreValue{before.get(), 5}};
  const std::array signals{Osd::VulkanSemaphoreValue{after.get(), 9}};
  const VulkanTicket ticket = submit(ring, 1, {.waits = waits, .signals = signals});
  EXPECT_FALSE(*ring.finished(ticket));
  EXPECT_FALSE(after.reached(9));
  before.signal(5);
  after.wait(9);
  EXPECT_TRUE(right(ring, ticket, 1));
  EXPECT_TRUE(*ring.finished(ticket));
}

TEST_F(FramesTest, BeginWaitsForTheFrameThatUsesTheSameBuffers) {
  auto evaluator = makeEvaluator();
  const OwnSemaphore gate(evaluator);
  auto ring = frames(evaluator, {.framesInFlight = 1});
  const std::array waits{Osd::VulkanSemaphoreValue{gate.get(), 1}};
  const VulkanTicket held = submit(ring, 1, {.waits = waits});
  std::thread opener([&gate] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    gate.signal(1);
  });
  EXPECT_TRUE(ring.begin());
  EXPECT_TRUE(*ring.finished(held));
  opener.join();
}

TEST_F(FramesTest, RefuseMoreSemaphoresThanTheyTake) {
  auto evaluator = makeEvaluator();
  const OwnSemaphore one(evaluator);
  auto ring = frames(evaluator);
  const std::vector<Osd::VulkanSemaphoreValue> many(Osd::kMostSemaphores + 1, {one.get(), 0});
  const auto refused = ring.submit(randomNumbers(900), {.waits = many});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
}

/// Copies a buffer to the host behind a frame, as an engine's drawing would read it.
std::vector<float> copyBehind(const Osd::VulkanEvaluator& evaluator, const VulkanTicket& ticket,
                              const Osd::VulkanRange& from, std::size_t count) {
  const auto& core = evaluator.core();
  auto to = *Osd::VulkanBuffer::create(core, from.size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, Osd::MemoryUse::readback);
  auto commands = *Osd::CommandRunner::create(core);
  EXPECT_TRUE(commands.begin(VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT));
  const VkBufferCopy region{from.offset, 0, from.size};
  core->vk().vkCmdCopyBuffer(commands.commandBuffer(), from.buffer, to.handle(), 1, &region);
  EXPECT_TRUE(commands.end());
  const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_TRANSFER_BIT;
  const VkCommandBuffer one = commands.commandBuffer();
  VkTimelineSemaphoreSubmitInfo values{};
  values.sType = VK_STRUCTURE_TYPE_TIMELINE_SEMAPHORE_SUBMIT_INFO;
  values.waitSemaphoreValueCount = 1;
  values.pWaitSemaphoreValues = &ticket.value;
  VkSubmitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  info.pNext = &values;
  info.waitSemaphoreCount = 1;
  info.pWaitSemaphores = &ticket.semaphore;
  info.pWaitDstStageMask = &stage;
  info.commandBufferCount = 1;
  info.pCommandBuffers = &one;
  EXPECT_EQ(core->vk().vkQueueSubmit(core->device.queue, 1, &info, VK_NULL_HANDLE), VK_SUCCESS);
  EXPECT_EQ(deviceFunction<PFN_vkDeviceWaitIdle>(*core, "vkDeviceWaitIdle")(core->device.device), VK_SUCCESS);
  return {to.numbers().begin(), to.numbers().begin() + static_cast<std::ptrdiff_t>(count)};
}

TEST_F(FramesTest, ResultsThatStayOnTheDeviceAreReadBehindTheTicketWithoutTheHost) {
  for (const bool staged : {false, true}) {
    auto evaluator = makeEvaluator({.stageEverything = staged});
    const OwnSemaphore gate(evaluator);
    auto ring = frames(evaluator, {.framesInFlight = 2, .frame = {.readback = false}});
    const std::array waits{Osd::VulkanSemaphoreValue{gate.get(), 1}};
    const VulkanTicket ticket = submit(ring, 4, {.waits = waits});
    const Osd::FrameSlot& slot = **ring.results(ticket);
    EXPECT_EQ(slot.numbers(PointBuffer::refined).empty(), staged);
    gate.signal(1);
    const auto expected = expectedPoints(levels, randomNumbers(900, 4), {}, {});
    EXPECT_TRUE(sameBits(expected, copyBehind(evaluator, ticket, slot.range(PointBuffer::refined), expected.size())));
  }
}

}  // namespace
}  // namespace honeycomb::VulkanTests
