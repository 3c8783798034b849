#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "far/base/result.h"
#include "far/tables/tile_assembler.h"

namespace honeycomb::Far {

/// Moves the arrays of the parts behind one another into the table's, the places in them moved on; the parts are empty
/// afterwards. The table's order of outputs is set. Error: tooLarge, the table as it was, where an array would have
/// more than `most` entries.
Result<void> joinTiles(std::vector<TileParts>& parts, TileTable& table,
                       std::int64_t most = std::numeric_limits<std::int32_t>::max());

}  // namespace honeycomb::Far
