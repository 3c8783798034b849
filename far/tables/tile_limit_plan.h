#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/tables/limit_table.h"
#include "far/tables/tile_sharing.h"
#include "far/tables/tile_table.h"
#include "far/tables/tile_units.h"

namespace honeycomb::Far {

/// The exact normals of the wanted level as tiles need them: what each is made from, and which are shared.
class TileLimitPlan {
 public:
  /// `limits`: of the wanted level; `large`: those of `units` that are too large for a tile, whose points' normals are
  /// found for all.
  TileLimitPlan(const LimitTable& limits, const TileUnits& units, const std::vector<std::vector<std::int32_t>>& large);

  /// What shared normals are found from, per level root + 1 .. last: it must be shared too.
  std::vector<std::vector<std::int32_t>> sharedPoints() const;
  /// Finds the points of shared normals; once, before the table is finished.
  void share(const TileSharing& sharing);

  /// Is the normal of a point of the wanted level found for all tiles?
  bool shared(std::int32_t point) const { return shared_[static_cast<std::size_t>(point)] != 0; }
  /// How a point's normal is found.
  struct Place {
    std::int32_t shape = kNoVertex;  ///< frames of one shape are alike but for their points
    std::int32_t level = 0;          ///< of the points
    std::span<const std::int32_t> points;
  };
  static constexpr std::int32_t kNoVertex = -1;
  Place placeOf(std::int32_t point) const;
  /// Points and weights (in TileLimits::weights) of a shape; zero of kNoVertex.
  std::int32_t sidesOf(std::int32_t shape) const;
  std::int32_t firstWeight(std::int32_t shape) const;
  /// Are the weights of a shape kHexagonSpan?
  bool isHexagon(std::int32_t shape) const { return shape >= 0 && hexagons_[static_cast<std::size_t>(shape)] != 0; }
  /// Weights and shared rows, for the finished table.
  void moveTo(TileLimits& limits) &&;

 private:
  const FrameBatch& batch(std::int32_t shape) const;
  std::int32_t childShapes() const { return static_cast<std::int32_t>(limits_.vertices.batches.size()); }
  template <class Visit>
  void forShared(const Visit& visit) const;

  const LimitTable& limits_;
  std::int32_t root_;
  std::int32_t wanted_;
  std::int32_t last_;
  std::vector<std::int32_t> rows_;      // per point: among the elements of `vertices`, then those of `verticesHere`; -1
  std::vector<std::uint8_t> shared_;    // per point
  std::vector<std::uint8_t> hexagons_;  // per shape
  LimitRows sharedRows_;
};

}  // namespace honeycomb::Far
