#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "far/tables/tile_table.h"

namespace honeycomb::Far {

/// Numbers in TileTable::indices a face or dense row of a step.
constexpr std::int64_t indicesEach(const TileStep& step) {
  return step.pairs ? step.width / 2 : step.width;
}

/// What is wrong with tile `number` of a table whose frame and totals are sound: null, or a few words. Places are
/// checked before anything is read there. `sharedPoints`: of all sets; `faceEnds`: where the normals of a step's points
/// end at the latest, one a step; of fast normals.
const char* wrongWithTile(const TileTable& table, std::int32_t sharedPoints, std::span<const std::int64_t> faceEnds,
                          std::size_t number);

}  // namespace honeycomb::Far
