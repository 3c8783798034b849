#include "far/tables/tile_clusters.h"

#include <algorithm>
#include <array>
#include <deque>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// The units of the level behind the root by the points they read, in compressed rows.
struct Readers {
  std::vector<std::int32_t> offsets;
  std::vector<std::int32_t> units;

  Readers(const LevelUnits& level, std::int32_t pointCount) : offsets(at(pointCount) + 1, 0) {
    forEntries(level, [&](std::int32_t point, std::int32_t) { ++offsets[at(point)]; });
    Parallel::exclusiveScan(offsets);
    units.resize(at(offsets.back()));
    std::vector<std::int32_t> next(offsets.begin(), offsets.end() - 1);
    forEntries(level, [&](std::int32_t point, std::int32_t unit) { units[at(next[at(point)]++)] = unit; });
  }

  template <class Visit>
  static void forEntries(const LevelUnits& level, const Visit& visit) {
    for (const UnitBatch& batch : level.batches) {
      for (std::int32_t u = batch.firstUnit; u < batch.firstUnit + batch.count; ++u) {
        if (level.tooLarge(batch, u)) continue;
        for (const std::int32_t point : level.sources(batch, u)) visit(point, u);
      }
    }
  }
};

/// Units by a count that only grows: each stands in the queue of every count it has had, and only its place in the
/// last of them is good.
class CountQueues {
 public:
  void push(std::int32_t unit, std::int32_t count) {
    const std::int32_t queue = std::min(count, kMostCount);
    queues_[at(queue)].units.push_back(unit);
    highest_ = std::max(highest_, queue);
  }

  /// The good unit that has waited longest in the queue of the highest count; -1: none is left. good(unit, count)
  /// tells of a place whether it is.
  template <class Good>
  std::int32_t pop(const Good& good) {
    for (; highest_ > 0; --highest_) {
      Queue& queue = queues_[at(highest_)];
      while (queue.next < queue.units.size()) {
        const std::int32_t unit = queue.units[queue.next++];
        if (good(unit, highest_)) return unit;
      }
    }
    return -1;
  }

  void clear() {
    for (Queue& queue : queues_) {
      queue.units.clear();
      queue.next = 0;
    }
    highest_ = 0;
  }

  /// Higher counts are taken for this one.
  static constexpr std::int32_t kMostCount = 64;

 private:
  struct Queue {
    std::vector<std::int32_t> units;
    std::size_t next = 0;
  };
  std::array<Queue, at(kMostCount + 1)> queues_;
  std::int32_t highest_ = 0;
};

/// Grows one tile after the other from a seed, always by the unit that shares the most points with it.
class TileGrowth {
 public:
  TileGrowth(const LevelUnits& level, std::int32_t rootPoints, std::int32_t pointsPerTile)
      : level_(level),
        readers_(level, rootPoints),
        pointsPerTile_(pointsPerTile),
        owner_(at(level.unitCount), kFree),
        shared_(at(level.unitCount), 0) {}

  TileOwners grow() {
    std::int32_t firstFree = 0;
    for (;;) {
      const std::int32_t seed = nextSeed(firstFree);
      if (seed < 0) break;
      if (points_ == 0 || points_ >= pointsPerTile_) open();
      growFrom(seed);
    }
    return {tileCount_, std::move(owner_)};
  }

 private:
  static constexpr std::int32_t kFree = -2;
  /// A point that more units read tells nothing of who is near whom.
  static constexpr std::int32_t kMostReaders = 64;

  void open() {
    ++tileCount_;
    points_ = 0;
  }

  /// The free unit that has waited longest at the rim of the tiles, else the free unit of lowest number.
  std::int32_t nextSeed(std::int32_t& firstFree) {
    while (!rim_.empty()) {
      const std::int32_t unit = rim_.front();
      rim_.pop_front();
      if (owner_[at(unit)] == kFree) return unit;
    }
    for (; firstFree < level_.unitCount; ++firstFree) {
      if (owner_[at(firstFree)] != kFree) continue;
      if (!level_.tooLarge(level_.batchOf(firstFree), firstFree)) return firstFree;
      owner_[at(firstFree)] = -1;
    }
    return -1;
  }

