#pragma once

#include <cstdint>

namespace honeycomb::Osd {

/// The points a tile may keep on this machine (TileOptions::scratchPoints): half of a second-level cache in single
/// precision, 4096 .. 32768; 8192 where the cache's size isn't known. Points come out the same whatever it is.
std::int32_t tilePoints();

}  // namespace honeycomb::Osd
