#include "far/tables/tile_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/one_tile_proof.h"
#include "far/tables/table_proof.h"

namespace honeycomb::Far {

namespace {

constexpr std::int64_t kTilesPerProof = 8;

template <class... Arguments>
Result<void> unsoundTiles(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  return fail(ErrorCode::invalidFile, fmt::format(text, std::forward<Arguments>(arguments)...));
}

/// Levels, counts and sizes.
Result<void> proveFrame(const TileTable& tiles, const LevelTables& levels) {
  if (tiles.rootLevel < 0 || tiles.rootLevel >= tiles.lastLevel || tiles.lastLevel > levels.levelCount())
    return unsoundTiles("they are of levels that aren't there");
  if (tiles.order > TileOrder::tiles || tiles.normalKind > TileNormalKind::exact ||
      (tiles.places != TilePlaces::faces && tiles.places != TilePlaces::fours))
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
    (loose ? rows : indices).take(loose ? step.count : step.count * indicesEach(step));
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
  for (const TileLimits::Range& range : tiles.limits.tiles) exactFrames.take(range.count);
  for (const TileVertexFrames& some : tiles.limits.frames)
    points.take(std::int64_t{some.count} * std::clamp(some.each, 0, kLargestCirculant) *
                std::clamp(some.sides, 0, kMostTilePoints));
  Share rings(tiles.limits.rings.size()), windows(tiles.limits.windows.size());
  for (const TileLimits::Range& range : tiles.limits.ringTiles) rings.take(range.count);
  for (const TileRings& some : tiles.limits.rings) {
    if (!liesWithin(some.step, 1, std::ssize(tiles.steps)))
      return unsoundTiles("a normal is of a step that isn't there");
    const TileStep& step = tiles.steps[at(some.step)];
    windows.take(std::int64_t{step.count} * step.width);
  }
  for (const Share& share :
       {imports, steps, stages, rows, indices, normalImports, frames, corners, exactFrames, points, rings, windows}) {
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
  if (limits.tiles.size() != tiles.tiles.size() || limits.ringTiles.size() != tiles.tiles.size() ||
      limits.weights.size() != limits.weightsSingle.size())
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
  std::vector<const char*> wrong(tiles.tiles.size(), nullptr);
  Parallel::forEach(
      0, std::ssize(wrong), [&](std::int64_t t) { wrong[at(t)] = wrongWithTile(tiles, *shared, ends, at(t)); },
      kTilesPerProof);
  const auto first = std::ranges::find_if(wrong, [](const char* text) { return text != nullptr; });
  if (first == wrong.end()) return {};
  return unsoundTiles("tile {}: {}", first - wrong.begin(), *first);
}

}  // namespace honeycomb::Far
