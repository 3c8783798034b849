#include "far/tables/tile_assembler.h"

#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

TilePlan::TilePlan(const Refinement& refinement, std::int32_t root, std::int32_t last, std::int32_t pointsPerTile,
                   const TileOptions& options)
    : units(refinement, root, last, lastRead(last, options)),
      large(largeUnits(units)),
      normals(options.normals == TileNormalKind::fast
                  ? std::optional<TileNormalPlan>(std::in_place, refinement, units, large)
                  : std::nullopt),
      limits(options.normals == TileNormalKind::exact
                 ? std::optional<TileLimitPlan>(std::in_place, refinement.limits(), units, large)
                 : std::nullopt),
      sharing(units, large, wantedPoints()),
      owners(growTiles(units, sharing, pointsPerTile)),
      order(options.order),
      places(options.places) {
  if (normals) normals->share(sharing);
  if (limits) limits->share(sharing);
  std::int32_t weights = 0;
  for (std::int32_t k = 0; k <= units.last(); ++k) {
    firstWeights_.push_back(weights);
    if (k > root) weights += static_cast<std::int32_t>(units.level(k).table->weights.size());
  }
  listOwned();
}

/// What normals need to be shared.
std::vector<std::vector<std::int32_t>> TilePlan::wantedPoints() const {
  if (normals) return normals->sharedCorners();
  if (limits) return limits->sharedPoints();
  return {};
}

void TilePlan::listOwned() {
  for (std::int32_t k = units.root() + 1; k <= units.wanted(); ++k) {
    const LevelUnits& level = units.level(k);
    // Chains of nobody go behind the last tile.
    std::vector<std::int32_t> keys(at(level.unitCount));
    Parallel::forEach(0, level.unitCount, [&](std::int64_t u) {
      const std::int32_t chain = level.firstChain + static_cast<std::int32_t>(u);
      const std::int32_t owner = level.chain[at(u)] == chain ? owners.of[at(chain)] : -1;
      keys[at(u)] = owner < 0 ? owners.tileCount : owner;
    });
    Lists& lists = owned_.emplace_back();
    lists.chains = Parallel::stableOrder(keys, owners.tileCount + 1);
    lists.offsets.assign(at(owners.tileCount) + 2, 0);
    for (const std::int32_t key : keys) ++lists.offsets[at(key)];
    Parallel::exclusiveScan(lists.offsets);
    Parallel::forEach(0, level.unitCount, [&](std::int64_t i) { lists.chains[at(i)] += level.firstChain; });
  }
}

std::span<const std::int32_t> TilePlan::owned(std::int32_t k, std::int32_t tile) const {
  const Lists& lists = owned_[at(k - units.root() - 1)];
  const std::int32_t begin = lists.offsets[at(tile)];
  return std::span(lists.chains).subspan(at(begin), at(lists.offsets[at(tile) + 1] - begin));
}

namespace {

constexpr int kLastBits = 7;
constexpr int kKindBits = 3;
constexpr std::uint64_t kNotOwned = 4, kRings = 2, kPairs = 1;

}  // namespace

std::uint64_t TileAssembler::keyOf(std::int32_t k, const UnitBatch& batch, std::int32_t unit) const {
  const auto bits = [](auto number) { return static_cast<std::uint64_t>(number); };
  const LevelUnits& level = plan_.units.level(k);
  const std::int32_t chain = level.firstChain + unit;
  const Held& held = held_[at(chain)];
  const bool owned = plan_.owners.of[at(chain)] == tile_;
  const std::uint64_t kind = bits(&batch - level.batches.data()) << kKindBits | (owned ? 0 : kNotOwned) |
                             (held.rings ? kRings : 0) | (isPaired(k, batch, unit) ? kPairs : 0);
  return (kind << kLastBits | bits(held.last)) << kUnitBits | bits(unit);
}

std::int32_t TileAssembler::lastOf(std::uint64_t key) {
  return static_cast<std::int32_t>((key >> kUnitBits) & ((1u << kLastBits) - 1));
}

bool TileAssembler::ownedOf(std::uint64_t key) {
  return ((key >> (kUnitBits + kLastBits)) & kNotOwned) == 0;
}

