#include "far/tables/one_tile_proof.h"

#include <algorithm>

#include "far/base/index.h"
#include "far/tables/table_proof.h"
#include "far/tables/tile_units.h"

namespace honeycomb::Far {

namespace {

/// Are these the numbers of points (or normals) below `count`, as tiles keep them: twice the number?
bool areTilePoints(std::span<const TilePoint> points, std::int32_t count) {
  const auto top = static_cast<std::uint32_t>(2 * count) - 2;
  std::uint32_t high = 0, low = 0;
  for (const TilePoint point : points) {
    high |= top - point;
    low |= point;
  }
  return points.empty() || (count > 0 && (high >> 31U) == 0 && low % 2 == 0);
}

class TileProof {
 public:
  TileProof(const TileTable& table, std::int32_t sharedPoints, std::span<const std::int64_t> faceEnds)
      : table_(table),
        sharedPoints_(sharedPoints),
        faceEnds_(faceEnds),
        exact_(table.normalKind == TileNormalKind::exact) {}

  const char* wrongWith(std::size_t number) const {
    const Tile& tile = table_.tiles[number];
    if (!liesWithin(tile.firstImport, tile.importCount, std::ssize(table_.imports)) ||
        !liesWithin(tile.firstStep, tile.stepCount, std::ssize(table_.steps)))
      return "its imports or steps aren't there";
    if (tile.importCount > tile.pointCount || tile.pointCount > table_.largestTile) return "it has too many points";
    for (const std::int32_t point : std::span(table_.imports).subspan(at(tile.firstImport), at(tile.importCount))) {
      if (point < 0 || point >= table_.rootPoints + sharedPoints_) return "it imports a point that isn't there";
    }
    for (std::int32_t s = tile.firstStep; s < tile.firstStep + tile.stepCount; ++s) {
      if (const char* wrong = wrongWithStep(table_.steps[at(s)], tile.pointCount)) return wrong;
    }
    if (table_.normalKind == TileNormalKind::fast) return wrongWithNormals(number);
    return exact_ ? wrongWithLimits(number) : nullptr;
  }

 private:
  bool hasWeights(std::int32_t first, std::int64_t count) const {
    return liesWithin(first, count, std::ssize(table_.weights));
  }

  /// Do the outputs of `count` faces of `each` points, from `first` on (as TileStage::firstOutput), lie in a level?
  bool areOutputs(std::int32_t first, std::int64_t count, std::int32_t each, std::int32_t level) const {
    const std::int32_t points = table_.pointCount[at(std::min(level, table_.lastLevel))];
    if (table_.order == TileOrder::tiles) {
      return liesWithin(first, count * each, std::min<std::int64_t>(points, std::ssize(table_.written)));
    }
    if (!liesWithin(first, count, std::ssize(table_.outputs))) return false;
    const auto outputs = std::span(table_.outputs).subspan(at(first), at(count));
    return std::ranges::all_of(outputs, [&](std::int32_t output) { return liesWithin(output, each, points); });
  }

  const char* wrongWithStep(const TileStep& step, std::int32_t points) const {
    const std::int32_t end = table_.lastLevel + (exact_ ? 1 : 0);
    const bool rows = step.kind != TileStep::Kind::circulant;
    if (step.kind > TileStep::Kind::loose || step.count < 0) return "a step is of no known kind";
    if (step.level <= table_.rootLevel || step.stageCount < 1 || step.level + step.stageCount - 1 > end ||
        (rows && step.stageCount > 1))
      return "a step is of levels that aren't there";
    if (!liesWithin(step.firstStage, step.stageCount, std::ssize(table_.stages))) return "a step's stages aren't there";
    if (!rows && !isFormOf(step.form, step.width)) return "a step's faces have no such form";
    if (step.kind == TileStep::Kind::dense && (step.width < 1 || step.width > kWidestDense))
      return "a step's rows have no such width";
    if (step.pairs && (rows || step.width % 2 != 0 || table_.places != TilePlaces::fours))
      return "a step's points are no pairs";
    std::int64_t indices = step.count * indicesEach(step);
    if (step.kind == TileStep::Kind::loose && !entriesOf(step, indices)) return "a step's rows aren't there";
    if (!liesWithin(step.firstIndex, indices, std::ssize(table_.indices))) return "a step's indices aren't there";
    if (!areTilePoints(std::span(table_.indices).subspan(at(step.firstIndex), at(indices)),
                       step.pairs ? points - kTileFours : points))
      return "a step reads a point that the tile hasn't";
    for (std::int32_t s = 0; s < step.stageCount; ++s) {
      if (const char* wrong = wrongWithStage(step, s, points)) return wrong;
    }
    return nullptr;
  }

