// Every batch kind in every layout by every set of instructions that this machine has: the bits of the plain loops, in
// buffers of exactly the numbers they need.
#include <gtest/gtest.h>

#include <bit>
#include <stdexcept>
#include <vector>

#include "osd/cpu_evaluator.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

struct Layout {
  Osd::BufferDescriptor in, out;
};

/// Every length there is a kernel for and one beyond; packed, padded to four and to more, with and without offsets.
const std::vector<Layout> kLayouts{{{0, 1, 1}, {0, 1, 1}}, {{1, 1, 3}, {2, 1, 2}}, {{0, 2, 2}, {0, 2, 2}},
                                   {{3, 2, 5}, {1, 2, 3}}, {{0, 3, 3}, {0, 3, 3}}, {{0, 3, 4}, {0, 3, 4}},
                                   {{2, 3, 3}, {1, 3, 8}}, {{1, 3, 7}, {5, 3, 3}}, {{0, 4, 4}, {0, 4, 4}},
                                   {{1, 4, 5}, {3, 4, 9}}, {{0, 7, 7}, {0, 7, 7}}, {{2, 7, 9}, {1, 7, 8}},
                                   {{0, 5, 5}, {0, 5, 5}}, {{0, 6, 6}, {0, 6, 6}}, {{0, 11, 11}, {0, 11, 11}}};

/// All numbers of a target buffer that an evaluator fills; numbers between the described ones must stay 0.
template <class Table>
std::vector<std::uint32_t> bitsOf(Osd::CpuEvaluator evaluator, const Table& table, std::int64_t rows,
                                  const Layout& layout) {
  const std::vector<float> source = randomNumbers(layout.in.extent(table.sourceCount));
  std::vector<float> target(static_cast<std::size_t>(layout.out.extent(rows)));
  const auto done =
      evaluator.evaluate(table, Osd::Points<float>{source, layout.in}, Osd::PointsOut<float>{target, layout.out});
  if (!done) throw std::runtime_error(done.error().message);
  std::vector<std::uint32_t> bits;
  for (const float x : target) bits.push_back(std::bit_cast<std::uint32_t>(x));
  return bits;
}

template <class Table>
void compareTargets(const Table& table, std::int64_t rows) {
  for (const Layout& layout : kLayouts) {
    const auto expected = bitsOf(Osd::SerialEvaluator(), table, rows, layout);
    for (const std::int64_t target : targets()) {
      const TargetInUse use(target);
      ASSERT_EQ(bitsOf(Osd::SimdEvaluator(), table, rows, layout), expected)
          << hwy::TargetName(target) << ", length " << layout.in.length << ", strides " << layout.in.stride << " and "
          << layout.out.stride;
    }
  }
}

void compareTargets(const TableShape& shape) {
  const Far::LevelTable table = randomTable(shape);
  compareTargets(table, table.targetCount);
}

TEST(Simd, CirculantsOfEverySideCount) {
  for (const std::int32_t sides : {3, 4, 5, 6, 7, 8, 9, 10, 13, 16, 31, 63, 64}) {
    SCOPED_TRACE(testing::Message() << sides << " sides");
    ASSERT_NO_FATAL_FAILURE(compareTargets({.sourceCount = 3000, .circulants = {{sides, 101}}}));
  }
}

TEST(Simd, CirculantsWithFormsOfTheirOwn) {
  ASSERT_NO_FATAL_FAILURE(compareTargets({.sourceCount = 3000, .circulants = {{4, 101, true}}}));
  ASSERT_NO_FATAL_FAILURE(compareTargets({.sourceCount = 3000, .circulants = {{6, 101, true}}}));
}

TEST(Simd, FewFacesAndRows) {
  // Fewer than a vector holds, as many, and one more; every one of them reads the last point some time.
  for (std::int32_t count = 1; count <= 10; ++count) {
    SCOPED_TRACE(testing::Message() << count << " each");
    ASSERT_NO_FATAL_FAILURE(compareTargets({.sourceCount = 20,
                                            .circulants = {{3, count}, {6, count, true}, {9, count}},
                                            .dense = {{2, count}, {5, count}}}));
    ASSERT_NO_FATAL_FAILURE(compareTargets({.sourceCount = 1000,
                                            .circulants = {{3, count}, {6, count, true}, {9, count}},
                                            .dense = {{2, count}, {5, count}},
                                            .looseRows = count}));
  }
}