  void growFrom(std::int32_t seed) {
    take(seed);
    const auto nearest = [&](std::int32_t unit, std::int32_t count) {
      return owner_[at(unit)] == kFree && std::min(shared_[at(unit)], CountQueues::kMostCount) == count;
    };
    while (points_ < pointsPerTile_) {
      const std::int32_t unit = byShared_.pop(nearest);
      if (unit < 0) break;
      take(unit);
    }
    for (const std::int32_t unit : near_) {
      if (owner_[at(unit)] != kFree) continue;
      shared_[at(unit)] = 0;
      rim_.push_back(unit);
    }
    near_.clear();
    byShared_.clear();
  }

  void take(std::int32_t unit) {
    const UnitBatch& batch = level_.batchOf(unit);
    owner_[at(unit)] = tileCount_ - 1;
    points_ += batch.outputs;
    for (const std::int32_t point : level_.sources(batch, unit)) {
      const std::int32_t first = readers_.offsets[at(point)];
      const std::int32_t end = std::min(readers_.offsets[at(point) + 1], first + kMostReaders);
      for (std::int32_t i = first; i < end; ++i) {
        const std::int32_t other = readers_.units[at(i)];
        if (owner_[at(other)] != kFree) continue;
        if (++shared_[at(other)] == 1) near_.push_back(other);
        byShared_.push(other, shared_[at(other)]);
      }
    }
  }

  const LevelUnits& level_;
  Readers readers_;
  std::int32_t pointsPerTile_;
  std::int32_t tileCount_ = 0;
  std::int32_t points_ = 0;  // of the open tile
  std::vector<std::int32_t> owner_;
  std::vector<std::int32_t> shared_;  // points of a free unit that the open tile reads too
  std::vector<std::int32_t> near_;    // units that had such points when they were free, oldest first
  CountQueues byShared_;              // the same by how many
  std::deque<std::int32_t> rim_;
};

}  // namespace

TileOwners growTiles(const TileUnits& units, const TileSharing& sharing, std::int32_t pointsPerTile) {
  const std::int32_t first = units.root() + 1;
  TileOwners owners = TileGrowth(units.level(first), units.rootPoints(), pointsPerTile).grow();
  owners.of.resize(at(units.chainCount()), -1);
  constexpr std::int32_t kOrphan = -2;  // reads nothing but shared points
  std::int32_t orphanPoints = 0;
  for (std::int32_t k = first + 1; k <= units.wanted(); ++k) {
    const LevelUnits& level = units.level(k);
    const LevelUnits& before = units.level(k - 1);
    for (const UnitBatch& batch : level.batches) {
      Parallel::forEach(batch.firstUnit, batch.firstUnit + batch.count, [&](std::int64_t i) {
        const auto unit = static_cast<std::int32_t>(i);
        const std::int32_t chain = level.firstChain + unit;
        if (level.chain[at(unit)] != chain || level.tooLarge(batch, unit)) return;
        std::int32_t owner = kOrphan;
        for (const std::int32_t point : level.sources(batch, unit)) {
          if (sharing.sharedPoint(k - 1, point) >= 0) continue;
          owner = owners.of[at(before.pointChain[at(point)])];
          break;
        }
        owners.of[at(chain)] = owner;
      });
    }
    if (sharing.pointCount() == 0) continue;
    for (const UnitBatch& batch : level.batches) {
      for (std::int32_t u = batch.firstUnit; u < batch.firstUnit + batch.count; ++u) {
        std::int32_t& owner = owners.of[at(level.firstChain + u)];
        if (owner != kOrphan) continue;
        if (orphanPoints == 0) ++owners.tileCount;
        owner = owners.tileCount - 1;
        orphanPoints += batch.outputs;
        if (orphanPoints >= pointsPerTile) orphanPoints = 0;
      }
    }
  }
  return owners;
}

}  // namespace honeycomb::Far
