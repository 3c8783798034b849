#include <algorithm>

#include "far/base/index.h"
#include "far/tables/tile_assembler.h"

namespace honeycomb::Far {

namespace {

/// Puts frames into groups as long as they are alike and their outputs follow each other.
class FrameGrouping {
 public:
  FrameGrouping(const TileLimitPlan& plan, TileLimits& limits, bool inRow)
      : plan_(plan), limits_(limits), row_(inRow) {}

  /// A face with `each` points of this shape, or a single point, whose output is `output`.
  void open(std::int32_t shape, std::int32_t each, std::int32_t output) {
    if (shape != shape_ || each != each_ || output != next_) {
      limits_.frames.push_back({plan_.sidesOf(shape), 0, each, static_cast<std::int32_t>(limits_.indices.size()),
                                plan_.firstWeight(shape), output});
      shape_ = shape;
      each_ = each;
    }
    ++limits_.frames.back().count;
    // TileOrder::tiles counts points, TileOrder::levels entries of TileTable::outputs.
    next_ = output + (row_ ? each : 1);
  }

 private:
  const TileLimitPlan& plan_;
  TileLimits& limits_;
  bool row_;
  std::int32_t shape_ = TileLimitPlan::kNoVertex - 1;
  std::int32_t each_ = 0;
  std::int32_t next_ = -1;
};

}  // namespace

/// The points of the wanted level that a step of the parts writes, face by face: visit(first point, output), the latter
/// as TileStage::firstOutput counts.
template <class Visit>
void TileAssembler::forWritten(const TileStep& step, const TileParts& parts, const Visit& visit) const {
  const std::int32_t s = plan_.units.wanted() - step.level;
  if (s < 0 || s >= step.stageCount) return;
  const std::int32_t first = parts.stages[at(step.firstStage + s)].firstOutput;
  if (first < 0) return;
  const bool inRow = plan_.order == TileOrder::tiles;
  for (std::int32_t i = 0; i < step.count; ++i) {
    const std::int32_t output = first + (inRow ? i * outputsOf(step) : i);
    visit(inRow ? parts.written[at(output)] : parts.outputs[at(output)], output);
  }
}

/// What the exact normals of the tile's own points are found from.
void TileAssembler::collectLimits() {
  forOwnedPoints([&](std::int32_t point) {
    if (plan_.limits->shared(point)) return;
    const TileLimitPlan::Place place = plan_.limits->placeOf(point);
    for (const std::int32_t read : place.points) touchPoint(place.level, read);
  });
}

void TileAssembler::addLimits(std::span<const TileStep> steps, TileParts& parts) const {
  TileLimits& limits = parts.limits;
  const auto before = static_cast<std::int32_t>(limits.frames.size());
  for (const TileStep& step : steps) addLimitsOf(step, parts);
  limits.tiles.push_back({before, static_cast<std::int32_t>(limits.frames.size()) - before});
}

/// Faces whose points have frames of one shape stay together; of others each point is alone.
void TileAssembler::addLimitsOf(const TileStep& step, TileParts& parts) const {
  const TileLimitPlan& plan = *plan_.limits;
  const std::int32_t each = outputsOf(step);
  const bool inRow = plan_.order == TileOrder::tiles;
  FrameGrouping groups(plan, parts.limits, inRow);
  const auto addPoints = [&](const TileLimitPlan::Place& place) {
    for (const std::int32_t point : place.points) parts.limits.indices.push_back(ownNumber(place.level, point, parts));
  };
  forWritten(step, parts, [&](std::int32_t first, std::int32_t output) {
    const std::int32_t shape = plan.placeOf(first).shape;
    const auto alike = [&](std::int32_t i) { return plan.placeOf(i).shape == shape && !plan.shared(i); };
    bool whole = true;
    for (std::int32_t i = first; i < first + each; ++i) whole = whole && alike(i);
    if (whole) groups.open(shape, each, output);
    for (std::int32_t i = 0; i < each; ++i) {
      if (plan.shared(first + i)) continue;
      const TileLimitPlan::Place place = plan.placeOf(first + i);
      if (!whole) {
        groups.open(place.shape, 1, inRow ? output + i : static_cast<std::int32_t>(parts.outputs.size()));
        if (!inRow) parts.outputs.push_back(first + i);
      }
      addPoints(place);
    }
  });
}

}  // namespace honeycomb::Far
