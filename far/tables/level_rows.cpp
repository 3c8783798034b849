#include "far/tables/level_rows.h"

#include <limits>

#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// The place of a point that no row writes: a table that breaks its promise.
constexpr std::int32_t kNowhere = std::numeric_limits<std::int32_t>::min();

std::int32_t sizeOf(const auto& batches) {
  return static_cast<std::int32_t>(batches.size());
}

std::int32_t entriesOf(const LooseRows& rows, std::int32_t row) {
  return rows.offsets[at(row) + 1] - rows.offsets[at(row)];
}

}  // namespace

LevelRows::LevelRows(const LevelTable& table) : table_(&table), places_(at(table.targetCount), kNowhere) {
  for (std::int32_t b = 0; b < sizeOf(table.circulants); ++b) {
    const CirculantBatch& batch = table.circulants[at(b)];
    addRange({Kind::circulant, b, batch.firstOutput, batch.sides}, std::int64_t{batch.faceCount} * batch.sides);
  }
  for (std::int32_t b = 0; b < sizeOf(table.projected); ++b) {
    const ProjectedFace& face = table.projected[at(b)];
    addRange({Kind::projected, b, face.firstOutput, face.outputs}, face.outputs);
  }
  for (std::int32_t b = 0; b < sizeOf(table.dense); ++b) {
    const DenseRows& batch = table.dense[at(b)];
    addRange({Kind::dense, b, batch.firstOutput, 1}, batch.rowCount);
  }
  Parallel::forEach(0, table.loose.rowCount(), [&](std::int64_t r) {
    places_[at(table.loose.outputs[at(r)])] = static_cast<std::int32_t>(-1 - r);
  });
  const std::int32_t looseRows = table.loose.rowCount();
  Parallel::forEach(0, table.summed.rowCount(), [&](std::int64_t r) {
    places_[at(table.summed.rows.outputs[at(r)])] = static_cast<std::int32_t>(-1 - looseRows - r);
  });
}

void LevelRows::addRange(const Range& range, std::int64_t outputs) {
  const std::int32_t number = sizeOf(ranges_);
  ranges_.push_back(range);
  Parallel::forEach(range.firstOutput, range.firstOutput + outputs, [&](std::int64_t i) { places_[at(i)] = number; });
}

LevelRows::Place LevelRows::place(std::int32_t output) const {
  const std::int32_t number = places_[at(output)];
  assert(number != kNowhere);
  if (number < 0) {
    const std::int32_t row = -1 - number;
    const std::int32_t looseRows = table_->loose.rowCount();
    return row < looseRows ? Place{Kind::loose, 0, row, 0} : Place{Kind::summed, 0, row - looseRows, 0};
  }
  const Range& range = ranges_[at(number)];
  const std::int32_t i = output - range.firstOutput;
  return {range.kind, range.batch, i / range.itemOutputs, i % range.itemOutputs};
}

std::int32_t LevelRows::entryCount(std::int32_t output) const {
  const Place p = place(output);
  switch (p.kind) {
    case Kind::circulant:
      return table_->circulants[at(p.batch)].sides;
    case Kind::projected:
      return table_->projected[at(p.batch)].corners;
    case Kind::dense:
      return table_->dense[at(p.batch)].width;
    case Kind::summed: {
      std::int32_t count = entriesOf(table_->summed.rows, p.item);
      visitShares(p.item, [&](std::int32_t face, double) { count += table_->projected[at(face)].corners; });
      return count;
    }
    default:
      return entriesOf(table_->loose, p.item);
  }
}

}  // namespace honeycomb::Far
