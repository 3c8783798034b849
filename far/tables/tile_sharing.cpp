#include "far/tables/tile_sharing.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "far/base/index.h"

namespace honeycomb::Far {

namespace {

/// A small table of some units of a level, ascending, their outputs numbered one after the other.
class TableOfUnits {
 public:
  /// `place`: the number that a point of the level before has for the table.
  TableOfUnits(const LevelUnits& level, std::function<std::int32_t(std::int32_t)> place)
      : level_(level), place_(std::move(place)) {
    table_.weights = level.table->weights;
    table_.weightsSingle = level.table->weightsSingle;
  }

  LevelTable make(const std::vector<std::int32_t>& units) {
    // Loose rows are the last units of a level.
    const auto isLoose = [&](std::int32_t unit) { return level_.batchOf(unit).kind == UnitBatch::Kind::loose; };
    const auto loose = std::ranges::find_if(units, isLoose);
    std::for_each(units.begin(), loose, [&](std::int32_t unit) { addUnit(level_.batchOf(unit), unit); });
    table_.loose.firstIndex = static_cast<std::int32_t>(table_.indices.size());
    table_.loose.firstWeight = static_cast<std::int32_t>(table_.weights.size());
    std::for_each(loose, units.end(), [&](std::int32_t unit) { addLoose(unit - level_.batchOf(unit).firstUnit); });
    table_.targetCount = outputs_;
    return std::move(table_);
  }

 private:
  /// One unit more of a batch like `like`, which is opened for the first.
  template <class Batch>
  void extend(const UnitBatch& batch, std::vector<Batch>& batches, Batch like, std::int32_t Batch::*count) {
    if (last_ != &batch) {
      like.*count = 0;
      like.firstIndex = static_cast<std::int32_t>(table_.indices.size());
      like.firstOutput = outputs_;
      batches.push_back(like);
    }
    ++(batches.back().*count);
  }

  void addUnit(const UnitBatch& batch, std::int32_t unit) {
    const LevelTable& from = *level_.table;
    if (batch.kind == UnitBatch::Kind::circulant) {
      extend(batch, table_.circulants, from.circulants[at(batch.batch)], &CirculantBatch::faceCount);
    } else if (batch.kind == UnitBatch::Kind::dense) {
      extend(batch, table_.dense, from.dense[at(batch.batch)], &DenseRows::rowCount);
    } else if (batch.kind == UnitBatch::Kind::summed) {
      if (last_ != &batch) startSummed();
      table_.summed.rows.outputs[at(unit - batch.firstUnit)] = outputs_;
    } else {
      ProjectedFace face = from.projected[at(batch.batch)];
      face.firstIndex = static_cast<std::int32_t>(table_.indices.size());
      face.firstOutput = outputs_;
      table_.projected.push_back(face);
    }
    for (const std::int32_t point : level_.sources(batch, unit)) table_.indices.edit().push_back(place_(point));
    outputs_ += batch.outputs;
    last_ = &batch;
  }

  /// Summed rows and the large faces whose sums they read are in a table all together: no tile makes any.
  void startSummed() {
    table_.summed = level_.table->summed;
    table_.summed.rows.firstIndex = static_cast<std::int32_t>(table_.indices.size());
  }

  /// A loose row's weights stand at the place of its indices, so both are laid out anew.
  void addLoose(std::int32_t row) {
    const LevelTable& from = *level_.table;
    for (std::int32_t b = from.loose.offsets[at(row)]; b < from.loose.offsets[at(row) + 1]; ++b) {
      table_.indices.edit().push_back(place_(from.indices[at(from.loose.firstIndex + b)]));
      table_.weights.push_back(from.weights[at(from.loose.firstWeight + b)]);
      table_.weightsSingle.push_back(from.weightsSingle[at(from.loose.firstWeight + b)]);
    }
    table_.loose.outputs.push_back(outputs_++);
    table_.loose.offsets.push_back(static_cast<std::int32_t>(table_.indices.size()) - table_.loose.firstIndex);
  }

  const LevelUnits& level_;
  std::function<std::int32_t(std::int32_t)> place_;
  LevelTable table_;
  std::int32_t outputs_ = 0;
  const UnitBatch* last_ = nullptr;
};

}  // namespace

std::vector<std::vector<std::int32_t>> largeUnits(const TileUnits& units) {
  std::vector<std::vector<std::int32_t>> large;
  for (std::int32_t k = units.root() + 1; k <= units.last(); ++k) {
    const LevelUnits& level = units.level(k);
    std::vector<std::int32_t>& here = large.emplace_back();
    for (const UnitBatch& batch : level.batches) {
      if (batch.kind == UnitBatch::Kind::circulant || batch.kind == UnitBatch::Kind::dense) continue;
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
  for (std::int32_t k = units.last(); k > units.root(); --k) {
    const std::size_t i = at(k - units.root() - 1);
    Units& here = needed[i];
    std::vector<std::int32_t> points;
    if (k < units.last()) points = sources(k + 1, needed[i + 1]);
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
  const bool fromRoot = k == units_.root() + 1;
  const auto place = [&](std::int32_t point) {
    return fromRoot ? point : setPoint(k - 1, point) - sets_.back().firstPoint;
  };
  SharedPoints set;
  set.firstPoint = pointCount_;
  if (!units.empty()) set.table = TableOfUnits(level, place).make(units);
  set.table.sourceCount = fromRoot ? units_.rootPoints() : sets_.back().table.targetCount;
  std::vector<std::int32_t> numberOf(at(level.table->targetCount), -1);
  std::vector<std::int32_t> imported(large.empty() ? 0 : numberOf.size(), -1);
  std::int32_t number = 0;
  for (const std::int32_t unit : units) {
    const UnitBatch& batch = level.batchOf(unit);
    const std::int32_t first = level.firstOutput(batch, unit);
    const bool isLarge = std::ranges::binary_search(large, unit);
    if (isLarge && k <= units_.wanted()) set.written.push_back({number, first, batch.outputs});
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

}  // namespace honeycomb::Far