bool TileAssembler::ringsOf(std::uint64_t key) {
  return ((key >> (kUnitBits + kLastBits)) & kRings) != 0;
}

bool TileAssembler::pairsOf(std::uint64_t key) {
  return ((key >> (kUnitBits + kLastBits)) & kPairs) != 0;
}

TileAssembler::TileAssembler(const TilePlan& plan)
    : plan_(plan),
      held_(at(plan.units.chainCount())),
      imported_(at(plan.units.rootPoints() + plan.sharing.pointCount())),
      births_(at(plan.units.last() - plan.units.root())),
      normalsHeld_(plan.normals ? at(plan.normals->rule().normalCount()) : 0) {}

void TileAssembler::add(std::int32_t tile, TileParts& parts) {
  tile_ = tile;
  collect();
  Tile made;
  made.firstStep = static_cast<std::int32_t>(parts.steps.size());
  made.firstImport = static_cast<std::int32_t>(parts.imports.size());
  made.importCount = static_cast<std::int32_t>(imports_.size());
  addImports(parts);
  if (plan_.normals) numberNormals(parts);
  for (std::int32_t k = plan_.units.root() + 1; k <= plan_.units.last(); ++k) {
    forSteps(k, [&](std::span<const std::uint64_t> keys) { addStep(k, keys, parts); });
  }
  if (plan_.normals) addFrames(parts);
  if (plan_.limits) addLimits(at(made.firstStep), parts);
  made.stepCount = static_cast<std::int32_t>(parts.steps.size()) - made.firstStep;
  made.pointCount = pointCount_;
  parts.largestTile = std::max(parts.largestTile, pointCount_);
  parts.tiles.push_back(made);
}

/// The chains a tile holds: its own to their ends or the wanted level, and those whose points are read to the last
/// level where they are.
void TileAssembler::collect() {
  const TileUnits& units = plan_.units;
  imports_.clear();
  for (auto& births : births_) births.clear();
  for (std::int32_t k = units.root() + 1; k <= units.wanted(); ++k) {
    for (const std::int32_t chain : plan_.owned(k, tile_)) touch(chain, std::min(units.end(chain), units.wanted()));
  }
  if (plan_.normals) collectNormals();
  if (plan_.limits) collectLimits();
  for (std::int32_t k = units.last(); k > units.root(); --k) {
    const LevelUnits& level = units.level(k);
    std::vector<std::uint64_t>& births = births_[at(k - units.root() - 1)];
    for (std::uint64_t& key : births) {
      const std::int32_t unit = unitOf(key);
      const UnitBatch& batch = level.batchOf(unit);
      key = keyOf(k, batch, unit);
      for (const std::int32_t point : level.sources(batch, unit)) touchPoint(k - 1, point);
    }
    std::ranges::sort(births);
  }
}

void TileAssembler::touch(std::int32_t chain, std::int32_t level) {
  Held& held = held_[at(chain)];
  if (held.tile == tile_) {
    held.last = std::max(held.last, level);
    return;
  }
  held.tile = tile_;
  held.last = level;
  held.rings = false;
  const std::int32_t k = plan_.units.birth(chain);
  births_[at(k - plan_.units.root() - 1)].push_back(
      static_cast<std::uint64_t>(chain - plan_.units.level(k).firstChain));
}

void TileAssembler::touchPoint(std::int32_t k, std::int32_t point) {
  if (k == plan_.units.root()) return import(point);
  const std::int32_t shared = plan_.sharing.sharedPoint(k, point);
  if (shared >= 0) return import(plan_.units.rootPoints() + shared);
  touch(plan_.units.level(k).pointChain[at(point)], k);
}

void TileAssembler::import(std::int32_t point) {
  Import& imported = imported_[at(point)];
  if (imported.tile == tile_) return;
  imported.tile = tile_;
  imports_.push_back(point);
}

void TileAssembler::addImports(TileParts& parts) {
  std::ranges::sort(imports_);
  for (std::size_t i = 0; i < imports_.size(); ++i) imported_[at(imports_[i])].number = static_cast<std::int32_t>(i);
  parts.imports.insert(parts.imports.end(), imports_.begin(), imports_.end());
  pointCount_ = static_cast<std::int32_t>(imports_.size());
}

