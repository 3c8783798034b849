// Memory of the host runs out at each allocation in turn: an error, nothing left behind, no exception.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "fixture.h"
#include "osd/vulkan/session.h"
#include "runs.h"
#include "spy.h"
#include "tests/support/random_tables.h"

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

}  // namespace
}  // namespace honeycomb::VulkanTests
