#pragma once

#include "far/base/result.h"
#include "far/tables/level_tables.h"
#include "far/tables/tile_table.h"

namespace honeycomb::Far {

/// Proves that no evaluator of these tiles leaves their arrays, the points of these levels or a tile's own memory,
/// whatever stands in them: see table_proof.h, of which `levels` are proven. Linear in the table, parallel.
/// Errors: invalidFile, naming what is wrong and the tile, counted from 0.
Result<void> proveTiles(const TileTable& tiles, LevelTables levels);

}  // namespace honeycomb::Far
