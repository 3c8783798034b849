#include <algorithm>

#include "far/base/index.h"
#include "far/tables/tile_assembler.h"

namespace honeycomb::Far {

namespace {

constexpr std::int32_t kUnnumbered = -1;

}  // namespace

/// The normals that the tile's own points of the last level take, and the corners these are found from.
void TileAssembler::collectNormals() {
  normals_.clear();
  const LevelUnits& wanted = plan_.units.level(plan_.units.wanted());
  forOwnedUnits([&](std::int32_t, const UnitBatch& batch, std::int32_t unit) {
    const std::int32_t first = wanted.firstOutput(batch, unit);
    for (std::int32_t point = first; point < first + batch.outputs; ++point) {
      plan_.normals->rule().visit(point, [&](std::int32_t normal) { touchNormal(normal); });
    }
  });
}

void TileAssembler::touchNormal(std::int32_t normal) {
  Import& held = normalsHeld_[at(normal)];
  if (held.tile == tile_) return;
  held.tile = tile_;
  normals_.push_back(normal);
  if (plan_.normals->shared(normal) >= 0) return;
  const TileNormalPlan::Place place = plan_.normals->placeOf(normal);
  for (const std::int32_t corner : place.corners) touchPoint(place.level, corner);
}

void TileAssembler::numberNormals(TileParts& parts) {
  const TileNormalPlan& plan = *plan_.normals;
  std::int32_t next = 0;
  for (const std::int32_t normal : normals_) normalsHeld_[at(normal)].number = kUnnumbered;
  const std::size_t firstBorn = parts.normals.born.size();
  for (std::int32_t k = plan_.units.root() + 1; k <= plan_.units.last(); ++k) {
    forSteps(k, [&](std::span<const std::uint64_t> keys) {
      parts.normals.born.push_back(numberBorn(k, keys, next));
      if (parts.normals.born.back().firstNormal >= 0) next += static_cast<std::int32_t>(keys.size());
    });
  }
  const auto bornEnd = std::partition(normals_.begin(), normals_.end(), [&](std::int32_t normal) {
    return normalsHeld_[at(normal)].number == kUnnumbered;
  });
  // Behind the others.
  const auto others = static_cast<std::int32_t>(bornEnd - normals_.begin());
  for (auto born = bornEnd; born != normals_.end(); ++born) normalsHeld_[at(*born)].number += others;
  for (TileBorn& born : std::span(parts.normals.born).subspan(firstBorn)) {
    if (born.firstNormal >= 0) born.firstNormal += others;
  }
  TileNormalRange range;
  range.normalCount = static_cast<std::int32_t>(normals_.size());
  normals_.erase(bornEnd, normals_.end());
  std::ranges::sort(normals_);
  const auto own = std::stable_partition(normals_.begin(), normals_.end(),
                                         [&](std::int32_t normal) { return plan.shared(normal) >= 0; });
  range.firstImport = static_cast<std::int32_t>(parts.normals.imports.size());
  range.importCount = static_cast<std::int32_t>(own - normals_.begin());
  parts.largestTile = std::max(parts.largestTile, range.normalCount);
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    normalsHeld_[at(normals_[i])].number = static_cast<std::int32_t>(i);
    if (i < at(range.importCount)) parts.normals.imports.push_back(plan.shared(normals_[i]));
  }
  parts.normals.tiles.push_back(range);
}

