#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "far/base/array.h"
#include "far/tables/tile_clusters.h"
#include "far/tables/tile_limit_plan.h"
#include "far/tables/tile_normal_plan.h"
#include "far/tables/tile_sharing.h"
#include "far/tables/tile_table.h"
#include "far/tables/tile_units.h"

namespace honeycomb::Far {

/// The last level whose points tiles make: behind the wanted one for its limits.
constexpr std::int32_t lastRead(std::int32_t wanted, const TileOptions& options) {
  return options.normals == TileNormalKind::exact ? wanted + 1 : wanted;
}

/// Everything about a mesh that its tiles are put together from; shared by the threads that do so.
class TilePlan {
 public:
  TilePlan(const Refinement& refinement, std::int32_t root, std::int32_t last, std::int32_t pointsPerTile,
           const TileOptions& options);

  /// The chains of a tile that are born at level k, ascending.
  std::span<const std::int32_t> owned(std::int32_t k, std::int32_t tile) const;
  /// Where the weights of level k begin among those of all levels.
  std::int32_t firstWeight(std::int32_t k) const { return firstWeights_[static_cast<std::size_t>(k)]; }

  TileUnits units;
  std::vector<std::vector<std::int32_t>> large;  ///< units per level
  std::optional<TileNormalPlan> normals;
  std::optional<TileLimitPlan> limits;
  TileSharing sharing;
  TileOwners owners;
  TileOrder order;
  TilePlaces places;

 private:
  struct Lists {
    std::vector<std::int32_t> offsets;  // per tile
    Array<std::int32_t> chains;
  };
  void listOwned();
  std::vector<std::vector<std::int32_t>> wantedPoints() const;

  std::vector<Lists> owned_;
  std::vector<std::int32_t> firstWeights_;
};

/// Some tiles one after the other: the arrays of a TileTable, with places counted from their own beginnings.
struct TileParts {
  std::vector<Tile> tiles;
  std::vector<TileStep> steps;
  std::vector<TileStage> stages;
  std::vector<std::int32_t> imports;
  std::vector<TilePoint> indices;
  std::vector<TileRow> rows;
  std::vector<std::int32_t> outputs;
  std::vector<std::int32_t> written;
  TileNormals normals;
  TileLimits limits;
  std::int32_t largestTile = 0;  ///< points or normals; past kMostTilePoints the parts are of no use
};

/// Working memory for putting tiles together, one for each thread.
class TileAssembler {
 public:
  explicit TileAssembler(const TilePlan& plan);
  void add(std::int32_t tile, TileParts& parts);

 private:
  /// What a tile knows of a chain it holds.
  struct Held {
    std::int32_t tile = -1;
    std::int32_t step = 0;
    std::int32_t place = 0;  // among the chains of the step
    std::int32_t last = 0;   // level
    bool rings = false;      // its vertices' exact normals are found round it: TileRings
  };
  struct Import {
    std::int32_t tile = -1;
    std::int32_t number = 0;
  };

  void collect();
  void collectNormals();
  void touchNormal(std::int32_t normal);
  void numberNormals(TileParts& parts);
  TileBorn numberBorn(std::int32_t k, std::span<const std::uint64_t> keys, std::int32_t firstNormal);
  std::int32_t bornNormal(std::int32_t k, const UnitBatch& batch, std::int32_t unit) const;
  void addNormalFaces(const UnitBatch& batch, std::span<const std::int32_t> units, TileParts& parts) const;
  void addFrames(TileParts& parts) const;
  void collectLimits();
  bool isRing(std::int32_t chain, const UnitBatch& batch, std::int32_t unit) const;
  void addLimits(std::size_t firstStep, TileParts& parts) const;
  void addLimitsOf(const TileStep& step, TileParts& parts) const;
  void addRings(std::size_t number, std::int32_t chain, TileParts& parts) const;
  /// Calls visit(chain, batch, unit) for what makes the tile's own points of the wanted level.
  template <class Visit>
  void forOwnedUnits(const Visit& visit) const {
    const TileUnits& units = plan_.units;
    const LevelUnits& wanted = units.level(units.wanted());
    for (std::int32_t k = units.root() + 1; k <= units.wanted(); ++k) {
      for (const std::int32_t chain : plan_.owned(k, tile_)) {
        const std::int32_t unit = units.unitAt(chain, units.wanted());
        if (unit >= 0) visit(chain, wanted.batchOf(unit), unit);
      }
    }
  }
  template <class Visit>
  void forWritten(const TileStep& step, const TileParts& parts, const Visit& visit) const;
  void touch(std::int32_t chain, std::int32_t level);
  void touchPoint(std::int32_t k, std::int32_t point);
  void import(std::int32_t point);
  void addImports(TileParts& parts);
  /// Chains of one step, those of one batch, ownership, kind of exact normals and of indices and last level, have equal
  /// keys but for the unit:
  ///     | batch | not owned 1 | rings 1 | pairs 1 | last 7 | unit 32 |
  static constexpr int kUnitBits = 32;
  /// Calls visit(keys of the chains of a step) for the steps of level k, in their order.
  template <class Visit>
  void forSteps(std::int32_t k, const Visit& visit) const {
    const std::span<const std::uint64_t> births = births_[static_cast<std::size_t>(k - plan_.units.root() - 1)];
    for (std::size_t begin = 0; begin < births.size();) {
      std::size_t end = begin + 1;
      while (end < births.size() && births[end] >> kUnitBits == births[begin] >> kUnitBits) ++end;
      visit(births.subspan(begin, end - begin));
      begin = end;
    }
  }
  std::uint64_t keyOf(std::int32_t k, const UnitBatch& batch, std::int32_t unit) const;
  static std::int32_t lastOf(std::uint64_t key);
  static bool ownedOf(std::uint64_t key);
  static std::int32_t unitOf(std::uint64_t key) { return static_cast<std::int32_t>(key & 0xffffffffu); }
  void addStep(std::int32_t k, std::span<const std::uint64_t> keys, TileParts& parts);
  void addStages(std::int32_t k, const UnitBatch& batch, std::span<const std::uint64_t> keys, bool owned,
                 TileStep& step, TileParts& parts);
  void addOutputs(std::int32_t k, const UnitBatch& batch, std::span<const std::int32_t> units, TileStage& stage,
                  TileParts& parts);
  void addIndices(std::int32_t k, const UnitBatch& batch, std::span<const std::uint64_t> keys, TileParts& parts) const;
  TilePoint ownNumber(std::int32_t k, std::int32_t point, const TileParts& parts) const;
  static bool ringsOf(std::uint64_t key);
  static bool pairsOf(std::uint64_t key);
  bool isPaired(std::int32_t k, const UnitBatch& batch, std::int32_t unit) const;
  std::int32_t weightOf(std::int32_t k, const UnitBatch& batch) const;

  const TilePlan& plan_;
  std::int32_t tile_ = -1;
  std::int32_t pointCount_ = 0;
  std::vector<Held> held_;        // per chain
  std::vector<Import> imported_;  // per root point, then per shared point
  std::vector<std::int32_t> imports_;
  std::vector<std::vector<std::uint64_t>> births_;  // per level: keys of the chains held
  std::vector<Import> normalsHeld_;                 // per normal
  std::vector<std::int32_t> normals_;               // those held: shared ones, then others by place
  std::vector<std::int32_t> born_;                  // those of a step's faces
};

}  // namespace honeycomb::Far
