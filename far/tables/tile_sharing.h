#pragma once

#include <cstdint>
#include <vector>

#include "far/tables/tile_units.h"

namespace honeycomb::Far {

/// Per level root + 1 .. last, the units too large for a tile, ascending.
std::vector<std::vector<std::int32_t>> largeUnits(const TileUnits& units);

/// What is too large for any tile, with all it reads down to the root level, as small level tables of its own.
class TileSharing {
 public:
  /// `wanted`: points of levels root + 1 .. last that are to be among the shared ones too; may be empty.
  TileSharing(const TileUnits& units, const std::vector<std::vector<std::int32_t>>& large,
              const std::vector<std::vector<std::int32_t>>& wanted);

  /// The number of a point of level k among the shared points; -1 if a tile makes it.
  std::int32_t sharedPoint(std::int32_t k, std::int32_t point) const {
    if (numbers_.empty()) return -1;
    const std::vector<std::int32_t>& numbers = numbers_[static_cast<std::size_t>(k - units_.root() - 1)];
    return numbers.empty() ? -1 : numbers[static_cast<std::size_t>(point)];
  }
  /// The number of any point that is among the shared ones, be it made by a tile as well; -1 if it isn't.
  std::int32_t setPoint(std::int32_t k, std::int32_t point) const {
    return sets_.empty()
               ? -1
               : setNumbers_[static_cast<std::size_t>(k - units_.root() - 1)][static_cast<std::size_t>(point)];
  }
  std::int32_t pointCount() const { return pointCount_; }
  std::vector<SharedPoints> sets() && { return std::move(sets_); }

 private:
  using Units = std::vector<std::int32_t>;
  Units makers(std::int32_t k, const std::vector<std::int32_t>& points) const;
  std::vector<std::int32_t> sources(std::int32_t k, const Units& units) const;
  void addSet(std::int32_t k, const Units& units, const Units& large);

  const TileUnits& units_;
  std::int32_t pointCount_ = 0;
  std::vector<SharedPoints> sets_;
  std::vector<std::vector<std::int32_t>> numbers_;     // per level, per point: of points of what is too large
  std::vector<std::vector<std::int32_t>> setNumbers_;  // per level, per point: its number, -1
};

}  // namespace honeycomb::Far