/// Numbers the normals of the faces of a step from `firstNormal` on, where these are found from what the step reads.
TileBorn TileAssembler::numberBorn(std::int32_t k, std::span<const std::uint64_t> keys, std::int32_t firstNormal) {
  const TileUnits& units = plan_.units;
  const UnitBatch& batch = units.level(k).batchOf(unitOf(keys.front()));
  if (batch.kind != UnitBatch::Kind::circulant || !ownedOf(keys.front()) || lastOf(keys.front()) < units.last()) {
    return {};
  }
  born_.clear();
  for (const std::uint64_t key : keys) {
    const std::int32_t normal = bornNormal(k, batch, unitOf(key));
    if (normal < 0) return {};
    born_.push_back(normal);
  }
  const std::int32_t frames = plan_.normals->placeOf(born_.front()).batch;
  for (const std::int32_t normal : born_) {
    if (plan_.normals->placeOf(normal).batch != frames) return {};
  }
  std::int32_t next = firstNormal;
  for (const std::int32_t normal : born_) normalsHeld_[at(normal)].number = next++;
  return {firstNormal, plan_.normals->firstWeight(k - 1) + plan_.normals->batchAt(k - 1, frames).firstWeight};
}

/// The normal of the face that a unit of level k is born from, -1 if it is found from other points than the unit reads.
std::int32_t TileAssembler::bornNormal(std::int32_t k, const UnitBatch& batch, std::int32_t unit) const {
  const TileUnits& units = plan_.units;
  const TileNormalPlan& plan = *plan_.normals;
  const LevelUnits& last = units.level(units.last());
  const std::int32_t end = units.unitAt(units.level(k).firstChain + unit, units.last());
  // A corner point names its own face's normal first.
  std::int32_t own = -1;
  plan.rule().visit(last.firstOutput(last.batchOf(end), end), [&](std::int32_t normal) {
    if (own < 0) own = normal;
  });
  if (own < 0 || plan.shared(own) >= 0) return -1;
  const TileNormalPlan::Place place = plan.placeOf(own);
  const bool same = place.level == k - 1 && std::ranges::equal(place.corners, units.level(k).sources(batch, unit));
  return same ? own : -1;
}

void TileAssembler::addNormalFaces(const UnitBatch& batch, std::span<const std::int32_t> units,
                                   TileParts& parts) const {
  const LevelUnits& last = plan_.units.level(plan_.units.last());
  const NormalRule& rule = plan_.normals->rule();
  Array<TilePoint>& faces = parts.normals.faces;
  const auto add = [&](std::int32_t normal) { faces.push_back(tilePoint(normalsHeld_[at(normal)].number)); };
  for (const std::int32_t unit : units) {
    const std::int32_t first = last.firstOutput(batch, unit);
    if (batch.kind == UnitBatch::Kind::circulant) {
      // Each corner point sums its face's normal twice, then those of the neighbours.
      for (std::int32_t i = 0; i < batch.outputs; ++i) {
        std::int32_t place = 0;
        rule.visit(first + i, [&](std::int32_t normal) {
          if ((i == 0 && place == 0) || place > 1) add(normal);
          ++place;
        });
      }
      continue;
    }
    const std::size_t count = faces.size();
    faces.push_back(0);
    rule.visit(first, add);
    faces[count] = static_cast<TilePoint>(faces.size() - count - 1);
  }
}

void TileAssembler::addFrames(TileParts& parts) const {
  const TileNormalPlan& plan = *plan_.normals;
  TileNormals& normals = parts.normals;
  TileNormalRange& range = normals.tiles.back();
  range.firstFrames = static_cast<std::int32_t>(normals.frames.size());
  std::int32_t level = -1;
  std::int32_t batch = -1;
  for (std::size_t i = at(range.importCount); i < normals_.size(); ++i) {
    const TileNormalPlan::Place place = plan.placeOf(normals_[i]);
    if (place.level != level || place.batch != batch) {
      level = place.level;
      batch = place.batch;
      const FrameBatch& frames = plan.batchAt(level, batch);
      normals.frames.push_back({frames.sides, 0, static_cast<std::int32_t>(normals.indices.size()),
                                plan.firstWeight(level) + frames.firstWeight});
    }
    ++normals.frames.back().count;
    for (const std::int32_t corner : place.corners) normals.indices.push_back(ownNumber(level, corner, parts));
  }
  range.framesCount = static_cast<std::int32_t>(normals.frames.size()) - range.firstFrames;
}

}  // namespace honeycomb::Far
