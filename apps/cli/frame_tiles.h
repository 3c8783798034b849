#pragma once

#include <cstdint>

#include "far/tables/level_tables.h"

namespace honeycomb::Cli {

// Measured at 1.1 to 2.6 million points, in processor time of one thread, building first, then a frame level by level
// and by tiles:
//     akleman      33 ns a point    2.2   1.5    even after 46 frames
//     doo-sabin    44               2.9   2.4    95
//     trisect     152               3.2   2.4    180
//     half-box     67               3.5   3.6
//     zhang-wang  234               6.2   9.7
constexpr std::int32_t kTileFrames = 100;
/// Points in a hundred that the circulants of faces make, which is what tiles are fast at: all of akleman's,
/// doo-sabin's and centroid's, 75 of half-box's, 5 of zhang-wang's, none of trisect's and midpoint's.
constexpr std::int64_t kTileFacePoints = 90;
/// Levels that stay in the second-level cache are as fast as tiles: 1.0 and 1.1 ns a point at 58,000 points, 1.25 both
/// at 170,000; 1.5 and 1.2 at 360,000, 4.3 and 2.7 at 10 million.
constexpr std::int64_t kTilePoints = 250'000;
/// Bytes a point that building takes, about, the tiles included (3 remain).
constexpr std::int64_t kTileBuildBytes = 32;

// Measured on lavapipe, akleman, in processor time of all cores: kernels of tiles compile for 180 ms in every run,
// those of levels for 50; a frame takes 10 to 12.5 ns a point by tiles and 18 level after level.
constexpr std::int64_t kDeviceTileCompileNs = 130'000'000;
constexpr std::int64_t kDeviceTileBuildNs = 33;  ///< a point
constexpr std::int64_t kDeviceTileSavedNs = 6;   ///< a point and frame

/// Is a bake of `frames` frames, `atOnce` of them in memory, faster by tiles than level after level, their building
/// included, and is there memory to build them?
bool tilesPay(const Far::LevelTables& levels, std::int32_t frames, int atOnce);

/// The same on a Vulkan device. On a GPU never: there tiles save 0.03 ns a point and frame (docs/gpu.md), which pays
/// for building after a thousand frames, and a bake waits for its results to come back, 0.5 ns a point.
bool deviceTilesPay(bool deviceIsCpu, const Far::LevelTables& levels, std::int32_t frames, int atOnce);

}  // namespace honeycomb::Cli