void TileAssembler::addStep(std::int32_t k, std::span<const std::uint64_t> keys, TileParts& parts) {
  const LevelUnits& level = plan_.units.level(k);
  const UnitBatch& batch = level.batchOf(unitOf(keys.front()));
  TileStep step;
  step.kind = batch.kind == UnitBatch::Kind::circulant ? TileStep::Kind::circulant
              : batch.kind == UnitBatch::Kind::dense   ? TileStep::Kind::dense
                                                       : TileStep::Kind::loose;
  step.level = static_cast<std::uint8_t>(k);
  if (step.kind == TileStep::Kind::circulant) step.form = level.table->circulants[at(batch.batch)].form;
  step.width = batch.width;
  step.count = static_cast<std::int32_t>(keys.size());
  step.firstIndex = static_cast<std::int32_t>(parts.indices.size());
  step.firstStage = static_cast<std::int32_t>(parts.stages.size());
  step.firstRow = static_cast<std::int32_t>(parts.rows.size());
  const auto number = static_cast<std::int32_t>(parts.steps.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    Held& held = held_[at(level.firstChain + unitOf(keys[i]))];
    held.step = number;
    held.place = static_cast<std::int32_t>(i);
  }
  step.pairs = pairsOf(keys.front());
  addIndices(k, batch, keys, parts);
  if (step.kind == TileStep::Kind::loose) {
    const LooseRows& loose = level.table->loose;
    for (const std::uint64_t key : keys) {
      const std::size_t row = at(unitOf(key) - batch.firstUnit);
      parts.rows.push_back(
          {plan_.firstWeight(k) + loose.firstWeight + loose.offsets[row], loose.offsets[row + 1] - loose.offsets[row]});
    }
  }
  addStages(k, batch, keys, ownedOf(keys.front()), step, parts);
  parts.steps.push_back(step);
}

/// Do the corners of a face stand as TileCorners::pairs tells?
bool TileAssembler::isPaired(std::int32_t k, const UnitBatch& batch, std::int32_t unit) const {
  if (plan_.places != TilePlaces::fours || batch.kind != UnitBatch::Kind::circulant || batch.width % 2 != 0 ||
      k == plan_.units.root() + 1)
    return false;
  const LevelUnits& before = plan_.units.level(k - 1);
  const std::span<const std::int32_t> corners = plan_.units.level(k).sources(batch, unit);
  for (std::size_t i = 0; i < corners.size(); i += 2) {
    const std::int32_t second = corners[i];
    const std::int32_t first = corners[i + 1];
    if (before.pointChain[at(first)] != before.pointChain[at(second)]) return false;
    // The points of a face follow each other: the one before its first is its last.
    const bool wraps = before.pointPlace[at(second)] == 0;
    const std::int32_t after = first + 1;
    const bool last = after == before.table->targetCount || before.pointPlace[at(after)] == 0;
    if (wraps ? first <= second || !last : after != second) return false;
    if (plan_.sharing.sharedPoint(k - 1, first) >= 0 || plan_.sharing.sharedPoint(k - 1, second) >= 0) return false;
  }
  return true;
}

void TileAssembler::addIndices(std::int32_t k, const UnitBatch& batch, std::span<const std::uint64_t> keys,
                               TileParts& parts) const {
  const LevelUnits& level = plan_.units.level(k);
  for (const std::uint64_t key : keys) {
    const std::span<const std::int32_t> points = level.sources(batch, unitOf(key));
    if (!pairsOf(key)) {
      for (const std::int32_t point : points) parts.indices.push_back(ownNumber(k - 1, point, parts));
      continue;
    }
    for (std::size_t i = 0; i < points.size(); i += 2) {
      parts.indices.push_back(static_cast<TilePoint>(ownNumber(k - 1, points[i], parts) - tilePoint(kTileFours)));
    }
  }
}

