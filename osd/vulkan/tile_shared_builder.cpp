#include <span>
#include <vector>

#include "far/base/index.h"
#include "osd/vulkan/table_builder.h"

namespace honeycomb::Osd {

namespace {

/// Copies runs of points: rows of one entry that weighs 1.
Far::LevelTable copies(std::span<const Far::SharedPoints::Run> runs, std::int32_t sourceCount,
                       std::int32_t targetCount) {
  Far::LevelTable table;
  table.sourceCount = sourceCount;
  table.targetCount = targetCount;
  table.weights = {1};
  table.weightsSingle = {1};
  Array<std::int32_t> indices;
  for (const Far::SharedPoints::Run& run : runs) {
    table.dense.push_back({1, run.count, static_cast<std::int32_t>(indices.size()), run.output, 0});
    for (std::int32_t i = 0; i < run.count; ++i) indices.push_back(run.point + i);
  }
  table.indices = std::move(indices);
  return table;
}

}  // namespace

// The root level; the wanted one where that is no later. Normals of faces born on the way are found from the points
// before these make room for others.
Result<TableBuilder::Place> TableBuilder::addRoot(Far::LevelTables levels, const Far::TileTable& tiles) {
  const std::int32_t level = state_.options.lastLevel;
  Place place = placeOf(PointBuffer::control, tiles.pointCount.front());
  for (std::int32_t k = 0; k <= std::min(level, tiles.rootLevel); ++k) {
    if (k > 0) {
      const Far::LevelTable& table = levels.table(k);
      const PointBuffer target = k == level ? PointBuffer::refined : scratchOf(at(k));
      auto steps = this->level(table, place.points, target);
      if (!steps) return tl::unexpected(steps.error());
      append(*steps);
      state_.levelEnds.push_back(state_.phases.size());
      place = placeOf(target, table.targetCount);
    }
    if (normalKind_ != Far::TileNormalKind::fast) continue;
    if (const auto added = addSharedNormals(tiles, k, place); !added) return tl::unexpected(added.error());
  }
  return place;
}

// Set after set, each from the one before, with the points for the tiles, or those that no tile writes, copied.
Result<void> TableBuilder::addShared(const Far::TileTable& tiles, Place source) {
  if (tiles.shared.empty()) return {};
  const bool exact = normalKind_ == Far::TileNormalKind::exact;
  const std::int32_t last = state_.options.lastLevel + (exact ? 1 : 0);
  for (std::int32_t k = tiles.rootLevel + 1; k <= last; ++k) {
    const Far::SharedPoints& set = tiles.shared[at(k - tiles.rootLevel - 1)];
    const Place target = placeOf(k % 2 == 0 ? PointBuffer::setEven : PointBuffer::setOdd, set.table.targetCount);
    if (set.table.targetCount > 0) {
      auto steps = this->level(set.table, source, target);
      if (!steps) return tl::unexpected(steps.error());
      append(*steps);
      if (auto copied = copyShared(set, k, target); !copied) return copied;
    }
    source = target;
  }
  const Far::SharedPoints& end = tiles.shared.back();
  const Place points = placeOf(PointBuffer::sharedPoints, end.firstPoint + end.table.targetCount);
  if (exact) return addNormals(tiles.limits.shared, points, normalPlace());
  if (normalKind_ != Far::TileNormalKind::fast) return {};
  for (std::int32_t k = tiles.rootLevel + 1; k < tiles.lastLevel; ++k) {
    if (auto added = addSharedNormals(tiles, k, points); !added) return added;
  }
  return {};
}

// Points of level k: to the wanted level what no tile writes, and to all shared points what is read by others.
Result<void> TableBuilder::copyShared(const Far::SharedPoints& set, std::int32_t k, const Place& points) {
  const std::int32_t level = state_.options.lastLevel;
  if (k == level) {
    auto copied = copyRuns(set.written, points, placeOf(PointBuffer::refined, state_.refinedCount));
    if (!copied) return copied;
  }
  if (k == level && normalKind_ != Far::TileNormalKind::exact) return {};
  Place all = placeOf(PointBuffer::sharedPoints, points.layout.count);
  all.layout.desc.offset = set.firstPoint * state_.options.refined.length;
  const Far::SharedPoints::Run run{0, 0, static_cast<std::int32_t>(points.layout.count)};
  return copyRuns({&run, 1}, points, all);
}

Result<void> TableBuilder::copyRuns(std::span<const Far::SharedPoints::Run> runs, const Place& from, const Place& to) {
  if (runs.empty()) return {};
  const Far::LevelTable table =
      copies(runs, static_cast<std::int32_t>(from.layout.count), static_cast<std::int32_t>(to.layout.count));
  auto steps = level(table, from, to);
  if (!steps) return tl::unexpected(steps.error());
  append(*steps);
  return {};
}

// Of faces born at level k.
Result<void> TableBuilder::addSharedNormals(const Far::TileTable& tiles, std::int32_t k, const Place& points) {
  return addNormals(tiles.normals.shared[at(k)], points,
                    placeOf(PointBuffer::sharedNormals, tiles.normals.sharedCount));
}

Result<void> TableBuilder::addNormals(const Far::LimitRows& rows, const Place& points, const Place& normals) {
  auto steps = normalsOf(rows, points, normals);
  if (!steps) return tl::unexpected(steps.error());
  append(*steps);
  return {};
}

}  // namespace honeycomb::Osd
