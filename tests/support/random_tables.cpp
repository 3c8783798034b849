#include "tests/support/random_tables.h"

#include <algorithm>
#include <numeric>

#include "far/tables/circulant_form.h"
#include "tests/support/random.h"

namespace honeycomb::Test {

namespace {

std::int32_t sizeOf(const auto& values) {
  return static_cast<std::int32_t>(values.size());
}

/// 0 .. n-1.
std::int32_t below(Random& random, std::int32_t n) {
  return static_cast<std::int32_t>(random.below(static_cast<std::size_t>(n)));
}

class Builder {
 public:
  Builder(const TableShape& shape, std::uint32_t seed) : random_(seed) { table_.sourceCount = shape.sourceCount; }

  void addCirculant(TableShape::Faces faces) {
    Far::CirculantBatch batch{.sides = faces.sides,
                              .faceCount = faces.count,
                              .firstIndex = sizeOf(table_.indices),
                              .firstOutput = table_.targetCount,
                              .firstRow = sizeOf(table_.weights)};
    addIndices(faces.sides * faces.count);
    addWeights(faces.sides);
    const auto row = table_.weights.begin() + batch.firstRow;
    if (faces.mirrored) {
      for (std::int32_t k = 1; k <= faces.sides / 2; ++k) row[k] = row[(faces.sides + 1 - k) % faces.sides];
    }
    const std::vector<double> weights(row, table_.weights.end());
    batch.form = Far::circulantForm(weights);
    batch.firstForm = batch.form == Far::CirculantForm::direct ? batch.firstRow : sizeOf(table_.weights);
    if (batch.form != Far::CirculantForm::direct) {
      for (const double weight : Far::formWeights(batch.form, weights)) table_.weights.push_back(weight);
    }
    table_.circulants.push_back(batch);
    table_.targetCount += faces.sides * faces.count;
  }

  void addProjected(std::int32_t corners, std::int32_t outputs, std::int32_t firstCorner) {
    table_.projected.push_back({.corners = corners,
                                .outputs = outputs,
                                .firstCorner = firstCorner,
                                .firstIndex = sizeOf(table_.indices),
                                .firstOutput = table_.targetCount,
                                .firstWeight = sizeOf(table_.weights)});
    addIndices(corners);
    addWeights(outputs == 0 ? 2 + corners : 2 + 3 * corners + 3 * outputs);
    table_.targetCount += outputs;
  }

  void addDense(TableShape::Rows rows) {
    table_.dense.push_back({.width = rows.width,
                            .rowCount = rows.count,
                            .firstIndex = sizeOf(table_.indices),
                            .firstOutput = table_.targetCount,
                            .firstWeight = sizeOf(table_.weights)});
    addIndices(rows.width * rows.count);
    addWeights(rows.width);
    table_.targetCount += rows.count;
  }

  void addLoose(std::int32_t rows) {
    Far::LooseRows& loose = table_.loose;
    loose.firstIndex = sizeOf(table_.indices);
    loose.firstWeight = sizeOf(table_.weights);
    loose.outputs.resize(static_cast<std::size_t>(rows));
    std::iota(loose.outputs.begin(), loose.outputs.end(), table_.targetCount);
    random_.shuffle(loose.outputs);
    table_.targetCount += rows;
    for (std::int32_t r = 0; r < rows; ++r) loose.offsets.push_back(loose.offsets.back() + 1 + below(random_, 9));
    addIndices(loose.offsets.back());
    addWeights(loose.offsets.back());
  }

  void addSummed(std::int32_t rows) {
    addProjected(77, 0, 0);
    Far::SummedRows& summed = table_.summed;
    summed.rows.firstIndex = sizeOf(table_.indices);
    for (std::int32_t r = 0; r < rows; ++r) {
      const std::int32_t own = below(random_, 9);
      const std::int32_t read = own == 0 ? 1 : below(random_, 3);
      for (std::int32_t t = 0; t < read; ++t) summed.faces.push_back(below(random_, sizeOf(table_.projected)));
      summed.rows.outputs.push_back(table_.targetCount++);
      summed.rows.offsets.push_back(summed.rows.offsets.back() + own);
      summed.shareOffsets.push_back(sizeOf(summed.faces));
    }
    random_.shuffle(summed.rows.outputs);
    addIndices(summed.rows.offsets.back());
    summed.rows.firstWeight = sizeOf(table_.weights);
    addWeights(summed.rows.offsets.back());
    summed.firstShare = sizeOf(table_.weights);
    addWeights(sizeOf(summed.faces));
  }

  Far::LevelTable take() {
    for (const double weight : table_.weights) table_.weightsSingle.push_back(static_cast<float>(weight));
    return std::move(table_);
  }

 private:
  void addIndices(std::int32_t count) {
    for (std::int32_t i = 0; i < count; ++i) table_.indices.edit().push_back(below(random_, table_.sourceCount));
  }
  void addWeights(std::int32_t count) {
    for (std::int32_t i = 0; i < count; ++i) table_.weights.push_back(random_.symmetric());
  }

  Random random_;
  Far::LevelTable table_;
};

}  // namespace

Far::LevelTable randomTable(const TableShape& shape, std::uint32_t seed) {
  Builder builder(shape, seed);
  for (const auto& faces : shape.circulants) builder.addCirculant(faces);
  for (const std::int32_t corners : shape.projected) builder.addProjected(corners, corners, 0);
  for (const std::int32_t corners : shape.halfProjected) builder.addProjected(corners, corners / 2, corners - 3);
  for (const auto& rows : shape.dense) builder.addDense(rows);
  if (shape.summedRows > 0) builder.addSummed(shape.summedRows);
  if (shape.looseRows > 0) builder.addLoose(shape.looseRows);
  return builder.take();
}

Far::LimitRows randomLimits(std::int32_t sourceCount, const std::vector<TableShape::Faces>& batches,
                            std::uint32_t seed) {
  Random random(seed);
  Far::LimitRows rows;
  rows.sourceCount = sourceCount;
  for (const auto& [sides, count, mirrored] : batches) {
    rows.batches.push_back({.sides = sides,
                            .count = count,
                            .firstIndex = sizeOf(rows.indices),
                            .firstElement = rows.elementCount,
                            .firstWeight = sizeOf(rows.weights)});
    for (std::int32_t i = 0; i < sides * count; ++i) rows.indices.push_back(below(random, sourceCount));
    for (std::int32_t i = 0; i < 3 * sides; ++i) rows.weights.push_back(random.symmetric());
    rows.elementCount += count;
  }
  rows.elements.resize(static_cast<std::size_t>(rows.elementCount));
  std::iota(rows.elements.begin(), rows.elements.end(), 0);
  random.shuffle(rows.elements);
  for (const double value : rows.weights) rows.weightsSingle.push_back(static_cast<float>(value));
  return rows;
}

std::vector<float> randomNumbers(std::int64_t count, std::uint32_t seed) {
  Random random(seed);
  std::vector<float> numbers(static_cast<std::size_t>(count));
  for (float& number : numbers) number = static_cast<float>(random.symmetric());
  return numbers;
}

}  // namespace honeycomb::Test
