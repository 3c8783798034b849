// Frame after frame through buffers that stay mapped.
#include "osd/vulkan/session.h"

#include "fixture.h"
#include "runs.h"
#include "tests/support/random_tables.h"

namespace honeycomb::VulkanTests {
namespace {

using Test::randomNumbers;
using Test::randomTable;

class SessionTest : public VulkanTest {
 protected:
  const std::vector<Far::LevelTable> levels{
      randomTable({.sourceCount = 300, .circulants = {{6, 60}}, .projected = {80}}, 1),
      randomTable({.sourceCount = 440, .circulants = {{5, 108}}, .projected = {80}, .looseRows = 20}, 2)};

  Osd::VulkanSession session(Osd::VulkanEvaluator& evaluator) {
    auto made = Osd::VulkanSession::create(evaluator, *evaluator.upload(pointersTo(levels), nullptr));
    if (!made) throw std::runtime_error(made.error().message);
    return std::move(*made);
  }
};

TEST_F(SessionTest, EveryFrameStandsForItself) {
  auto evaluator = makeEvaluator();
  auto frames = session(evaluator);
  const float* const mapped = frames.refined().data();
  for (std::uint32_t frame = 0; frame < 20; ++frame) {
    const auto in = randomNumbers(900, frame);
    std::ranges::copy(in, frames.control().begin());
    ASSERT_TRUE(frames.run());
    ASSERT_TRUE(sameBits(expectedPoints(levels, in, {}, {}), frames.refined())) << "frame " << frame;
  }
  EXPECT_EQ(frames.refined().data(), mapped);
}

TEST_F(SessionTest, FromARefinement) {
  auto evaluator = makeEvaluator();
  const Far::Refinement refinement({{{}, {}}, {{}, levels[0]}, {{}, levels[1]}}, {});
  auto frames = Osd::VulkanSession::create(evaluator, refinement);
  ASSERT_TRUE(frames) << frames.error().message;
  const auto in = randomNumbers(900);
  std::vector<float> out(frames->refined().size());
  ASSERT_TRUE(frames->refine(in, out));
  EXPECT_TRUE(sameBits(expectedPoints(levels, in, {}, {}), out));
}

TEST_F(SessionTest, SeveralSessionsInTurn) {
  auto evaluator = makeEvaluator();
  auto first = session(evaluator), second = session(evaluator);
  const auto a = randomNumbers(900, 1), b = randomNumbers(900, 2);
  std::vector<float> outA(first.refined().size()), outB(outA.size());
  ASSERT_TRUE(first.refine(a, outA));
  ASSERT_TRUE(second.refine(b, outB));
  EXPECT_TRUE(sameBits(expectedPoints(levels, a, {}, {}), first.refined()));
  EXPECT_TRUE(sameBits(expectedPoints(levels, b, {}, {}), second.refined()));
}

TEST_F(SessionTest, WorksAfterBeingMovedAndWithoutItsEvaluator) {
  std::optional<Osd::VulkanEvaluator> evaluator = makeEvaluator();
  Osd::VulkanSession made = session(*evaluator);
  evaluator.reset();
  Osd::VulkanSession moved = std::move(made);
  const auto in = randomNumbers(900);
  std::vector<float> out(moved.refined().size());
  ASSERT_TRUE(moved.refine(in, out));
  EXPECT_TRUE(sameBits(expectedPoints(levels, in, {}, {}), out));
}

TEST_F(SessionTest, RefusesFramesOfAnotherSize) {
  auto evaluator = makeEvaluator();
  auto frames = session(evaluator);
  std::vector<float> out(frames.refined().size());
  const auto refused = frames.refine(randomNumbers(897), out);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalidOption);
  out.pop_back();
  EXPECT_FALSE(frames.refine(randomNumbers(900), out));
}

TEST_F(SessionTest, AnOutputPastTheHeapIsOutOfMemory) {
  auto evaluator = makeEvaluator();
  // 3,000 points, each 4 MiB from the next: past lavapipe's heap, and nothing is allocated to find out.
  Far::LevelTable table = randomTable({.sourceCount = 30, .circulants = {{3, 1000}}});
  auto uploaded = evaluator.upload(std::vector<const Far::LevelTable*>{&table}, nullptr, {.refined = {0, 3, 1 << 20}});
  ASSERT_TRUE(uploaded) << uploaded.error().message;
  const auto refused = Osd::VulkanSession::create(evaluator, std::move(*uploaded));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::outOfMemory);
}

}  // namespace
}  // namespace honeycomb::VulkanTests
