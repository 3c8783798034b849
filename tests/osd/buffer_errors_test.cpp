#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "osd/cpu_evaluator.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

constexpr std::int64_t kControl = 8;   // of the cube
constexpr std::int64_t kRefined = 72;  // two levels on

class BufferErrors : public testing::Test {
 protected:
  /// Evaluates with buffers of the given sizes and hands back the outcome.
  Result<void> evaluate(const Osd::BufferDescriptor& in, std::int64_t inSize, const Osd::BufferDescriptor& out,
                        std::int64_t outSize, std::int32_t level = 2) {
    const std::vector<float> source(static_cast<std::size_t>(inSize), 1.0F);
    target_.assign(static_cast<std::size_t>(outSize), -7.0F);
    Osd::SerialEvaluator evaluator;
    return evaluator.evaluate(refinement_, level, Osd::Points<float>{source, in}, Osd::PointsOut<float>{target_, out});
  }

  void expectRefused(const Result<void>& result) {
    ASSERT_FALSE(result.has_value());
    EXPECT_FALSE(result.error().message.empty());
    EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
    EXPECT_THAT(target_, testing::Each(-7.0F)) << "nothing is written when the buffers are wrong";
  }

  Far::Refinement refinement_ = refined(cube(), schemeCase(NamedTension::paper).scheme, 2, {}, true);
  std::vector<float> target_;
};

TEST_F(BufferErrors, ExactSizesAreEnough) {
  EXPECT_TRUE(evaluate({0, 3, 3}, 3 * kControl, {0, 3, 3}, 3 * kRefined).has_value());
  EXPECT_TRUE(evaluate({2, 3, 5}, 2 + 5 * (kControl - 1) + 3, {1, 3, 4}, 1 + 4 * (kRefined - 1) + 3).has_value());
}

TEST_F(BufferErrors, OneNumberTooFewIsRefused) {
  expectRefused(evaluate({0, 3, 3}, 3 * kControl - 1, {0, 3, 3}, 3 * kRefined));
  expectRefused(evaluate({0, 3, 3}, 3 * kControl, {0, 3, 3}, 3 * kRefined - 1));
  expectRefused(evaluate({1, 3, 3}, 3 * kControl, {0, 3, 3}, 3 * kRefined));
  expectRefused(evaluate({0, 3, 3}, 3 * kControl, {1, 3, 3}, 3 * kRefined));
  expectRefused(evaluate({0, 3, 3}, 0, {0, 3, 3}, 3 * kRefined));
  expectRefused(evaluate({0, 3, 3}, 3 * kControl, {0, 3, 3}, 0));
}

TEST_F(BufferErrors, UnsoundDescriptorsAreRefused) {
  expectRefused(evaluate({0, 0, 3}, 3 * kControl, {0, 0, 3}, 3 * kRefined));
  expectRefused(evaluate({0, -1, 3}, 3 * kControl, {0, -1, 3}, 3 * kRefined));
  expectRefused(evaluate({0, 3, 2}, 3 * kControl, {0, 3, 3}, 3 * kRefined));
  expectRefused(evaluate({0, 3, 3}, 3 * kControl, {0, 3, 2}, 3 * kRefined));
  expectRefused(evaluate({-1, 3, 3}, 3 * kControl, {0, 3, 3}, 3 * kRefined));
  expectRefused(evaluate({0, 3, 3}, 3 * kControl, {-1, 3, 3}, 3 * kRefined));
}

TEST_F(BufferErrors, DifferentLengthsAreRefused) {
  expectRefused(evaluate({0, 2, 3}, 3 * kControl, {0, 3, 3}, 3 * kRefined));
}

TEST_F(BufferErrors, LevelsThatAreNotThereAreRefused) {
  expectRefused(evaluate({0, 3, 3}, 3 * kControl, {0, 3, 3}, 3 * kRefined, 3));
  expectRefused(evaluate({0, 3, 3}, 3 * kControl, {0, 3, 3}, 3 * kRefined, -1));
}

TEST_F(BufferErrors, LimitsNeedPointsOfLengthThree) {
  const std::vector<float> points(static_cast<std::size_t>(3 * kRefined));
  target_.assign(static_cast<std::size_t>(3 * kRefined), -7.0F);
  Osd::SerialEvaluator evaluator;
  const auto limits = [&](const Osd::BufferDescriptor& in, const Osd::BufferDescriptor& out, std::size_t outSize) {
    return evaluator.vertexLimits(refinement_.limits(), Osd::Points<float>{points, in},
                                  Osd::PointsOut<float>{std::span(target_).first(outSize), out},
                                  Osd::PointsOut<float>{});
  };
  expectRefused(limits({0, 2, 3}, {0, 3, 3}, target_.size()));
  expectRefused(limits({0, 3, 3}, {0, 2, 3}, target_.size()));
  expectRefused(limits({0, 3, 3}, {0, 3, 3}, target_.size() - 1));
  EXPECT_TRUE(limits({0, 3, 3}, {0, 3, 3}, target_.size()).has_value());
}

TEST_F(BufferErrors, LimitOutputsMayBeLeftOut) {
  const std::vector<float> points = pack<float>(levelPoints<float>(refinement_, 2, cube().points));
  std::vector<float> normals(points.size());
  std::vector<float> alone(points.size());
  std::vector<float> positions(points.size());
  Osd::SerialEvaluator evaluator;
  const Osd::Points<float> in{points, {0, 3, 3}};
  const auto to = [](std::vector<float>& v) { return Osd::PointsOut<float>{v, {0, 3, 3}}; };
  ASSERT_TRUE(evaluator.vertexLimits(refinement_.limits(), in, to(positions), to(normals)).has_value());
  ASSERT_TRUE(evaluator.vertexLimits(refinement_.limits(), in, Osd::PointsOut<float>{}, to(alone)).has_value());
  EXPECT_EQ(alone, normals);
  ASSERT_TRUE(evaluator.vertexLimits(refinement_.limits(), in, to(alone), Osd::PointsOut<float>{}).has_value());
  EXPECT_EQ(alone, positions);
}

TEST(BufferDescriptor, ExtentCountsToTheLastValue) {
  EXPECT_EQ((Osd::BufferDescriptor{0, 3, 3}).extent(10), 30);
  EXPECT_EQ((Osd::BufferDescriptor{2, 3, 5}).extent(10), 2 + 45 + 3);
  EXPECT_EQ((Osd::BufferDescriptor{2, 3, 5}).extent(0), 2);
  EXPECT_TRUE(Osd::checkDescriptor({2, 3, 5}, 50, 10, "control").has_value());
  const auto refused = Osd::checkDescriptor({2, 3, 5}, 49, 10, "control");
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().message, testing::HasSubstr("control"));
}

}  // namespace
}  // namespace honeycomb::Test
