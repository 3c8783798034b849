// Tables of plain rows: dense, loose and flattened rows give the same bits, on one thread and on all.
#include <gtest/gtest.h>

#include <bit>

#include "osd/cpu_evaluator.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

template <class Real>
std::vector<Real> randomReals(std::int64_t count) {
  const std::vector<float> numbers = randomNumbers(count);
  return {numbers.begin(), numbers.end()};
}

/// What an evaluator makes of a table from random points of some length, in a buffer of exact size.
template <class Real, class Table>
std::vector<std::uint64_t> bitsOf(Osd::CpuEvaluator& evaluator, const Table& table, std::int64_t targets,
                                  std::int32_t length) {
  const Osd::BufferDescriptor in{1, length, length + 2}, out{2, length, length + 1};
  const auto source = randomReals<Real>(in.extent(table.sourceCount));
  std::vector<Real> target(static_cast<std::size_t>(out.extent(targets)));
  const auto done = evaluator.evaluate(table, Osd::Points<Real>{source, in}, Osd::PointsOut<Real>{target, out});
  if (!done) throw std::runtime_error(done.error().message);
  std::vector<std::uint64_t> bits;
  for (const Real x : target) bits.push_back(std::bit_cast<std::uint64_t>(static_cast<double>(x)));
  return bits;
}

/// A table of dense rows as one of loose rows.
Far::LevelTable loosened(const Far::LevelTable& table) {
  Far::LevelTable loose;
  loose.sourceCount = table.sourceCount;
  loose.targetCount = table.targetCount;
  for (const Far::DenseRows& batch : table.dense) {
    for (std::int32_t g = 0; g < batch.rowCount; ++g) {
      loose.loose.outputs.push_back(batch.firstOutput + g);
      for (std::int32_t j = 0; j < batch.width; ++j) {
        loose.indices.edit().push_back(at(table.indices, batch.firstIndex + g * batch.width + j));
        loose.weights.push_back(at(table.weights, batch.firstWeight + j));
        loose.weightsSingle.push_back(at(table.weightsSingle, batch.firstWeight + j));
      }
      loose.loose.offsets.push_back(static_cast<std::int32_t>(loose.indices.size()));
    }
  }
  return loose;
}

template <class Real>
class RowTables : public testing::Test {
 protected:
  Osd::SerialEvaluator serial_;
  Osd::TbbEvaluator threaded_;
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(RowTables, Reals);

TYPED_TEST(RowTables, DenseRowsOfEveryWidthGiveTheBitsOfLooseRows) {
  for (const std::int32_t width : {1, 2, 3, 4, 7, 16}) {
    const Far::LevelTable dense = randomTable({.sourceCount = 500, .dense = {{width, 5000}, {width, 1}}});
    const Far::LevelTable loose = loosened(dense);
    for (const std::int32_t length : {1, 2, 3, 4, 7}) {
      SCOPED_TRACE(testing::Message() << "width " << width << ", length " << length);
      const auto expected = bitsOf<TypeParam>(this->serial_, loose, loose.targetCount, length);
      EXPECT_EQ(bitsOf<TypeParam>(this->serial_, dense, dense.targetCount, length), expected);
      EXPECT_EQ(bitsOf<TypeParam>(this->threaded_, dense, dense.targetCount, length), expected);
      EXPECT_EQ(bitsOf<TypeParam>(this->threaded_, loose, loose.targetCount, length), expected);
    }
  }
}

TYPED_TEST(RowTables, EveryBatchKindGivesTheSameBitsOnThreads) {
  const Far::LevelTable table = randomTable({.sourceCount = 500,
                                             .circulants = {{4, 2000}, {5, 1500}},
                                             .projected = {300},
                                             .halfProjected = {80, 1000},
                                             .dense = {{3, 5000}},
                                             .looseRows = 5000});
  EXPECT_EQ(bitsOf<TypeParam>(this->serial_, table, table.targetCount, 3),
            bitsOf<TypeParam>(this->threaded_, table, table.targetCount, 3));
}

TYPED_TEST(RowTables, StencilTablesGiveTheBitsOfTheirLooseRows) {
  const Far::Refinement refinement = refined(grid(20, 15), schemeCase(NamedTension::paper).scheme, 2);
  const auto table = Far::StencilTable::build(refinement);
  ASSERT_TRUE(table) << table.error().message;
  const Far::LevelTable loose = table->asLevelTable();
  for (const std::int32_t length : {1, 2, 3, 4, 7}) {
    SCOPED_TRACE(testing::Message() << "length " << length);
    const auto expected = bitsOf<TypeParam>(this->serial_, loose, loose.targetCount, length);
    EXPECT_EQ(bitsOf<TypeParam>(this->serial_, *table, table->rowCount(), length), expected);
    EXPECT_EQ(bitsOf<TypeParam>(this->threaded_, *table, table->rowCount(), length), expected);
  }
}

TYPED_TEST(RowTables, StencilTablesRefuseWhatDoesNotFit) {
  const Far::Refinement refinement = refined(cube(), schemeCase(NamedTension::paper).scheme, 1);
  const auto table = Far::StencilTable::build(refinement);
  ASSERT_TRUE(table) << table.error().message;
  const std::vector<TypeParam> source(24);
  std::vector<TypeParam> target(72);
  const Osd::Points<TypeParam> in{source, {}};
  const Osd::PointsOut<TypeParam> out{target, {}};
  EXPECT_TRUE(this->serial_.evaluate(*table, in, out));
  EXPECT_FALSE(this->serial_.evaluate(*table, Osd::Points<TypeParam>{std::span(source).first(23), {}}, out));
  EXPECT_FALSE(this->serial_.evaluate(*table, in, Osd::PointsOut<TypeParam>{std::span(target).first(71), {}}));
  EXPECT_FALSE(this->serial_.evaluate(*table, in, Osd::PointsOut<TypeParam>{target, {0, 2, 3}}));
  const auto refused = this->serial_.evaluate(*table, in, out, Far::StencilWeights::tangent1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "the stencil table has no tangents; build one of limits");
}

}  // namespace
}  // namespace honeycomb::Test
