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
    const std::int32_t output = first + (inRow ? i * step.pointsEach() : i);
    visit(inRow ? parts.written[at(output)] : parts.outputs[at(output)], output);
  }
}

/// Do the vertices of a face of the wanted level have hexagons as TileRings tells, of which tiles find all points?
bool TileAssembler::isRing(std::int32_t chain, const UnitBatch& batch, std::int32_t unit) const {
  const TileUnits& units = plan_.units;
  const TileLimitPlan& limits = *plan_.limits;
  const std::int32_t behind = units.last();
  if (plan_.places != TilePlaces::fours || batch.kind != UnitBatch::Kind::circulant || units.unitAt(chain, behind) < 0)
    return false;
  const std::int32_t first = units.level(units.wanted()).firstOutput(batch, unit);
  const LevelUnits& last = units.level(behind);
  const auto isOf = [&](std::int32_t point, std::int32_t maker, std::int32_t place) {
    return last.pointChain[at(point)] == maker && last.pointPlace[at(point)] == place;
  };
  const std::int32_t n = batch.outputs;
  for (std::int32_t i = 0; i < n; ++i) {
    const TileLimitPlan::Place hexagon = limits.placeOf(first + i);
    if (limits.shared(first + i) || hexagon.level != behind || !limits.isHexagon(hexagon.shape)) return false;
    const TileLimitPlan::Place next = limits.placeOf(first + (i + 1) % n);
    if (next.points.size() != hexagon.points.size()) return false;
    if (!isOf(hexagon.points[0], chain, i) || !isOf(hexagon.points[1], chain, (i + n - 1) % n)) return false;
    // The three points of the neighbour across the edge to the next vertex.
    const std::int32_t middle = next.points[2];
    for (const std::int32_t point : {next.points[3], middle, hexagon.points[4]}) {
      if (plan_.sharing.sharedPoint(behind, point) >= 0) return false;
    }
    const std::int32_t neighbour = last.pointChain[at(middle)];
    const UnitBatch& faces = last.batchOf(units.unitAt(neighbour, behind));
    const std::int32_t place = last.pointPlace[at(middle)];
    const std::int32_t sides = faces.outputs;
    if (faces.kind != UnitBatch::Kind::circulant || place + 1 >= sides) return false;
    if (hexagon.points[5] != middle || !isOf(hexagon.points[4], neighbour, place + 1) ||
        !isOf(next.points[3], neighbour, (place + sides - 1) % sides))
      return false;
  }
  return true;
}

/// What the exact normals of the tile's own points are found from.
void TileAssembler::collectLimits() {
  const TileUnits& units = plan_.units;
  const TileLimitPlan& limits = *plan_.limits;
  const LevelUnits& wanted = units.level(units.wanted());
  forOwnedUnits([&](std::int32_t chain, const UnitBatch& batch, std::int32_t unit) {
    const bool ring = isRing(chain, batch, unit);
    held_[at(chain)].rings = ring;
    const std::int32_t first = wanted.firstOutput(batch, unit);
    for (std::int32_t point = first; point < first + batch.outputs; ++point) {
      if (limits.shared(point)) continue;
      const TileLimitPlan::Place place = limits.placeOf(point);
      for (const std::int32_t read : ring ? place.points.subspan(2, 1) : place.points) touchPoint(place.level, read);
    }
  });
}

void TileAssembler::addLimits(std::size_t firstStep, TileParts& parts) const {
  TileLimits& limits = parts.limits;
  const auto frames = static_cast<std::int32_t>(limits.frames.size());
  const auto rings = static_cast<std::int32_t>(limits.rings.size());
  std::size_t number = firstStep;
  for (std::int32_t k = plan_.units.root() + 1; k <= plan_.units.last(); ++k) {
    const std::int32_t firstChain = plan_.units.level(k).firstChain;
    forSteps(k, [&](std::span<const std::uint64_t> keys) {
      ringsOf(keys.front()) ? addRings(number, firstChain + unitOf(keys.front()), parts)
                            : addLimitsOf(parts.steps[number], parts);
      ++number;
    });
  }
  limits.tiles.push_back({frames, static_cast<std::int32_t>(limits.frames.size()) - frames});
  limits.ringTiles.push_back({rings, static_cast<std::int32_t>(limits.rings.size()) - rings});
}

/// `chain`: one of the step's faces.
void TileAssembler::addRings(std::size_t number, std::int32_t chain, TileParts& parts) const {
  const TileUnits& units = plan_.units;
  const std::int32_t behind = units.last();
  const TileStep& step = parts.steps[number];
  TileLimits& limits = parts.limits;
  const UnitBatch& faces = units.level(behind).batchOf(units.unitAt(chain, behind));
  limits.rings.push_back(
      {static_cast<std::int32_t>(number), weightOf(behind, faces), static_cast<std::int32_t>(limits.windows.size())});
  forWritten(step, parts, [&](std::int32_t first, std::int32_t) {
    for (std::int32_t point = first; point < first + step.width; ++point) {
      const TilePoint middle = ownNumber(behind, plan_.limits->placeOf(point).points[2], parts);
      limits.windows.push_back(static_cast<TilePoint>(middle - tilePoint(kTileFours)));
    }
  });
}

/// Faces whose points have frames of one shape stay together; of others each point is alone.
void TileAssembler::addLimitsOf(const TileStep& step, TileParts& parts) const {
  const TileLimitPlan& plan = *plan_.limits;
  const std::int32_t each = step.pointsEach();
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
