// Memory of the host runs out at each allocation in turn: an error, nothing left behind, no exception.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <new>
#include <utility>

#include "osd/vulkan/frames.h"
#include "spy.h"
#include "tile_fixture.h"

namespace {

// Allocations of this thread until one fails; 0: none does.
thread_local int allocationsLeft = 0;

void* allocateOrFail(std::size_t bytes) {
  if (allocationsLeft > 0 && !honeycomb::VulkanTests::InVulkan::here() && --allocationsLeft == 0)
    throw std::bad_alloc();
  void* const data = std::malloc(bytes == 0 ? 1 : bytes);
  if (data == nullptr) throw std::bad_alloc();
  return data;
}

}  // namespace

void* operator new(std::size_t bytes) {
  return allocateOrFail(bytes);
}
void* operator new[](std::size_t bytes) {
  return allocateOrFail(bytes);
}
// The forms that don't throw as well: what the driver's compiler allocates by one it frees by another.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return std::malloc(bytes == 0 ? 1 : bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return std::malloc(bytes == 0 ? 1 : bytes);
}
void operator delete(void* data, const std::nothrow_t&) noexcept {
  std::free(data);
}
void operator delete[](void* data, const std::nothrow_t&) noexcept {
  std::free(data);
}
void operator delete(void* data) noexcept {
  std::free(data);
}
void operator delete(void* data, std::size_t) noexcept {
  std::free(data);
}
void operator delete[](void* data) noexcept {
  std::free(data);
}
void operator delete[](void* data, std::size_t) noexcept {
  std::free(data);
}

namespace honeycomb::VulkanTests {
namespace {

using honeycomb::Test::randomTable;

class HostMemoryTest : public VulkanTest {
 protected:
  const std::vector<Far::LevelTable> levels{
      randomTable({.sourceCount = 30, .circulants = {{6, 6}}, .projected = {80}, .looseRows = 4}, 1)};
};

TEST_F(HostMemoryTest, EachAllocationThatFailsIsAnErrorAndLeavesNothingBehind) {
  const std::vector<const Far::LevelTable*> pointers = pointersTo(levels);
  int failures = 0;
  for (bool complete = false; !complete; ++failures) {
    Spy spy(context->device());
    {
      allocationsLeft = failures + 1;
      auto evaluator = Osd::VulkanEvaluator::create(spy.device(), {.stageEverything = true});
      auto table = evaluator ? evaluator->upload(pointers, nullptr) : tl::unexpected(evaluator.error());
      auto session = table ? Osd::VulkanSession::create(*evaluator, *table) : tl::unexpected(table.error());
      const auto binding = session ? evaluator->bind(*table, {.control = session->range(Osd::PointBuffer::control),
                                                              .refined = session->range(Osd::PointBuffer::refined)})
                                   : tl::unexpected(session.error());
      complete = allocationsLeft > 0;
      allocationsLeft = 0;
      EXPECT_EQ(binding.has_value(), complete) << "allocation " << failures + 1;
      EXPECT_EQ(binding ? ErrorCode::outOfMemory : binding.error().code, ErrorCode::outOfMemory);
    }
    EXPECT_EQ(spy.alive(), 0) << "allocation " << failures + 1;
  }
  EXPECT_GT(failures, 20);
  Spy spy(context->device());
  auto evaluator = Osd::VulkanEvaluator::create(spy.device());
  ASSERT_TRUE(evaluator);
  EXPECT_TRUE(agrees(*evaluator, levels, {}, {}));
}

// Uploads of refinements and frames in flight, on one evaluator: what it has compiled it keeps.
class HostMemoryOfFramesTest : public TilesTest {
 protected:
  using Upload = std::function<Result<Osd::VulkanTable>(Osd::VulkanEvaluator&)>;

  // Three frames, and whether the normals of the last are right.
  Result<bool> play(Osd::VulkanEvaluator& on, const Upload& upload) const {
    const auto table = upload(on);
    if (!table) return tl::unexpected(table.error());
    auto frames = Osd::VulkanFrames::create(on, *table, {.framesInFlight = 2, .frame = {.timing = true}});
    if (!frames) return tl::unexpected(frames.error());
    Osd::VulkanTicket ticket;
    for (int frame = 0; frame < 3; ++frame) {
      const auto sent = frames->submit(control);
      if (!sent) return tl::unexpected(sent.error());
      ticket = *sent;
    }
    if (const auto done = frames->wait(ticket); !done) return tl::unexpected(done.error());
    const auto slot = frames->results(ticket);
    if (!slot) return tl::unexpected(slot.error());
    const auto times = (*slot)->binding().levelTimes();
    if (!times) return tl::unexpected(times.error());
    const auto normals = (*slot)->numbers(Osd::PointBuffer::vertexNormals);
    return std::ranges::equal(expected, normals);
  }

