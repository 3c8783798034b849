#include "far/tables/tile_units.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// The units of a level's circulant faces by their outputs.
class FaceFinder {
 public:
  explicit FaceFinder(const LevelUnits& level) : level_(level) {
    for (std::size_t b = 0; b < level.batches.size(); ++b) {
      if (level.batches[b].kind == UnitBatch::Kind::circulant) order_.push_back(static_cast<std::int32_t>(b));
    }
    std::ranges::sort(order_, {}, [&](std::int32_t b) { return level.batches[at(b)].firstOutput; });
  }

  /// The batch and unit whose points begin with `point`; unit -1 where none do.
  struct Found {
    std::int32_t batch = -1, unit = -1;
  };
  Found faceFrom(std::int32_t point) const {
    const auto behind =
        std::ranges::upper_bound(order_, point, {}, [&](std::int32_t b) { return level_.batches[at(b)].firstOutput; });
    if (behind == order_.begin()) return {};
    const std::int32_t b = *(behind - 1);
    const UnitBatch& batch = level_.batches[at(b)];
    const std::int32_t distance = point - batch.firstOutput;
    if (distance % batch.outputs != 0 || distance / batch.outputs >= batch.count) return {};
    return {b, batch.firstUnit + distance / batch.outputs};
  }

 private:
  const LevelUnits& level_;
  std::vector<std::int32_t> order_;
};

bool consecutive(std::span<const std::int32_t> points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i] != points[0] + static_cast<std::int32_t>(i)) return false;
  }
  return true;
}

}  // namespace

const LevelTable& tableOf(const Refinement& refinement, std::int32_t k) {
  return k > refinement.levelCount() ? refinement.limits().child : refinement.level(k).table;
}

const UnitBatch& LevelUnits::batchOf(std::int32_t unit) const {
  const auto behind = std::ranges::upper_bound(batches, unit, {}, &UnitBatch::firstUnit);
  return *(behind - 1);
}

std::span<const std::int32_t> LevelUnits::sources(const UnitBatch& batch, std::int32_t unit) const {
  const std::span<const std::int32_t> all = table->indices;
  const std::int32_t u = unit - batch.firstUnit;
  const auto fixed = [&](std::int32_t firstIndex) {
    return all.subspan(at(firstIndex) + at(u) * at(batch.width), at(batch.width));
  };
  switch (batch.kind) {
    case UnitBatch::Kind::circulant:
      return fixed(table->circulants[at(batch.batch)].firstIndex);
    case UnitBatch::Kind::dense:
      return fixed(table->dense[at(batch.batch)].firstIndex);
    case UnitBatch::Kind::projected:
      return fixed(table->projected[at(batch.batch)].firstIndex);
    case UnitBatch::Kind::summed:
    case UnitBatch::Kind::loose:
      break;
  }
  const LooseRows& rows = *rowsOf(batch);
  return all.subspan(at(rows.firstIndex + rows.offsets[at(u)]), at(rows.offsets[at(u) + 1] - rows.offsets[at(u)]));
}

const LooseRows* LevelUnits::rowsOf(const UnitBatch& batch) const {
  if (batch.kind == UnitBatch::Kind::loose) return &table->loose;
  return batch.kind == UnitBatch::Kind::summed ? &table->summed.rows : nullptr;
}

std::int32_t LevelUnits::firstOutput(const UnitBatch& batch, std::int32_t unit) const {
  const std::int32_t u = unit - batch.firstUnit;
  const LooseRows* rows = rowsOf(batch);
  return rows != nullptr ? rows->outputs[at(u)] : batch.firstOutput + u * batch.outputs;
}

bool LevelUnits::tooLarge(const UnitBatch& batch, std::int32_t unit) const {
  if (batch.kind == UnitBatch::Kind::projected || batch.kind == UnitBatch::Kind::summed) return true;
  return batch.kind == UnitBatch::Kind::loose && std::ssize(sources(batch, unit)) > kMostTileEntries;
}

TileUnits::TileUnits(const Refinement& refinement, std::int32_t root, std::int32_t wanted, std::int32_t last)
    : root_(root),
      wanted_(wanted),
      rootPoints_(refinement.level(root + 1).table.sourceCount),
      levels_(at(last - root)) {
  for (std::int32_t k = root + 1; k <= last; ++k) {
    LevelUnits& level = levelAt(k);
    level.table = &tableOf(refinement, k);
    addBatches(level);
    level.firstChain = chainCount_;
    chainCount_ += level.unitCount;
    level.child.assign(at(level.unitCount), -1);
    linkChains(k);
    if (read(k)) nameMakers(level);
  }
}

void TileUnits::addBatches(LevelUnits& level) {
  const auto add = [&](UnitBatch batch) {
    batch.firstUnit = level.unitCount;
    level.unitCount += batch.count;
    if (batch.count > 0) level.batches.push_back(batch);
  };
  const LevelTable& table = *level.table;
  using Kind = UnitBatch::Kind;
  for (std::size_t b = 0; b < table.circulants.size(); ++b) {
    const CirculantBatch& batch = table.circulants[b];
    add({Kind::circulant, static_cast<std::int32_t>(b), 0, batch.faceCount, batch.sides, batch.sides,
         batch.firstOutput});
  }
  for (std::size_t b = 0; b < table.dense.size(); ++b) {
    const DenseRows& batch = table.dense[b];
    add({Kind::dense, static_cast<std::int32_t>(b), 0, batch.rowCount, 1, batch.width, batch.firstOutput});
  }
  for (std::size_t b = 0; b < table.projected.size(); ++b) {
    const ProjectedFace& face = table.projected[b];
    add({Kind::projected, static_cast<std::int32_t>(b), 0, 1, face.outputs, face.corners, face.firstOutput});
  }
  add({Kind::summed, 0, 0, table.summed.rowCount(), 1, 0, 0});
  add({Kind::loose, 0, 0, table.loose.rowCount(), 1, 0, 0});
}

