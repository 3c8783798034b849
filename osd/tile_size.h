#pragma once

#include <cstdint>

#include "far/tables/tile_table.h"

namespace honeycomb::Osd {

/// The points a tile may keep on this machine (TileOptions::scratchPoints): half of a second-level cache in single
/// precision, 4096 .. 32768; 8192 where the cache's size isn't known. Points come out the same whatever it is.
std::int32_t tilePoints();

/// What points and normals of a level may take together to stay in this machine's caches: three quarters of the last
/// one in bytes; without end where its size isn't known.
std::int64_t cachedBytes();

/// What the points of a level may take to be written through this machine's caches: five eighths of the last one in
/// bytes, 16 to 20 MB; 16 MB where its size isn't known.
std::int64_t streamedBytes();

/// How tiles for TileEvaluator are cut on this machine: tilePoints(), eight a thread or more, points in the order that
/// vectors write fastest.
Far::TileOptions cpuTileOptions(Far::TileNormalKind normals = Far::TileNormalKind::none);

}  // namespace honeycomb::Osd
