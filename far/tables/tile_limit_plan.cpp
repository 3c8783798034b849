#include "far/tables/tile_limit_plan.h"

#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

TileLimitPlan::TileLimitPlan(const LimitTable& limits, const TileUnits& units,
                             const std::vector<std::vector<std::int32_t>>& large)
    : limits_(limits), root_(units.root()), wanted_(units.wanted()), last_(units.last()) {
  const LevelUnits& wanted = units.level(wanted_);
  rows_.assign(at(wanted.table->targetCount), -1);
  shared_.assign(rows_.size(), 0);
  std::int64_t first = 0;
  for (const LimitRows* rows : {&limits.vertices, &limits.verticesHere}) {
    Parallel::forEach(0, std::ssize(rows->elements),
                      [&](std::int64_t i) { rows_[at(rows->elements[at(i)])] = static_cast<std::int32_t>(first + i); });
    for (const FrameBatch& frames : rows->batches) {
      if (frames.sides <= kMostTileEntries) continue;
      for (std::int32_t g = 0; g < frames.count; ++g) shared_[at(rows->elements[at(frames.firstElement + g)])] = 1;
    }
    first += std::ssize(rows->elements);
    for (const FrameBatch& frames : rows->batches) {
      const auto spans = std::span(rows->weights).subspan(at(frames.firstWeight + frames.sides));
      hexagons_.push_back(frames.sides == 6 && std::equal(kHexagonSpan.begin(), kHexagonSpan.end(), spans.begin()));
    }
  }
  for (const std::int32_t unit : large[at(wanted_ - root_ - 1)]) {
    const UnitBatch& faces = wanted.batchOf(unit);
    std::fill_n(shared_.begin() + wanted.firstOutput(faces, unit), faces.outputs, std::uint8_t{1});
  }
}

const FrameBatch& TileLimitPlan::batch(std::int32_t shape) const {
  return shape < childShapes() ? limits_.vertices.batches[at(shape)]
                               : limits_.verticesHere.batches[at(shape - childShapes())];
}

TileLimitPlan::Place TileLimitPlan::placeOf(std::int32_t point) const {
  std::int32_t row = rows_[at(point)];
  if (row < 0) return {};
  const auto ofChildren = static_cast<std::int32_t>(limits_.vertices.elements.size());
  const bool here = row >= ofChildren;
  if (here) row -= ofChildren;
  const LimitRows& rows = here ? limits_.verticesHere : limits_.vertices;
  const auto behind = std::ranges::upper_bound(rows.batches, row, {}, &FrameBatch::firstElement);
  const FrameBatch& frames = *(behind - 1);
  const auto shape = static_cast<std::int32_t>(behind - rows.batches.begin()) - 1;
  return {here ? childShapes() + shape : shape, here ? wanted_ : last_,
          std::span(rows.indices)
              .subspan(at(frames.firstIndex) + at(row - frames.firstElement) * at(frames.sides), at(frames.sides))};
}

std::int32_t TileLimitPlan::sidesOf(std::int32_t shape) const {
  return shape == kNoVertex ? 0 : batch(shape).sides;
}

std::int32_t TileLimitPlan::firstWeight(std::int32_t shape) const {
  if (shape == kNoVertex) return 0;
  const auto before = shape < childShapes() ? 0 : static_cast<std::int32_t>(limits_.vertices.weights.size());
  return before + batch(shape).firstWeight;
}

/// Calls visit(point, its place) for those that are shared.
template <class Visit>
void TileLimitPlan::forShared(const Visit& visit) const {
  for (std::size_t point = 0; point < shared_.size(); ++point) {
    if (shared_[point] != 0) visit(static_cast<std::int32_t>(point), placeOf(static_cast<std::int32_t>(point)));
  }
}

std::vector<std::vector<std::int32_t>> TileLimitPlan::sharedPoints() const {
  std::vector<std::vector<std::int32_t>> points(at(last_ - root_));
  forShared([&](std::int32_t, const Place& place) {
    if (place.points.empty()) return;
    auto& here = points[at(place.level - root_ - 1)];
    here.insert(here.end(), place.points.begin(), place.points.end());
  });
  return points;
}

void TileLimitPlan::share(const TileSharing& sharing) {
  std::int32_t shape = kNoVertex - 1;
  forShared([&](std::int32_t point, const Place& place) {
    if (place.shape != shape) {
      shape = place.shape;
      sharedRows_.batches.push_back({sidesOf(shape), 0, static_cast<std::int32_t>(sharedRows_.indices.size()),
                                     static_cast<std::int32_t>(sharedRows_.elements.size()), firstWeight(shape)});
    }
    ++sharedRows_.batches.back().count;
    sharedRows_.elements.push_back(point);
    for (const std::int32_t p : place.points) sharedRows_.indices.push_back(sharing.setPoint(place.level, p));
  });
}

void TileLimitPlan::moveTo(TileLimits& limits) && {
  for (const LimitRows* rows : {&limits_.vertices, &limits_.verticesHere}) {
    limits.weights.append(rows->weights.begin(), rows->weights.end());
    limits.weightsSingle.append(rows->weightsSingle.begin(), rows->weightsSingle.end());
  }
  sharedRows_.weights = limits.weights;
  sharedRows_.weightsSingle = limits.weightsSingle;
  limits.shared = std::move(sharedRows_);
}

}  // namespace honeycomb::Far
