#pragma once

#include "far/schemes/scheme.h"
#include "far/tables/level_table.h"
#include "far/topology/split.h"

namespace honeycomb::Far {

/// The table that takes the points of `source` to those of `split.topology` (followed by central control vertices where
/// the scheme has them), with the weights of `scheme`.
LevelTable buildLevelTable(const SourceLevel& source, const SplitResult& split, const Scheme& scheme);

}  // namespace honeycomb::Far
