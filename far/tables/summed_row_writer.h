#pragma once

#include <cstdint>
#include <vector>

#include "far/tables/level_table.h"
#include "far/tables/replaced_rows.h"
#include "far/tables/row_writer.h"

namespace honeycomb::Far {

/// Puts rows that read the sums of large faces into a level table. Entries of a row with points from the table's
/// sourceCount on are shares: point - sourceCount is a number in LevelTable::projected.
class SummedRowWriter {
 public:
  explicit SummedRowWriter(LevelTable& table) : table_(table) {}

  /// The rows of the outputs firstOutput .. firstOutput + count - 1; made once each, in parallel.
  void add(std::int32_t firstOutput, std::int64_t count, const RowWriter::MakeRow& makeRow);
  /// One more row.
  void add(const ReplacedRow& row) { append(row.output, row.row); }
  /// Appends the rows to the table. Call once, before the loose rows are appended.
  void finish();

 private:
  void append(std::int32_t output, const Row& row);

  LevelTable& table_;
  std::vector<std::int32_t> indices_;
  std::vector<double> weights_;
  std::vector<double> shares_;
};

}  // namespace honeycomb::Far
