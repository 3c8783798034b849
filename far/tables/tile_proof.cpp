#include "far/tables/tile_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/table_proof.h"

namespace honeycomb::Far {

namespace {

constexpr std::int64_t kTilesPerProof = 8;

template <class... Arguments>
Result<void> unsoundTiles(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  return fail(ErrorCode::invalidFile, fmt::format(text, std::forward<Arguments>(arguments)...));
}

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

/// The proof of one table's tiles, one by one: what is wrong with a tile, or null. Places are checked before anything
/// is read there.
class TileProof {
 public:
  /// `faceEnds`: where the normals of a step's points end at the latest, one a step; of fast normals.
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
    std::int64_t indices = std::int64_t{step.count} * step.width;
    if (step.kind == TileStep::Kind::loose && !entriesOf(step, indices)) return "a step's rows aren't there";
    if (!liesWithin(step.firstIndex, indices, std::ssize(table_.indices))) return "a step's indices aren't there";
    if (!areTilePoints(std::span(table_.indices).subspan(at(step.firstIndex), at(indices)), points))
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
    const std::int32_t each = faces ? step.width : 1;
    const std::int32_t level = step.level + s;
    const std::int64_t weights = faces                                ? formWeightCount(step.form, step.width)
                                 : step.kind == TileStep::Kind::dense ? step.width
                                                                      : 0;
    if (!hasWeights(stage.firstWeight, weights)) return "a stage's weights aren't there";
    if (stage.firstPoint < -1 || stage.firstOutput < -1) return "a stage has no such place";
    if (stage.firstPoint >= 0 && !liesWithin(stage.firstPoint, std::int64_t{step.count} * each, points))
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
    if (!liesWithin(range.firstFrames, range.framesCount, std::ssize(limits.frames))) return "its normals aren't there";
    for (const TileVertexFrames& frames :
         std::span(limits.frames).subspan(at(range.firstFrames), at(range.framesCount))) {
      if (frames.each < 1 || frames.each > kLargestCirculant ||
          !areFrames(frames, frames.each, limits.indices, std::ssize(limits.weights), table_.tiles[number].pointCount))
        return "a normal is of points that the tile hasn't";
      if (!areOutputs(frames.firstOutput, frames.count, frames.each, table_.lastLevel))
        return "a normal is of a point that isn't there";
    }
    return nullptr;
  }

  const TileTable& table_;
  std::int32_t sharedPoints_;
  std::span<const std::int64_t> faceEnds_;
  bool exact_;
};

/// Levels, counts and sizes.
Result<void> proveFrame(const TileTable& tiles, const LevelTables& levels) {
  if (tiles.rootLevel < 0 || tiles.rootLevel >= tiles.lastLevel || tiles.lastLevel > levels.levelCount())
    return unsoundTiles("they are of levels that aren't there");
  if (tiles.order > TileOrder::tiles || tiles.places > TilePlaces::fours || tiles.normalKind > TileNormalKind::exact)
    return unsoundTiles("they are of no known kind");
  if (std::ssize(tiles.pointCount) != tiles.lastLevel + 1) return unsoundTiles("they have other levels");
  for (std::int32_t k = 0; k <= tiles.lastLevel; ++k) {
    if (tiles.pointCount[at(k)] != levels.pointCount(k)) return unsoundTiles("level {} has other points", k);
  }
  if (tiles.rootPoints != tiles.pointCount[at(tiles.rootLevel)] || tiles.largestTile < 0 ||
      tiles.largestTile > kMostTilePoints || tiles.weights.size() != tiles.weightsSingle.size())
    return unsoundTiles("their counts contradict each other");
  const TileNormals& normals = tiles.normals;
  if (normals.neighbours < 1 || normals.neighbours > 2 || normals.sharedCount < 0 || normals.largestTile < 0 ||
      normals.largestTile > kMostTilePoints)
    return unsoundTiles("their normals have no such counts");
  if (tiles.normalKind == TileNormalKind::exact && tiles.lastLevel != levels.levelCount())
    return unsoundTiles("they have exact normals of a level that isn't the last");
  if (const std::int64_t i = firstOutside(tiles.written, tiles.pointCount.back()); i >= 0)
    return unsoundTiles("point {} in their order isn't there", i);
  return {};
}

/// Adds what parts of a table take of an array that they don't share.
class Share {
 public:
  explicit Share(std::size_t size) : left_(static_cast<std::int64_t>(size)) {}
  void take(std::int64_t count) {
    if (left_ >= 0 && count > 0) left_ = count > left_ ? -1 : left_ - count;
  }
  bool suffices() const { return left_ >= 0; }

