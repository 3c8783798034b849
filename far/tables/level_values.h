#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/tables/level_table.h"

namespace honeycomb::Far {

/// The values of a level from those of the level before, `length` numbers a point, in double: for tables that depend on
/// the values they are for. Evaluators (honeycomb::Osd) are faster and fix the order of operations; this doesn't.
/// Linear in the table, parallel.
std::vector<double> applyTable(const LevelTable& table, std::span<const double> source, std::int32_t length);

}  // namespace honeycomb::Far