TEST(Simd, FacesThatAllReadTheLastPoint) {
  ASSERT_NO_FATAL_FAILURE(compareTargets(
      {.sourceCount = 1, .circulants = {{5, 30}, {6, 30}}, .projected = {70}, .dense = {{4, 30}}, .looseRows = 30}));
}

TEST(Simd, DenseRowsOfEveryWidth) {
  for (std::int32_t width = 1; width <= Far::kWidestDense; ++width) {
    SCOPED_TRACE(testing::Message() << "width " << width);
    ASSERT_NO_FATAL_FAILURE(compareTargets({.sourceCount = 2000, .dense = {{width, 101}}}));
  }
}

TEST(Simd, LargeFacesByProjections) {
  ASSERT_NO_FATAL_FAILURE(
      compareTargets({.sourceCount = 20000, .projected = {65, 256, 257, 512, 1000}, .halfProjected = {66, 513, 100}}));
}

TEST(Simd, RowsThatReadTheSumsOfLargeFaces) {
  ASSERT_NO_FATAL_FAILURE(compareTargets({.sourceCount = 2000, .projected = {65, 1000, 300}, .summedRows = 500}));
}

TEST(Simd, LooseRows) {
  ASSERT_NO_FATAL_FAILURE(compareTargets({.sourceCount = 2000, .looseRows = 1001}));
}

TEST(Simd, AllKindsTogether) {
  ASSERT_NO_FATAL_FAILURE(compareTargets({.circulants = {{4, 50}, {5, 33}, {6, 100, true}, {20, 9}},
                                          .projected = {65, 700},
                                          .halfProjected = {80},
                                          .dense = {{2, 40}, {4, 70}},
                                          .looseRows = 77,
                                          .summedRows = 60}));
}

TEST(Simd, TargetsTooLargeForACache) {
  const Far::LevelTable table =
      randomTable({.sourceCount = 3000, .circulants = {{5, 20001}, {6, 180001, true}, {8, 10}}, .looseRows = 9});
  const std::vector<float> source = randomNumbers(4 * std::int64_t{table.sourceCount});
  for (const std::int32_t offset : {0, 1}) {  // 1: points are not where streaming stores can write
    const Osd::BufferDescriptor out{offset, 4, 4};
    const auto evaluate = [&](Osd::CpuEvaluator evaluator) {
      std::vector<float> target(static_cast<std::size_t>(out.extent(table.targetCount)));
      EXPECT_TRUE(evaluator.evaluate(table, Osd::Points<float>{source, {0, 4, 4}}, Osd::PointsOut<float>{target, out}));
      return target;
    };
    const std::vector<float> expected = evaluate(Osd::SerialEvaluator());
    ASSERT_GT(expected.size() * sizeof(float), std::size_t{16} << 20);
    for (const std::int64_t target : targets()) {
      const TargetInUse use(target);
      EXPECT_TRUE(evaluate(Osd::SimdEvaluator()) == expected) << hwy::TargetName(target) << ", offset " << offset;
      EXPECT_TRUE(evaluate(Osd::TbbEvaluator()) == expected) << hwy::TargetName(target) << ", offset " << offset;
    }
  }
}

TEST(Simd, StencilTables) {
  const Far::Refinement refinement = refined(grid(9, 8), schemeCase(NamedTension::paper).scheme, 2);
  const auto table = Far::StencilTable::build(refinement);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_NO_FATAL_FAILURE(compareTargets(*table, table->rowCount()));
}

TEST(Simd, LevelsOfARefinement) {
  // Between levels the points are padded, which nobody sees.
  const Far::Refinement refinement = refined(torus(7, 6), schemeCase(NamedTension::paper).scheme, 3);
  for (const Layout& layout : kLayouts) {
    const auto points = randomNumbers(layout.in.extent(refinement.level(0).pointCount()));
    const auto evaluate = [&](Osd::CpuEvaluator evaluator) {
      std::vector<float> out(static_cast<std::size_t>(layout.out.extent(refinement.last().pointCount())));
      EXPECT_TRUE(evaluator.evaluate(refinement, 3, Osd::Points<float>{points, layout.in},
                                     Osd::PointsOut<float>{out, layout.out}));
      return out;
    };
    const auto expected = evaluate(Osd::SerialEvaluator());
    for (const std::int64_t target : targets()) {
      const TargetInUse use(target);
      ASSERT_EQ(evaluate(Osd::SimdEvaluator()), expected) << hwy::TargetName(target) << ", length " << layout.in.length;
    }
  }
}

}  // namespace
}  // namespace honeycomb::Test