  /// The entries of a step's rows, if rows and weights are there.
  bool entriesOf(const TileStep& step, std::int64_t& entries) const {
    if (!liesWithin(step.firstRow, step.count, std::ssize(table_.rows))) return false;
    entries = 0;
    for (const TileRow& row : std::span(table_.rows).subspan(at(step.firstRow), at(step.count))) {
      if (row.entries < 1 || !hasWeights(row.firstWeight, row.entries)) return false;
      entries += row.entries;
    }
    return true;
  }

  const char* wrongWithStage(const TileStep& step, std::int32_t s, std::int32_t points) const {
    const TileStage& stage = table_.stages[at(step.firstStage + s)];
    const bool faces = step.kind == TileStep::Kind::circulant;
    const std::int32_t each = step.pointsEach();
    const std::int32_t level = step.level + s;
    const std::int64_t weights = faces                                ? formWeightCount(step.form, step.width)
                                 : step.kind == TileStep::Kind::dense ? step.width
                                                                      : 0;
    if (!hasWeights(stage.firstWeight, weights)) return "a stage's weights aren't there";
    if (stage.firstPoint < -1 || stage.firstOutput < -1) return "a stage has no such place";
    const std::int64_t kept = roomOfFaces(step.placesIn(table_.places), step.count, each);
    if (stage.firstPoint >= 0 && !liesWithin(stage.firstPoint, kept, points))
      return "a stage writes past the tile's points";
    if (stage.firstOutput >= 0 && !areOutputs(stage.firstOutput, step.count, each, level))
      return "a stage writes past the level's points";
    // What faces evolve through is kept, or written as it goes on.
    const bool written = exact_ && level == table_.lastLevel && stage.firstOutput >= 0;
    const bool last = level == table_.lastLevel && !exact_;
    if (faces && stage.firstPoint < 0 && !written && !last) return "a stage's points are kept nowhere";
    return nullptr;
  }

  const char* wrongWithNormals(std::size_t number) const {
    const TileNormals& normals = table_.normals;
    const TileNormalRange& range = normals.tiles[number];
    const Tile& tile = table_.tiles[number];
    if (!liesWithin(range.firstImport, range.importCount, std::ssize(normals.imports)) ||
        !liesWithin(range.firstFrames, range.framesCount, std::ssize(normals.frames)))
      return "its normals aren't there";
    for (const std::int32_t normal : std::span(normals.imports).subspan(at(range.firstImport), at(range.importCount))) {
      if (normal < 0 || normal >= normals.sharedCount) return "it imports a normal that isn't there";
    }
    std::int64_t count = range.importCount;
    for (const TileFrames& frames : std::span(normals.frames).subspan(at(range.firstFrames), at(range.framesCount))) {
      if (!areFrames(frames, 1, normals.indices, std::ssize(normals.weights), tile.pointCount))
        return "a normal is of points that the tile hasn't";
      count += frames.count;
    }
    if (count > range.normalCount || range.normalCount > normals.largestTile) return "it has too many normals";
    for (std::int32_t s = tile.firstStep; s < tile.firstStep + tile.stepCount; ++s) {
      if (!areBorn(table_.steps[at(s)], normals.born[at(s)], range.normalCount))
        return "the normals of a step's faces aren't there";
      if (normals.firstFace[at(s)] >= 0 && !areSums(at(s), range.normalCount))
        return "a point sums normals that the tile hasn't";
    }
    return nullptr;
  }

  /// Frames read `each` times `sides` points an item.
  template <class Frames>
  static bool areFrames(const Frames& frames, std::int32_t each, std::span<const TilePoint> indices,
                        std::int64_t weights, std::int32_t points) {
    if (frames.sides < 0 || frames.sides > kMostTilePoints || frames.count < 0) return false;
    const std::int64_t read = std::int64_t{frames.count} * each * frames.sides;
    return liesWithin(frames.firstWeight, 3 * std::int64_t{frames.sides}, weights) &&
           liesWithin(frames.firstIndex, read, std::ssize(indices)) &&
           areTilePoints(indices.subspan(at(frames.firstIndex), at(read)), points);
  }