TilePoint TileAssembler::ownNumber(std::int32_t k, std::int32_t point, const TileParts& parts) const {
  const TileUnits& units = plan_.units;
  if (k == units.root()) return tilePoint(imported_[at(point)].number);
  const std::int32_t shared = plan_.sharing.sharedPoint(k, point);
  if (shared >= 0) return tilePoint(imported_[at(units.rootPoints() + shared)].number);
  const LevelUnits& level = units.level(k);
  const Held& held = held_[at(level.pointChain[at(point)])];
  const TileStep& step = parts.steps[at(held.step)];
  const std::int32_t first = parts.stages[at(step.firstStage + k - step.level)].firstPoint;
  const FacePlaces places = placesOfFace(step.placesIn(plan_.places), held.place, step.pointsEach());
  return tilePoint(first + places.first + places.step * level.pointPlace[at(point)]);
}

std::int32_t TileAssembler::weightOf(std::int32_t k, const UnitBatch& batch) const {
  const LevelTable& table = *plan_.units.level(k).table;
  if (batch.kind == UnitBatch::Kind::loose) return 0;
  const std::int32_t first = batch.kind == UnitBatch::Kind::circulant ? table.circulants[at(batch.batch)].firstForm
                                                                      : table.dense[at(batch.batch)].firstWeight;
  return plan_.firstWeight(k) + first;
}

void TileAssembler::addStages(std::int32_t k, const UnitBatch& batch, std::span<const std::uint64_t> keys, bool owned,
                              TileStep& step, TileParts& parts) {
  const TileUnits& units = plan_.units;
  const std::int32_t last = lastOf(keys.front());
  step.stageCount = static_cast<std::uint8_t>(last - k + 1);
  if (plan_.normals) parts.normals.firstFace.push_back(-1);
  std::vector<std::int32_t> alive(keys.size());
  std::ranges::transform(keys, alive.begin(), unitOf);
  const UnitBatch* here = &batch;
  for (std::int32_t j = k; j <= last; ++j) {
    const LevelUnits& level = units.level(j);
    TileStage stage;
    stage.firstWeight = weightOf(j, *here);
    if (units.read(j)) {
      // Fours begin on a cache line.
      if (plan_.places == TilePlaces::fours) pointCount_ = (pointCount_ + kTileFours - 1) / kTileFours * kTileFours;
      stage.firstPoint = pointCount_;
      pointCount_ += static_cast<std::int32_t>(roomOfFaces(step.placesIn(plan_.places), step.count, step.pointsEach()));
    }
    if (owned && j <= units.wanted()) addOutputs(j, *here, alive, stage, parts);
    parts.stages.push_back(stage);
    if (j == units.last() && plan_.normals) {
      parts.normals.firstFace.back() = owned ? static_cast<std::int32_t>(parts.normals.faces.size()) : -1;
      if (owned) addNormalFaces(*here, alive, parts);
    }
    if (j == last) break;
    for (std::int32_t& unit : alive) unit = level.child[at(unit)];
    here = &units.level(j + 1).batches[at(here->successor)];
  }
}

void TileAssembler::addOutputs(std::int32_t k, const UnitBatch& batch, std::span<const std::int32_t> units,
                               TileStage& stage, TileParts& parts) {
  const LevelUnits& level = plan_.units.level(k);
  if (plan_.order == TileOrder::tiles) {
    if (k < plan_.units.wanted()) return;
    stage.firstOutput = static_cast<std::int32_t>(parts.written.size());
    for (const std::int32_t unit : units) {
      const std::int32_t first = level.firstOutput(batch, unit);
      for (std::int32_t i = 0; i < batch.outputs; ++i) parts.written.push_back(first + i);
    }
    return;
  }
  stage.firstOutput = static_cast<std::int32_t>(parts.outputs.size());
  for (const std::int32_t unit : units) parts.outputs.push_back(level.firstOutput(batch, unit));
  // Where a closed mesh is refined a face's points have the same numbers at every level: kept once.
  const std::size_t count = units.size();
  const auto own = parts.outputs.end() - static_cast<std::ptrdiff_t>(count);
  if (parts.stages.empty() || parts.stages.back().firstOutput < 0) return;
  const auto before = parts.outputs.begin() + parts.stages.back().firstOutput;
  if (before + static_cast<std::ptrdiff_t>(count) != own || !std::equal(own, parts.outputs.end(), before)) return;
  parts.outputs.resize(parts.outputs.size() - count);
  stage.firstOutput = parts.stages.back().firstOutput;
}

}  // namespace honeycomb::Far
