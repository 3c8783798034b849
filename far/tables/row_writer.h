#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "far/schemes/source_level.h"
#include "far/tables/level_table.h"

namespace honeycomb::Far {

/// Runs of this many rows with equal weights become dense rows, shorter ones are loose: a batch costs a dispatch.
constexpr std::int32_t kShortestDense = 256;

/// Puts rows into a level table, block by block of contiguous outputs: long runs of rows with equal weights as
/// DenseRows, at most 16 batches a block, all others as LooseRows.
class RowWriter {
 public:
  explicit RowWriter(LevelTable& table) : table_(table) {}

  /// Appends row i to an empty Row; called concurrently, in any order.
  using MakeRow = std::function<void(std::int64_t i, Row& row)>;
  /// The rows of the outputs firstOutput .. firstOutput + count - 1.
  void add(std::int32_t firstOutput, std::int64_t count, const MakeRow& makeRow);
  /// Appends the loose rows to the table. Call once, last.
  void finish();

 private:
  /// Rows in compressed form.
  struct Block {
    std::vector<std::int64_t> offsets{0};
    std::vector<std::int32_t> indices;
    std::vector<double> weights;
    std::int64_t width(std::int64_t row) const;
    bool sameWeights(std::int64_t a, std::int64_t b) const;
  };
  static Block compute(std::int64_t count, const MakeRow& makeRow);
  void addDense(const Block& block, std::int64_t begin, std::int64_t end, std::int32_t firstOutput);
  void addLoose(const Block& block, std::int64_t begin, std::int64_t end, std::int32_t firstOutput);

  LevelTable& table_;
  std::vector<std::int32_t> looseIndices_;
  std::vector<double> looseWeights_;
};

}  // namespace honeycomb::Far
