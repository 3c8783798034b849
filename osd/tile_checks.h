#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "far/base/result.h"
#include "far/tables/tile_table.h"

/// What every evaluator of tiles asks of a request.
namespace honeycomb::Osd {

/// Can these tiles evaluate level `level`? Errors: invalidOption.
Result<void> checkTileLevel(const Far::TileTable& tiles, std::int32_t level);

/// Are chosen tiles there, in ascending order? Errors: invalidOption.
Result<void> checkTileChoice(const Far::TileTable& tiles, const std::optional<std::span<const std::int32_t>>& only);

}  // namespace honeycomb::Osd
