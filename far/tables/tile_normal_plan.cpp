#include "far/tables/tile_normal_plan.h"

#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

constexpr std::int32_t kToShare = 0;

}  // namespace

TileNormalPlan::TileNormalPlan(const Refinement& refinement, const TileUnits& units,
                               const std::vector<std::vector<std::int32_t>>& large)
    : root_(units.root()), last_(units.last()), rule_(refinement, units.last()) {
  rows_.resize(at(rule_.normalCount()), -1);
  shared_.assign(at(rule_.normalCount()), -1);
  std::int32_t weights = 0;
  for (std::int32_t k = 0; k < last_; ++k) {
    frames_.push_back(rule_.frames(k));
    firstWeights_.push_back(weights);
    weights += static_cast<std::int32_t>(frames_.back().weights.size());
    const Array<std::int32_t>& elements = frames_.back().elements;
    Parallel::forEach(0, std::ssize(elements),
                      [&](std::int64_t i) { rows_[at(elements[at(i)])] = static_cast<std::int32_t>(i); });
  }
  chooseShared(units, large.back());
}

/// Shared are the normals of faces born before the root, of faces too large for a tile, and those that the points of
/// what is too large take.
void TileNormalPlan::chooseShared(const TileUnits& units, const std::vector<std::int32_t>& large) {
  for (std::int32_t k = 0; k < last_; ++k) {
    for (const FrameBatch& batch : frames_[at(k)].batches) {
      if (k >= root_ && batch.sides <= kLargestCirculant) continue;
      for (std::int32_t g = 0; g < batch.count; ++g) {
        shared_[at(frames_[at(k)].elements[at(batch.firstElement + g)])] = kToShare;
      }
    }
  }
  const LevelUnits& last = units.level(last_);
  offsets_.push_back(0);
  for (const std::int32_t unit : large) {
    const UnitBatch& batch = last.batchOf(unit);
    const std::int32_t first = last.firstOutput(batch, unit);
    for (std::int32_t i = 0; i < batch.outputs; ++i) {
      rule_.visit(first + i, [&](std::int32_t normal) {
        sums_.push_back(normal);
        shared_[at(normal)] = kToShare;
      });
      offsets_.push_back(static_cast<std::int32_t>(sums_.size()));
    }
  }
}

std::vector<std::vector<std::int32_t>> TileNormalPlan::sharedCorners() const {
  std::vector<std::vector<std::int32_t>> corners(at(last_ - root_));
  for (std::int32_t k = root_ + 1; k < last_; ++k) {
    const LimitRows& rows = frames_[at(k)];
    for (const FrameBatch& batch : rows.batches) {
      for (std::int32_t g = 0; g < batch.count; ++g) {
        if (shared_[at(rows.elements[at(batch.firstElement + g)])] < 0) continue;
        const auto first = rows.indices.begin() + batch.firstIndex + std::ptrdiff_t{g} * batch.sides;
        auto& here = corners[at(k - root_ - 1)];
        here.insert(here.end(), first, first + batch.sides);
      }
    }
  }
  return corners;
}

void TileNormalPlan::share(const TileSharing& sharing) {
  for (std::int32_t k = 0; k < last_; ++k) sharedRows_.push_back(sharedRows(k, sharing));
}

/// The rows of a level that are shared.
LimitRows TileNormalPlan::sharedRows(std::int32_t level, const TileSharing& sharing) {
  const LimitRows& all = frames_[at(level)];
  LimitRows rows;
  rows.weights = all.weights;
  rows.weightsSingle = all.weightsSingle;
  for (const FrameBatch& batch : all.batches) {
    FrameBatch some = batch;
    some.count = 0;
    some.firstElement = static_cast<std::int32_t>(rows.elements.size());
    some.firstIndex = static_cast<std::int32_t>(rows.indices.size());
    for (std::int32_t g = 0; g < batch.count; ++g) {
      std::int32_t& number = shared_[at(all.elements[at(batch.firstElement + g)])];
      if (number < 0) continue;
      number = sharedCount_++;
      ++some.count;
      rows.elements.push_back(number);
      for (std::int32_t i = 0; i < batch.sides; ++i) {
        const std::int32_t corner = all.indices[at(batch.firstIndex) + at(g) * at(batch.sides) + at(i)];
        rows.indices.push_back(level <= root_ ? corner : sharing.setPoint(level, corner));
      }
    }
    if (some.count > 0) rows.batches.push_back(some);
  }
  return rows;
}

TileNormalPlan::Place TileNormalPlan::placeOf(std::int32_t normal) const {
  Place place;
  while (place.level + 1 < last_ && rule_.firstNormal(place.level + 1) <= normal) ++place.level;
  const LimitRows& rows = frames_[at(place.level)];
  const std::int32_t row = rows_[at(normal)];
  const auto behind = std::ranges::upper_bound(rows.batches, row, {}, &FrameBatch::firstElement);
  place.batch = static_cast<std::int32_t>(behind - rows.batches.begin()) - 1;
  const FrameBatch& batch = *(behind - 1);
  place.corners = std::span(rows.indices)
                      .subspan(at(batch.firstIndex) + at(row - batch.firstElement) * at(batch.sides), at(batch.sides));
  return place;
}

void TileNormalPlan::moveTo(TileNormals& normals) && {
  for (const LimitRows& rows : frames_) {
    normals.weights.append(rows.weights.begin(), rows.weights.end());
    normals.weightsSingle.append(rows.weightsSingle.begin(), rows.weightsSingle.end());
  }
  normals.neighbours = rule_.cornerNeighbours();
  normals.sharedCount = sharedCount_;
  normals.shared = std::move(sharedRows_);
  normals.sharedOffsets = std::move(offsets_);
  for (const std::int32_t normal : sums_) normals.sharedFaces.push_back(shared(normal));
}

}  // namespace honeycomb::Far
