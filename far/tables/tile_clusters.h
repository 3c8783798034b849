#pragma once

#include <cstdint>
#include <vector>

#include "far/tables/tile_sharing.h"
#include "far/tables/tile_units.h"

namespace honeycomb::Far {

/// Which tile each chain belongs to.
struct TileOwners {
  std::int32_t tileCount = 0;
  std::vector<std::int32_t> of;  ///< per chain; -1: too large for a tile, or born behind the wanted level
};

/// Groups the units behind the root level into compact tiles of about `pointsPerTile` of that level's points, by what
/// they read in common; a chain that is born later belongs to the tile of the first point it reads. Linear.
TileOwners growTiles(const TileUnits& units, const TileSharing& sharing, std::int32_t pointsPerTile);

}  // namespace honeycomb::Far