 private:
  std::int64_t left_;
};

/// Tiles, steps and frames that shared their parts would take more time than the table's size justifies.
Result<void> proveTotals(const TileTable& tiles) {
  Share imports(tiles.imports.size()), steps(tiles.steps.size()), stages(tiles.stages.size()), rows(tiles.rows.size()),
      indices(tiles.indices.size());
  for (const Tile& tile : tiles.tiles) {
    imports.take(tile.importCount);
    steps.take(tile.stepCount);
  }
  for (const TileStep& step : tiles.steps) {
    stages.take(step.stageCount);
    const bool loose = step.kind == TileStep::Kind::loose;
    (loose ? rows : indices).take(loose ? step.count : std::int64_t{step.count} * step.width);
  }
  for (const TileRow& row : tiles.rows) indices.take(row.entries);
  const TileNormals& normals = tiles.normals;
  Share normalImports(normals.imports.size()), frames(normals.frames.size()), corners(normals.indices.size());
  for (const TileNormalRange& range : normals.tiles) {
    normalImports.take(range.importCount);
    frames.take(range.framesCount);
  }
  for (const TileFrames& some : normals.frames) corners.take(std::int64_t{some.count} * some.sides);
  Share exactFrames(tiles.limits.frames.size()), points(tiles.limits.indices.size());
  for (const TileLimits::Range& range : tiles.limits.tiles) exactFrames.take(range.framesCount);
  for (const TileVertexFrames& some : tiles.limits.frames)
    points.take(std::int64_t{some.count} * std::clamp(some.each, 0, kLargestCirculant) *
                std::clamp(some.sides, 0, kMostTilePoints));
  for (const Share& share :
       {imports, steps, stages, rows, indices, normalImports, frames, corners, exactFrames, points}) {
    if (!share.suffices()) return unsoundTiles("they take more of their arrays than there is");
  }
  return {};
}

/// Where the normals of each step's points end at the latest: where those of the next step begin. Empty where they
/// don't ascend.
std::vector<std::int64_t> faceEnds(const TileNormals& normals) {
  std::vector<std::int64_t> ends(normals.firstFace.size());
  std::int64_t end = std::ssize(normals.faces);
  for (std::size_t s = ends.size(); s-- > 0;) {
    ends[s] = end;
    if (normals.firstFace[s] < 0) continue;
    if (normals.firstFace[s] > end) return {};
    end = normals.firstFace[s];
  }
  return ends;
}

/// What is evaluated before the tiles. Returns how many points that are.
Result<std::int32_t> proveShared(const TileTable& tiles) {
  const bool exact = tiles.normalKind == TileNormalKind::exact;
  const std::int64_t sets = tiles.lastLevel - tiles.rootLevel + (exact ? 1 : 0);
  if (!tiles.shared.empty() && std::ssize(tiles.shared) != sets)
    return fail(ErrorCode::invalidFile, "they have shared points of other levels");
  std::int64_t points = 0;
  std::int32_t source = tiles.rootPoints;
  for (std::size_t i = 0; i < tiles.shared.size(); ++i) {
    const SharedPoints& set = tiles.shared[i];
    auto sound = proveShape(set.table);
    if (sound) sound = proveIndices(set.table);
    if (!sound) return tl::unexpected(sound.error());
    if (set.firstPoint != points || set.table.sourceCount != source)
      return fail(ErrorCode::invalidFile, "their shared points don't follow each other");
    const std::int32_t level = std::min(tiles.rootLevel + static_cast<std::int32_t>(i) + 1, tiles.lastLevel);
    for (const SharedPoints::Run& run : set.written) {
      if (!liesWithin(run.point, run.count, set.table.targetCount) ||
          !liesWithin(run.output, run.count, tiles.pointCount[at(level)]))
        return fail(ErrorCode::invalidFile, "a shared point goes where there is none");
    }
    source = set.table.targetCount;
    points += source;
    if (points > std::numeric_limits<std::int32_t>::max() - tiles.rootPoints)
      return fail(ErrorCode::invalidFile, "they have too many shared points");
  }
  return static_cast<std::int32_t>(points);
}

Result<void> proveRowsOf(const LimitRows& rows, std::int32_t points, std::int32_t elements) {
  if (auto sound = proveShape(rows); !sound) return sound;
  return proveIndices(rows, points, elements);
}

/// The normals that tiles import, and those of points that no tile writes.
Result<void> proveSharedNormals(const TileTable& tiles, std::int32_t sharedPoints) {
  const TileNormals& normals = tiles.normals;
  if (normals.tiles.size() != tiles.tiles.size() || normals.firstFace.size() != tiles.steps.size() ||
      normals.born.size() != tiles.steps.size() || std::ssize(normals.shared) != tiles.lastLevel ||
      normals.weights.size() != normals.weightsSingle.size())
    return unsoundTiles("their normals are of other tiles");
  std::int64_t elements = 0;
  for (const LimitRows& rows : normals.shared) elements += std::ssize(rows.elements);
  if (normals.sharedCount != elements) return unsoundTiles("their shared normals have another number");
  for (std::int32_t k = 0; k < tiles.lastLevel; ++k) {
    const std::int32_t points = k <= tiles.rootLevel ? tiles.pointCount[at(k)] : sharedPoints;
    if (auto sound = proveRowsOf(normals.shared[at(k)], points, normals.sharedCount); !sound) return sound;
  }
  std::int64_t written = 0;
  if (!tiles.shared.empty()) {
    for (const SharedPoints::Run& run : tiles.shared.back().written) written += run.count;
  }
  if (written > 0 && std::ssize(normals.sharedOffsets) < written + 1)
    return unsoundTiles("shared points have no normals");
  if (firstNotAscending(normals.sharedOffsets, 0, std::ssize(normals.sharedFaces)) >= 0 ||
      firstOutside(normals.sharedFaces, normals.sharedCount) >= 0)
    return unsoundTiles("a shared point sums normals that aren't there");
  return {};
}

Result<void> proveSharedLimits(const TileTable& tiles, std::int32_t sharedPoints) {
  const TileLimits& limits = tiles.limits;
  if (limits.tiles.size() != tiles.tiles.size() || limits.weights.size() != limits.weightsSingle.size())
    return unsoundTiles("their normals are of other tiles");
  return proveRowsOf(limits.shared, sharedPoints, tiles.pointCount.back());
}

}  // namespace

