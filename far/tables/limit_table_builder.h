#pragma once

#include "far/tables/limit_table.h"
#include "far/topology/split.h"

namespace honeycomb::Far {

/// Limits of a level: `child` is the level after it and `childTable` how to get there, by the scheme of the last step.
LimitTable buildLimitTable(const Topology& level, const SplitResult& child, LevelTable childTable);

}  // namespace honeycomb::Far
