#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/tables/level_table.h"
#include "far/tables/refinement.h"
#include "far/tables/tile_table.h"

namespace honeycomb::Far {

/// Rows with more entries are too large for a tile.
constexpr std::int32_t kMostTileEntries = 256;

/// What makes level k: of the refinement's last level + 1, what its limits read.
const LevelTable& tableOf(const Refinement& refinement, std::int32_t k);

/// The units of one batch of a level table: what a tile takes as a whole. A face of a circulant batch with all its
/// points, or a row.
struct UnitBatch {
  enum class Kind : std::uint8_t { circulant, dense, loose, projected, summed };
  Kind kind = Kind::circulant;
  std::int32_t batch = 0;        ///< in the table's list of its kind
  std::int32_t firstUnit = 0;    ///< units of a level are numbered batch after batch
  std::int32_t count = 0;        ///< projected: each face is a batch of its own
  std::int32_t outputs = 1;      ///< points a unit
  std::int32_t width = 0;        ///< points it reads; 0 for loose and summed rows, which differ
  std::int32_t firstOutput = 0;  ///< not of loose and summed rows
  std::int32_t successor = -1;   ///< the batch of the next level in which its faces live on
};

/// A level's units, and how they hang together with those of the level before.
struct LevelUnits {
  const LevelTable* table = nullptr;
  std::vector<UnitBatch> batches;
  std::int32_t unitCount = 0;
  std::int32_t firstChain = 0;  ///< a chain is named firstChain + unit, by the level and the unit of its birth

  std::vector<std::int32_t> chain;  ///< per unit: the chain it belongs to
  std::vector<std::int32_t> child;  ///< per unit: the unit of the next level in which it lives on, -1
  /// Per point: the chain that makes it, and its place among the points of that; of levels that are read.
  std::vector<std::int32_t> pointChain;
  std::vector<std::uint8_t> pointPlace;

  const UnitBatch& batchOf(std::int32_t unit) const;
  /// The points of the level before that a unit reads; of a summed row those it reads beside the sums.
  std::span<const std::int32_t> sources(const UnitBatch& batch, std::int32_t unit) const;
  std::int32_t firstOutput(const UnitBatch& batch, std::int32_t unit) const;
  bool tooLarge(const UnitBatch& batch, std::int32_t unit) const;
  /// The rows of a batch of loose or summed ones; of others nullptr.
  const LooseRows* rowsOf(const UnitBatch& batch) const;
};

/// The units of the levels behind a root level, up to the wanted one or, for the limits of that, one further. A face
/// that reads exactly the points of one face of the level before, in its order, is that face living on: together they
/// are a chain.
class TileUnits {
 public:
  /// `last`: `wanted`, or wanted + 1: what the refinement's limits make of its last level, `wanted`.
  TileUnits(const Refinement& refinement, std::int32_t root, std::int32_t wanted, std::int32_t last);

  std::int32_t root() const { return root_; }
  /// The level that tiles write.
  std::int32_t wanted() const { return wanted_; }
  std::int32_t last() const { return root_ + static_cast<std::int32_t>(levels_.size()); }
  /// Are points of level k read by others?
  bool read(std::int32_t k) const { return k < wanted_ || last() > wanted_; }
  /// Level k in root + 1 .. last.
  const LevelUnits& level(std::int32_t k) const { return levels_[static_cast<std::size_t>(k - root_ - 1)]; }
  std::int32_t chainCount() const { return chainCount_; }
  /// The level at which a chain is born.
  std::int32_t birth(std::int32_t chain) const;
  /// The last level at which it lives.
  std::int32_t end(std::int32_t chain) const;
  /// The unit of a chain at level k, -1 if it ends before.
  std::int32_t unitAt(std::int32_t chain, std::int32_t k) const;
  std::int32_t rootPoints() const { return rootPoints_; }

 private:
  LevelUnits& levelAt(std::int32_t k) { return levels_[static_cast<std::size_t>(k - root_ - 1)]; }
  void addBatches(LevelUnits& level);
  void linkChains(std::int32_t k);
  void nameMakers(LevelUnits& level);

  std::int32_t root_ = 0;
  std::int32_t wanted_ = 0;
  std::int32_t rootPoints_ = 0;
  std::int32_t chainCount_ = 0;
  std::vector<LevelUnits> levels_;
};

}  // namespace honeycomb::Far
