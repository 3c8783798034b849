#pragma once

#include <cstdint>
#include <vector>

#include "far/schemes/source_level.h"
#include "far/tables/level_table.h"

namespace honeycomb::Far {

/// Another row for an output of a table.
struct ReplacedRow {
  std::int32_t output = 0;
  Row row;
};

/// Puts rows in the place of those that a finished table has for the same outputs, each at most once; the outputs of a
/// whole face are replaced together or not at all. Batches are cut where rows leave them; the new rows are loose.
/// Linear in the batches' faces and rows.
void replaceRows(LevelTable& table, const std::vector<ReplacedRow>& rows);

}  // namespace honeycomb::Far
