#include <algorithm>

#include "far/base/index.h"
#include "far/tables/tile_assembler.h"

namespace honeycomb::Far {

/// The normals that the tile's own points of the last level take, and the corners these are found from.
void TileAssembler::collectNormals() {
  normals_.clear();
  forOwnedPoints([&](std::int32_t point) {
    plan_.normals->rule().visit(point, [&](std::int32_t normal) { touchNormal(normal); });
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
  std::ranges::sort(normals_);
  const auto own = std::stable_partition(normals_.begin(), normals_.end(),
                                         [&](std::int32_t normal) { return plan.shared(normal) >= 0; });
  TileNormalRange range;
  range.firstImport = static_cast<std::int32_t>(parts.normals.imports.size());
  range.importCount = static_cast<std::int32_t>(own - normals_.begin());
  range.normalCount = static_cast<std::int32_t>(normals_.size());
  parts.largestTile = std::max(parts.largestTile, range.normalCount);
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    normalsHeld_[at(normals_[i])].number = static_cast<std::int32_t>(i);
    if (i < at(range.importCount)) parts.normals.imports.push_back(plan.shared(normals_[i]));
  }
  parts.normals.tiles.push_back(range);
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