  bool areBorn(const TileStep& step, const TileBorn& born, std::int32_t normalCount) const {
    if (born.firstNormal < 0) return born.firstNormal == -1;
    return step.kind == TileStep::Kind::circulant && liesWithin(born.firstNormal, step.count, normalCount) &&
           liesWithin(born.firstWeight, 3 * std::int64_t{step.width}, std::ssize(table_.normals.weights));
  }

  /// The normals that the last level's points of a step sum.
  bool areSums(std::size_t number, std::int32_t normalCount) const {
    const auto& faces = table_.normals.faces;
    const TileStep& step = table_.steps[number];
    const std::int32_t first = table_.normals.firstFace[number];
    const std::int64_t end = faceEnds_[number];
    const std::int32_t last = step.level + step.stageCount - 1;
    if (last != table_.lastLevel || table_.stages[at(step.firstStage + step.stageCount - 1)].firstOutput < 0)
      return false;
    const auto areNormals = [&](std::int64_t from, std::int64_t count) {
      return liesWithin(from, count, end) && areTilePoints(std::span(faces).subspan(at(from), at(count)), normalCount);
    };
    if (step.kind == TileStep::Kind::circulant) {
      return areNormals(first, step.count * (1 + std::int64_t{step.width} * table_.normals.neighbours));
    }
    std::int64_t place = first;
    for (std::int32_t r = 0; r < step.count; ++r) {
      if (place >= end || !areNormals(place + 1, faces[at(place)])) return false;
      place += 1 + faces[at(place)];
    }
    return true;
  }

  const char* wrongWithLimits(std::size_t number) const {
    const TileLimits& limits = table_.limits;
    const TileLimits::Range& range = limits.tiles[number];
    if (!liesWithin(range.first, range.count, std::ssize(limits.frames))) return "its normals aren't there";
    for (const TileVertexFrames& frames : std::span(limits.frames).subspan(at(range.first), at(range.count))) {
      if (frames.each < 1 || frames.each > kLargestCirculant ||
          !areFrames(frames, frames.each, limits.indices, std::ssize(limits.weights), table_.tiles[number].pointCount))
        return "a normal is of points that the tile hasn't";
      if (!areOutputs(frames.firstOutput, frames.count, frames.each, table_.lastLevel))
        return "a normal is of a point that isn't there";
    }
    return wrongWithRings(number);
  }

  const char* wrongWithRings(std::size_t number) const {
    const TileLimits& limits = table_.limits;
    const TileLimits::Range& range = limits.ringTiles[number];
    const Tile& tile = table_.tiles[number];
    if (!liesWithin(range.first, range.count, std::ssize(limits.rings))) return "its normals aren't there";
    std::int64_t own = 0;
    for (const TileRings& rings : std::span(limits.rings).subspan(at(range.first), at(range.count))) {
      if (rings.step < tile.firstStep || rings.step - tile.firstStep >= tile.stepCount)
        return "a normal is of a step that isn't there";
      const TileStep& step = table_.steps[at(rings.step)];
      const std::int32_t s = table_.lastLevel - step.level;
      if (step.kind != TileStep::Kind::circulant || s < 0 || s >= step.stageCount)
        return "a normal is of a step without such faces";
      const TileStage& stage = table_.stages[at(step.firstStage + s)];
      if (stage.firstPoint < 0 || stage.firstOutput < 0) return "a normal is of points that are kept nowhere";
      if (!hasWeights(rings.firstWeight, formWeightCount(step.form, step.width)))
        return "a ring's weights aren't there";
      const std::int64_t windows = std::int64_t{step.count} * step.width;
      if (!liesWithin(rings.firstIndex, windows, std::ssize(limits.windows)) ||
          !areTilePoints(std::span(limits.windows).subspan(at(rings.firstIndex), at(windows)),
                         tile.pointCount - 2 * kTileFours))
        return "a normal is of points that the tile hasn't";
      own += windows;
    }
    if (own > tile.pointCount) return "it has too many rings";
    return nullptr;
  }

  const TileTable& table_;
  std::int32_t sharedPoints_;
  std::span<const std::int64_t> faceEnds_;
  bool exact_;
};

}  // namespace

const char* wrongWithTile(const TileTable& table, std::int32_t sharedPoints, std::span<const std::int64_t> faceEnds,
                          std::size_t number) {
  return TileProof(table, sharedPoints, faceEnds).wrongWith(number);
}

}  // namespace honeycomb::Far
