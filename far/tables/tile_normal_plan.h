#pragma once

#include <cstdint>
#include <vector>

#include "far/tables/normal_rule.h"
#include "far/tables/tile_sharing.h"
#include "far/tables/tile_table.h"

namespace honeycomb::Far {

/// The normals of a level as tiles need them: what each is made from, and which are shared.
class TileNormalPlan {
 public:
  /// `large`: those of `units` that are too large for a tile, whose points' normals are found for all.
  TileNormalPlan(const Refinement& refinement, const TileUnits& units,
                 const std::vector<std::vector<std::int32_t>>& large);

  const NormalRule& rule() const { return rule_; }
  /// The corners of faces whose normals are shared, per level root + 1 .. last: they must be shared too.
  std::vector<std::vector<std::int32_t>> sharedCorners() const;
  /// Numbers the shared normals and finds their points; once, before the rest.
  void share(const TileSharing& sharing);

  /// The shared number of a normal, -1 if tiles find it.
  std::int32_t shared(std::int32_t normal) const { return shared_[static_cast<std::size_t>(normal)]; }
  /// Where a normal is born, and how it is found there.
  struct Place {
    std::int32_t level = 0;
    std::int32_t batch = 0;
    std::span<const std::int32_t> corners;
  };
  Place placeOf(std::int32_t normal) const;
  const FrameBatch& batchAt(std::int32_t level, std::int32_t batch) const {
    return frames_[static_cast<std::size_t>(level)].batches[static_cast<std::size_t>(batch)];
  }
  /// Where the weights of the frames of a level begin among those of all levels.
  std::int32_t firstWeight(std::int32_t level) const { return firstWeights_[static_cast<std::size_t>(level)]; }
  /// Weights and shared rows, for the finished table.
  void moveTo(TileNormals& normals) &&;

 private:
  void chooseShared(const TileUnits& units, const std::vector<std::int32_t>& large);
  LimitRows sharedRows(std::int32_t level, const TileSharing& sharing);

  std::int32_t root_;
  std::int32_t last_;
  NormalRule rule_;
  std::vector<LimitRows> frames_;           // per level 0 .. last - 1
  std::vector<std::int32_t> firstWeights_;  // per level
  std::vector<std::int32_t> rows_;          // per normal: its place among the elements of its level
  std::vector<std::int32_t> shared_;        // per normal: its number, kToShare before share()
  std::int32_t sharedCount_ = 0;
  std::vector<LimitRows> sharedRows_;   // per level
  Array<std::int32_t> offsets_, sums_;  // TileNormals::sharedOffsets and, as normals, sharedFaces
};

}  // namespace honeycomb::Far
