#pragma once

#include <cstdint>
#include <vector>

#include "far/tables/level_table.h"
#include "far/tables/limit_table.h"

namespace honeycomb::Test {

/// Which batches a random table has.
struct TableShape {
  std::int32_t sourceCount = 1000;
  struct Faces {
    std::int32_t sides, count;
    bool mirrored = false;  ///< the row is its own mirror image about an edge: the form of quads and hexagons
  };
  std::vector<Faces> circulants{};
  std::vector<std::int32_t> projected{};      ///< corners of each large face
  std::vector<std::int32_t> halfProjected{};  ///< the same, with outputs for half of the corners from some corner on
  struct Rows {
    std::int32_t width, count;
  };
  std::vector<Rows> dense{};
  std::int32_t looseRows = 0;
  std::int32_t summedRows = 0;  ///< and a large face that is there for its sum alone
};

/// A level table with random indices and weights, the same on every machine: nothing is assumed of how far/ orders what
/// a level table promises. Loose rows have 1 to 9 entries and are written to places in random order, behind all other
/// outputs. Summed rows have 0 to 8 entries and 0 to 2 shares of large faces, one of either at least.
Far::LevelTable randomTable(const TableShape& shape, std::uint32_t seed = 1);

/// Limit rows of elements in random order; batches as {sides, count}.
Far::LimitRows randomLimits(std::int32_t sourceCount, const std::vector<TableShape::Faces>& batches,
                            std::uint32_t seed = 1);

/// Numbers between -1 and 1.
std::vector<float> randomNumbers(std::int64_t count, std::uint32_t seed = 7);

}  // namespace honeycomb::Test
