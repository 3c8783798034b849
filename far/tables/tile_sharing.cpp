#include "far/tables/tile_sharing.h"

#include <algorithm>
#include <utility>

#include "far/base/index.h"

namespace honeycomb::Far {

std::vector<std::vector<std::int32_t>> largeUnits(const TileUnits& units) {
  std::vector<std::vector<std::int32_t>> large;
  for (std::int32_t k = units.root() + 1; k <= units.last(); ++k) {
    const LevelUnits& level = units.level(k);
    std::vector<std::int32_t>& here = large.emplace_back();
    for (const UnitBatch& batch : level.batches) {
      if (batch.kind != UnitBatch::Kind::projected && batch.kind != UnitBatch::Kind::loose) continue;
      for (std::int32_t u = batch.firstUnit; u < batch.firstUnit + batch.count; ++u) {
        if (level.tooLarge(batch, u)) here.push_back(u);
      }
    }
  }
  return large;
}

TileSharing::TileSharing(const TileUnits& units, const std::vector<std::vector<std::int32_t>>& large,
                         const std::vector<std::vector<std::int32_t>>& wanted)
    : units_(units) {
  const auto none = [](const auto& level) { return level.empty(); };
  if (std::ranges::all_of(large, none) && std::ranges::all_of(wanted, none)) return;
  std::vector<Units> needed = large;
  for (std::int32_t k = units.last() - 1; k > units.root(); --k) {
    const std::size_t i = at(k - units.root() - 1);
    Units& here = needed[i];
    std::vector<std::int32_t> points = sources(k + 1, needed[i + 1]);
    if (!wanted.empty()) points.insert(points.end(), wanted[i].begin(), wanted[i].end());
    const Units made = makers(k, points);
    here.insert(here.end(), made.begin(), made.end());
    std::ranges::sort(here);
    here.erase(std::unique(here.begin(), here.end()), here.end());
  }
  for (std::int32_t k = units.root() + 1; k <= units.last(); ++k) {
    addSet(k, needed[at(k - units.root() - 1)], large[at(k - units.root() - 1)]);
  }
}

/// The units of level k that make some of its points.
TileSharing::Units TileSharing::makers(std::int32_t k, const std::vector<std::int32_t>& points) const {
  if (points.empty()) return {};
  const LevelUnits& level = units_.level(k);
  std::vector<std::int32_t> makerOf(at(level.table->targetCount));
  for (const UnitBatch& batch : level.batches) {
    for (std::int32_t u = batch.firstUnit; u < batch.firstUnit + batch.count; ++u) {
      const std::int32_t first = level.firstOutput(batch, u);
      std::fill_n(makerOf.begin() + first, batch.outputs, u);
    }
  }
  Units made;
  for (const std::int32_t point : points) made.push_back(makerOf[at(point)]);
  return made;
}

std::vector<std::int32_t> TileSharing::sources(std::int32_t k, const Units& units) const {
  const LevelUnits& level = units_.level(k);
  std::vector<std::int32_t> points;
  for (const std::int32_t unit : units) {
    const auto read = level.sources(level.batchOf(unit), unit);
    points.insert(points.end(), read.begin(), read.end());
  }
  return points;
}

void TileSharing::addSet(std::int32_t k, const Units& units, const Units& large) {
  const LevelUnits& level = units_.level(k);
  SharedPoints set;
  set.firstPoint = pointCount_;
  addTable(k, units, set.table);
  std::vector<std::int32_t> numberOf(at(level.table->targetCount), -1);
  std::vector<std::int32_t> imported(large.empty() ? 0 : numberOf.size(), -1);
  std::int32_t number = 0;
  for (const std::int32_t unit : units) {
    const UnitBatch& batch = level.batchOf(unit);
    const std::int32_t first = level.firstOutput(batch, unit);
    const bool isLarge = std::ranges::binary_search(large, unit);
    if (isLarge) set.written.push_back({number, first, batch.outputs});
    for (std::int32_t i = 0; i < batch.outputs; ++i, ++number) {
      numberOf[at(first + i)] = pointCount_ + number;
      if (isLarge) imported[at(first + i)] = pointCount_ + number;
    }
  }
  pointCount_ += number;
  setNumbers_.push_back(std::move(numberOf));
  numbers_.push_back(std::move(imported));
  sets_.push_back(std::move(set));
}

/// The rows of some units, ascending, their outputs numbered one after the other. Weights stay where they are.
void TileSharing::addTable(std::int32_t k, const Units& units, LevelTable& table) const {
  const LevelUnits& level = units_.level(k);
  const bool fromRoot = k == units_.root() + 1;
  const auto place = [&](std::int32_t point) {
    return fromRoot ? point : setPoint(k - 1, point) - sets_.back().firstPoint;
  };
  table.sourceCount = fromRoot ? units_.rootPoints() : sets_.back().table.targetCount;
  table.weights = level.table->weights;
  table.weightsSingle = level.table->weightsSingle;
  const auto addSources = [&](const UnitBatch& batch, std::int32_t unit) {
    for (const std::int32_t point : level.sources(batch, unit)) table.indices.push_back(place(point));
  };
  std::int32_t output = 0;
  const UnitBatch* last = nullptr;
  const auto addUnit = [&](const UnitBatch& batch, std::int32_t unit) {
    const bool opens = last != &batch;
    const auto firstIndex = static_cast<std::int32_t>(table.indices.size());
    switch (batch.kind) {
      case UnitBatch::Kind::circulant: {
        if (opens) {
          CirculantBatch faces = level.table->circulants[at(batch.batch)];
          faces.faceCount = 0;
          faces.firstIndex = firstIndex;
          faces.firstOutput = output;
          table.circulants.push_back(faces);
        }
        ++table.circulants.back().faceCount;
        break;
      }
      case UnitBatch::Kind::dense: {
        if (opens) {
          DenseRows rows = level.table->dense[at(batch.batch)];
          rows.rowCount = 0;
          rows.firstIndex = firstIndex;
          rows.firstOutput = output;
          table.dense.push_back(rows);
        }
        ++table.dense.back().rowCount;
        break;
      }
      case UnitBatch::Kind::projected: {
        ProjectedFace face = level.table->projected[at(batch.batch)];
        face.firstIndex = firstIndex;
        face.firstOutput = output;
        table.projected.push_back(face);
        break;
      }
      case UnitBatch::Kind::loose:
        break;
    }
    addSources(batch, unit);
    output += batch.outputs;
    last = &batch;
  };
  for (const std::int32_t unit : units) {
    const UnitBatch& batch = level.batchOf(unit);
    if (batch.kind != UnitBatch::Kind::loose) addUnit(batch, unit);
  }
  // Loose rows are the last units of a level.
  const LooseRows& loose = level.table->loose;
  table.loose.firstIndex = static_cast<std::int32_t>(table.indices.size());
  std::vector<std::int32_t> rows;
  for (const std::int32_t unit : units) {
    const UnitBatch& batch = level.batchOf(unit);
    if (batch.kind == UnitBatch::Kind::loose) rows.push_back(unit - batch.firstUnit);
  }
  // A loose row's weights stand at the place of its indices, so both are laid out anew.
  table.loose.firstWeight = static_cast<std::int32_t>(table.weights.size());
  for (const std::int32_t row : rows) {
    for (std::int32_t b = loose.offsets[at(row)]; b < loose.offsets[at(row) + 1]; ++b) {
      table.indices.push_back(place(level.table->indices[at(loose.firstIndex + b)]));
      table.weights.push_back(level.table->weights[at(loose.firstWeight + b)]);
      table.weightsSingle.push_back(level.table->weightsSingle[at(loose.firstWeight + b)]);
    }
    table.loose.outputs.push_back(output++);
    table.loose.offsets.push_back(static_cast<std::int32_t>(table.indices.size()) - table.loose.firstIndex);
  }
  table.targetCount = output;
}

}  // namespace honeycomb::Far