  // Fails each allocation in turn; returns how many there are.
  int failEachAllocation(const Upload& upload) {
    Spy spy(context->device());
    int failures = 0;
    {
      auto on = must(Osd::VulkanEvaluator::create(spy.device(), {.stageEverything = true}));
      for (;; ++failures) {
        allocationsLeft = failures + 1;
        const auto right = play(on, upload);
        const bool complete = std::exchange(allocationsLeft, 0) > 0;
        EXPECT_EQ(right.has_value(), complete) << "allocation " << failures + 1;
        if (complete) {
          EXPECT_TRUE(right && *right);
          break;
        }
        EXPECT_EQ(right ? ErrorCode{} : right.error().code, ErrorCode::outOfMemory);
        EXPECT_EQ(on.core()->pool->usage().used, 0U) << "allocation " << failures + 1;
      }
    }
    EXPECT_EQ(spy.alive(), 0);
    return failures;
  }

  const Far::Refinement refinement = aklemanOf(Meshes::prism(70), 2);
  const TileRun run{.kind = Far::TileNormalKind::fast, .normals = kNormals[0]};
  const std::vector<float> control = controlOf(refinement, run.layouts, 1);
  const std::vector<float> expected =
      chainedNormals(refinement, run, control, chained(refinement, 2, run.layouts, control));
};

TEST_F(HostMemoryOfFramesTest, EachAllocationOfLevelsWithNormalsThatFailsIsAnError) {
  EXPECT_GT(failEachAllocation([&](Osd::VulkanEvaluator& on) {
              return on.upload(refinement,
                               {.vertexLimits = {.normals = run.normals}, .normalKind = Far::TileNormalKind::fast});
            }),
            50);
}

// What a call answers whose message there is no memory for.
template <class Call>
ErrorCode codeWithoutMemory(const Call& call) {
  allocationsLeft = 1;
  const auto refused = call();
  const bool needed = std::exchange(allocationsLeft, 0) == 0;
  EXPECT_TRUE(needed) << "there was memory for the message";
  return refused ? ErrorCode{} : refused.error().code;
}

TEST_F(HostMemoryOfFramesTest, AnErrorWithoutMemoryForItsMessageIsAnError) {
  Spy spy(context->device());
  auto on = must(Osd::VulkanEvaluator::create(spy.device()));
  const auto table = must(on.upload(refinement));
  auto frames = must(Osd::VulkanFrames::create(on, table));
  const auto ticket = must(frames.submit(control));
  spy.fail("vkQueueSubmit", 1, VK_ERROR_DEVICE_LOST);
  EXPECT_EQ(codeWithoutMemory([&] { return frames.submit(control); }), ErrorCode::deviceLost);
  spy.fail("vkWaitSemaphores", 1, VK_ERROR_DEVICE_LOST);
  EXPECT_EQ(codeWithoutMemory([&] { return frames.wait(ticket); }), ErrorCode::deviceLost);
  EXPECT_EQ(codeWithoutMemory([&] { return frames.wait({}); }), ErrorCode::outOfMemory);
  EXPECT_EQ(codeWithoutMemory([&] { return frames.finished({}); }), ErrorCode::outOfMemory);
  EXPECT_EQ(codeWithoutMemory([&] { return frames.results({}); }), ErrorCode::outOfMemory);
  EXPECT_EQ(codeWithoutMemory([&] { return frames.submit(std::span<const float>()); }), ErrorCode::outOfMemory);
  auto session = must(Osd::VulkanSession::create(std::as_const(on), table));
  EXPECT_EQ(codeWithoutMemory([&] { return session.refine({}, {}); }), ErrorCode::outOfMemory);
  spy.fail("vkQueueSubmit", 1, VK_ERROR_DEVICE_LOST);
  EXPECT_EQ(codeWithoutMemory([&] { return session.run(); }), ErrorCode::deviceLost);
}

TEST_F(HostMemoryOfFramesTest, EachAllocationOfTilesThatFailsIsAnError) {
  const Far::TileTable tiles =
      must(Far::buildTileTable(refinement, {.scratchPoints = 300, .normals = Far::TileNormalKind::fast}));
  ASSERT_FALSE(tiles.shared.empty());
  EXPECT_GT(
      failEachAllocation([&](Osd::VulkanEvaluator& on) { return on.uploadTiles(refinement, tiles, optionsOf(run)); }),
      100);
}

}  // namespace
}  // namespace honeycomb::VulkanTests
