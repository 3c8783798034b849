#pragma once

#include "far/schemes/scheme.h"
#include "far/tables/level_table.h"
#include "far/topology/split.h"

namespace honeycomb::Far {

/// The table that takes the points of `parent` to those of `split.topology`, with the weights of `scheme`.
LevelTable buildLevelTable(const Topology& parent, const SplitResult& split, const Scheme& scheme);

}  // namespace honeycomb::Far
