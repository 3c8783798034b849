#include "osd/tile_checks.h"

#include <fmt/format.h>

namespace honeycomb::Osd {

Result<void> checkTileLevel(const Far::TileTable& tiles, std::int32_t level) {
  if (level < 1 || level > tiles.lastLevel) {
    return fail(ErrorCode::invalidOption, fmt::format("level {} is out of range; use 1 to {}", level, tiles.lastLevel));
  }
  if (tiles.order == Far::TileOrder::tiles && level != tiles.lastLevel) {
    return fail(
        ErrorCode::invalidOption,
        fmt::format("tiles in their own order are of level {} alone; level {} was asked for", tiles.lastLevel, level));
  }
  return {};
}

Result<void> checkTileChoice(const Far::TileTable& tiles, const std::optional<std::span<const std::int32_t>>& only) {
  if (!only) return {};
  std::int64_t before = -1;
  for (const std::int32_t tile : *only) {
    if (tile <= before || tile >= std::ssize(tiles.tiles)) {
      return fail(ErrorCode::invalidOption, fmt::format("tile {} is chosen behind {}; give ascending numbers below {}",
                                                        tile, before, tiles.tiles.size()));
    }
    before = tile;
  }
  return {};
}

}  // namespace honeycomb::Osd