void TileUnits::linkChains(std::int32_t k) {
  LevelUnits& level = levelAt(k);
  level.chain.resize(at(level.unitCount));
  Parallel::forEach(0, level.unitCount,
                    [&](std::int64_t u) { level.chain[at(u)] = level.firstChain + static_cast<std::int32_t>(u); });
  if (k == root_ + 1) return;
  LevelUnits& before = levelAt(k - 1);
  const FaceFinder finder(before);
  const auto parentOf = [&](const UnitBatch& batch, std::int32_t unit) -> FaceFinder::Found {
    const std::span<const std::int32_t> sources = level.sources(batch, unit);
    const FaceFinder::Found found = finder.faceFrom(sources.front());
    if (found.unit < 0 || !consecutive(sources)) return {};
    const UnitBatch& parents = before.batches[at(found.batch)];
    const auto form = [](const LevelUnits& of, const UnitBatch& faces) {
      return of.table->circulants[at(faces.batch)].form;
    };
    const bool alike = parents.outputs == batch.outputs && form(before, parents) == form(level, batch);
    return alike ? found : FaceFinder::Found{};
  };
  // Where the faces of a batch live on is decided by the first of them, so that they all stay together.
  std::vector<std::int32_t> firstHeir(before.batches.size(), std::numeric_limits<std::int32_t>::max());
  std::mutex mutex;
  std::vector<FaceFinder::Found> parents(at(level.unitCount));
  for (const UnitBatch& batch : level.batches) {
    if (batch.kind != UnitBatch::Kind::circulant) continue;
    Parallel::forRange(batch.firstUnit, batch.firstUnit + batch.count, Parallel::kGrain,
                       [&](std::int64_t begin, std::int64_t end) {
                         std::vector<std::int32_t> heir(firstHeir.size(), std::numeric_limits<std::int32_t>::max());
                         for (std::int64_t u = begin; u < end; ++u) {
                           const FaceFinder::Found parent = parentOf(batch, static_cast<std::int32_t>(u));
                           parents[at(u)] = parent;
                           if (parent.unit < 0) continue;
                           heir[at(parent.batch)] = std::min(heir[at(parent.batch)], static_cast<std::int32_t>(u));
                         }
                         const std::lock_guard lock(mutex);
                         for (std::size_t b = 0; b < heir.size(); ++b) firstHeir[b] = std::min(firstHeir[b], heir[b]);
                       });
  }
  for (std::size_t b = 0; b < firstHeir.size(); ++b) {
    if (firstHeir[b] == std::numeric_limits<std::int32_t>::max()) continue;
    before.batches[b].successor = static_cast<std::int32_t>(&level.batchOf(firstHeir[b]) - level.batches.data());
  }
  for (std::size_t b = 0; b < level.batches.size(); ++b) {
    const UnitBatch& batch = level.batches[b];
    if (batch.kind != UnitBatch::Kind::circulant) continue;
    Parallel::forEach(batch.firstUnit, batch.firstUnit + batch.count, [&](std::int64_t u) {
      const FaceFinder::Found parent = parents[at(u)];
      if (parent.unit < 0 || before.batches[at(parent.batch)].successor != static_cast<std::int32_t>(b)) return;
      before.child[at(parent.unit)] = static_cast<std::int32_t>(u);
      level.chain[at(u)] = before.chain[at(parent.unit)];
    });
  }
}

void TileUnits::nameMakers(LevelUnits& level) {
  level.pointChain.resize(at(level.table->targetCount));
  level.pointPlace.resize(at(level.table->targetCount));
  for (const UnitBatch& batch : level.batches) {
    Parallel::forEach(
        batch.firstUnit, batch.firstUnit + batch.count,
        [&](std::int64_t u) {
          const auto unit = static_cast<std::int32_t>(u);
          const std::int32_t first = level.firstOutput(batch, unit);
          for (std::int32_t i = 0; i < batch.outputs; ++i) {
            level.pointChain[at(first + i)] = level.chain[at(u)];
            level.pointPlace[at(first + i)] = static_cast<std::uint8_t>(i);
          }
        },
        Parallel::kGrain / std::clamp<std::int64_t>(batch.outputs, 1, Parallel::kGrain));
  }
}

std::int32_t TileUnits::birth(std::int32_t chain) const {
  std::int32_t k = last();
  while (level(k).firstChain > chain) --k;
  return k;
}

std::int32_t TileUnits::end(std::int32_t chain) const {
  std::int32_t k = birth(chain);
  for (std::int32_t unit = chain - level(k).firstChain; (unit = level(k).child[at(unit)]) >= 0;) ++k;
  return k;
}

std::int32_t TileUnits::unitAt(std::int32_t chain, std::int32_t k) const {
  std::int32_t here = birth(chain);
  std::int32_t unit = chain - level(here).firstChain;
  for (; here < k && unit >= 0; ++here) unit = level(here).child[at(unit)];
  return unit;
}

}  // namespace honeycomb::Far
