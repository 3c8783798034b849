#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "far/base/array.h"
#include "far/schemes/source_level.h"
#include "far/tables/level_table.h"

namespace honeycomb::Far {

/// Runs of this many rows with equal weights become dense rows, shorter ones are loose: a batch costs a dispatch.
constexpr std::int32_t kShortestDense = 256;

/// Puts rows into a level table, block by block of contiguous outputs: long runs of rows with equal weights as
/// DenseRows, at most 16 batches a block, all others as LooseRows. Indices are written in place, in parallel: rows are
/// made twice, to find the runs and to write them, or once where a whole block turns out to share its weights.
class RowWriter {
 public:
  explicit RowWriter(LevelTable& table) : table_(table) {}

  /// Appends row i to an empty Row; called concurrently, in any order, once or twice a row.
  using MakeRow = std::function<void(std::int64_t i, Row& row)>;
  /// The rows of the outputs firstOutput .. firstOutput + count - 1.
  void add(std::int32_t firstOutput, std::int64_t count, const MakeRow& makeRow);
  /// Appends the loose rows to the table. Call once, last.
  void finish();

 private:
  /// Rows begin .. end-1 of a block with equal weights, and where the first of them goes.
  struct Run {
    std::int64_t begin = 0, end = 0;
    const double* weights = nullptr;
    std::int32_t width = 0;
    bool dense = false;
    std::size_t firstIndex = 0;  // in the table's indices, or among those of the loose rows
    std::size_t firstRow = 0;    // among the loose rows
  };

  bool addUniform(std::int32_t firstOutput, std::int64_t count, const MakeRow& makeRow);
  void addDense(const Run& run, std::int32_t firstOutput);
  void place(std::vector<Run>& runs, std::int64_t count, std::int32_t firstOutput);
  void write(const std::vector<Run>& runs, std::int64_t count, std::int32_t firstOutput, const MakeRow& makeRow);
  void writeLoose(const Run& run, std::int64_t row, const Row& entries, std::int32_t output);

  LevelTable& table_;
  Array<std::int32_t> looseIndices_;
  Array<double> looseWeights_;
};

}  // namespace honeycomb::Far
