#pragma once

#include <cstdint>
#include <vector>

#include "far/schemes/source_level.h"
#include "far/tables/level_table.h"

namespace honeycomb::Far {

/// Another row for an output of a table. A point from the table's sourceCount on is a sum: first come the sums S of the
/// table's projected faces, by their numbers, then RowChanges::sums.
struct ReplacedRow {
  std::int32_t output = 0;
  Row row;
};

/// A sum that rows read as if it were a point, so that many rows round a large face cost no more than a few entries
/// each.
struct PointSum {
  std::vector<std::int32_t> points;
  std::vector<double> weights;  ///< one a point
  bool operator==(const PointSum&) const = default;
};

struct RowChanges {
  std::vector<ReplacedRow> rows;
  std::vector<PointSum> sums;
};

/// Puts rows in the place of those that a finished table has for the same outputs, each at most once; the outputs of a
/// whole face are replaced together or not at all. Batches are cut where rows leave them; the new rows are summed ones
/// where they read sums, else loose. In the table the summed and behind them the loose rows are the last of the indices
/// and weights, before and after. Linear in the batches' faces and rows.
void replaceRows(LevelTable& table, const RowChanges& changes);

}  // namespace honeycomb::Far