Result<void> proveTiles(const TileTable& tiles, LevelTables levels) {
  if (auto sound = proveFrame(tiles, levels); !sound) return sound;
  if (auto sound = proveTotals(tiles); !sound) return sound;
  const Result<std::int32_t> shared = proveShared(tiles);
  if (!shared) return tl::unexpected(shared.error());
  Result<void> sound;
  if (tiles.normalKind == TileNormalKind::fast) sound = proveSharedNormals(tiles, *shared);
  if (tiles.normalKind == TileNormalKind::exact) sound = proveSharedLimits(tiles, *shared);
  if (!sound) return sound;
  const std::vector<std::int64_t> ends = faceEnds(tiles.normals);
  if (ends.size() != tiles.normals.firstFace.size()) return unsoundTiles("their points' normals are out of order");
  const TileProof proof(tiles, *shared, ends);
  std::vector<const char*> wrong(tiles.tiles.size(), nullptr);
  Parallel::forEach(
      0, std::ssize(wrong), [&](std::int64_t t) { wrong[at(t)] = proof.wrongWith(at(t)); }, kTilesPerProof);
  const auto first = std::ranges::find_if(wrong, [](const char* text) { return text != nullptr; });
  if (first == wrong.end()) return {};
  return unsoundTiles("tile {}: {}", first - wrong.begin(), *first);
}

}  // namespace honeycomb::Far
