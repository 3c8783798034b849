#include "far/tables/tile_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "far/base/bytes.h"
#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/base/pool.h"
#include "far/tables/tile_assembler.h"
#include "far/tables/tile_join.h"

namespace honeycomb::Far {

namespace {

/// Tiles put together by one task: some milliseconds.
constexpr std::int64_t kTilesPerPart = 8;
/// Points of the level behind the root that a tile should have, at least: smaller tiles have more rim than body.
constexpr std::int64_t kFewestPoints = 192;
/// Points that a tile keeps where it is cut smaller for the sake of threads: less takes less time than to hand it out.
constexpr std::int64_t kSmallTile = 4096;
/// What a tile holds beside the points that descend from its own, in hundredths.
constexpr std::int64_t kHalo = 130;

/// What the tables make of level k: a level may have values of other kinds behind its points, such as tangents.
std::int32_t pointsOf(const Refinement& refinement, std::int32_t k) {
  return k == 0 ? refinement.level(1).table.sourceCount : tableOf(refinement, k).targetCount;
}

/// What a table is cut for: the levels behind `root` up to `last`, whose points tiles write.
struct TileCut {
  const Refinement& refinement;
  const TileOptions& options;
  std::int32_t root = 0;
  std::int32_t last = 0;
};

/// The room that tiles need together for the points they keep, their halos left aside. Nearly all faces become
/// hexagons: in fours there is one point more for each six, and of the level behind the last, which exact normals read,
/// those of about three faces of four, halos considered.
std::int64_t keptPoints(const TileCut& cut) {
  const bool exact = cut.options.normals == TileNormalKind::exact;
  const bool fours = cut.options.places == TilePlaces::fours;
  std::int64_t points = 0;
  for (std::int32_t k = cut.root; k < cut.last; ++k) points += pointsOf(cut.refinement, k);
  if (exact) {
    const std::int64_t behind = pointsOf(cut.refinement, cut.last + 1);
    points += pointsOf(cut.refinement, cut.last) + (fours ? behind * 3 / 4 : behind);
  }
  if (fours) points += points / 6;
  return std::max<std::int64_t>(1, points);
}

/// How many points of the level behind the root a tile may have for all its points to fit.
std::int64_t pointsPerTile(const TileCut& cut, std::int64_t scratch) {
  const std::int64_t first = pointsOf(cut.refinement, cut.root + 1);
  return std::max<std::int64_t>(1, scratch * 100 / kHalo * first / keptPoints(cut));
}

/// As many for all tiles, so that none is left over, and for as many tiles as are wanted.
std::int64_t evenPointsPerTile(const TileCut& cut, std::int64_t scratch) {
  const TileOptions& options = cut.options;
  const std::int64_t first = pointsOf(cut.refinement, cut.root + 1);
  const std::int64_t most = pointsPerTile(cut, scratch);
  const std::int64_t sound = std::min(keptPoints(cut) / kSmallTile, first / kFewestPoints);
  const std::int64_t needed = std::max<std::int64_t>(1, (first + most - 1) / most);
  const std::int64_t wanted = std::max(needed, std::min<std::int64_t>(options.fewestTiles, sound));
  const std::int64_t rounds = (wanted + options.workers - 1) / options.workers;
  std::int64_t tiles = rounds * options.workers;
  if (tiles > sound) tiles = std::max(needed, (rounds - 1) * options.workers);
  return (first + tiles - 1) / tiles;
}

/// The root level from which tiles of a sound size reach the last level.
std::int32_t chooseRoot(TileCut cut, std::int64_t scratch) {
  while (cut.root < cut.last - 1 && pointsPerTile(cut, scratch) < kFewestPoints) ++cut.root;
  return cut.root;
}

void copyWeights(const TileUnits& units, TileTable& table) {
  for (std::int32_t k = table.rootLevel + 1; k <= units.last(); ++k) {
    const LevelTable& level = *units.level(k).table;
    table.weights.append(level.weights.begin(), level.weights.end());
    table.weightsSingle.append(level.weightsSingle.begin(), level.weightsSingle.end());
  }
  for (TileStep& step : table.steps) {
    // Stages of one scheme have equal weights in different places.
    if (step.kind != TileStep::Kind::circulant) continue;
    const auto first = table.weights.begin() + table.stages[at(step.firstStage)].firstWeight;
    for (std::int32_t s = 1; s < step.stageCount && step.sameWeights; ++s) {
      const auto other = table.weights.begin() + table.stages[at(step.firstStage + s)].firstWeight;
      step.sameWeights = std::equal(first, first + formWeightCount(step.form, step.width), other);
    }
  }
}

/// Shared points that no tile writes stand behind all others in the order of tiles.
void numberShared(TileTable& table) {
  if (table.order != TileOrder::tiles || table.shared.empty()) return;
  for (SharedPoints::Run& run : table.shared[at(table.lastLevel - table.rootLevel - 1)].written) {
    const auto place = static_cast<std::int32_t>(table.written.size());
    for (std::int32_t i = 0; i < run.count; ++i) table.written.push_back(run.output + i);
    run.output = place;
  }
  if (table.limits.shared.elements.empty()) return;
  std::vector<std::int32_t> places(table.written.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[at(table.written[i])] = static_cast<std::int32_t>(i);
  for (std::int32_t& element : table.limits.shared.elements) element = places[at(element)];
}

/// Empty where a tile has more points than can be told apart.
std::vector<TileParts> assemble(const TilePlan& plan) {
  const std::int32_t tiles = plan.owners.tileCount;
  std::vector<TileParts> parts(at((tiles + kTilesPerPart - 1) / kTilesPerPart));
  Pool<TileAssembler> assemblers;
  Parallel::forRange(0, static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
    const auto assembler = assemblers.borrow([&] { return std::make_unique<TileAssembler>(plan); });
    for (std::int64_t p = begin; p < end; ++p) {
      const std::int64_t last = std::min<std::int64_t>(tiles, (p + 1) * kTilesPerPart);
      for (std::int64_t tile = p * kTilesPerPart; tile < last; ++tile) {
        assembler->add(static_cast<std::int32_t>(tile), parts[at(p)]);
      }
    }
  });
  for (const TileParts& part : parts) {
    if (part.largestTile > kMostTilePoints) return {};
  }
  return parts;
}

Result<void> checkOptions(const Refinement& refinement, std::int32_t last, const TileOptions& options) {
  if (last < 1 || last > refinement.levelCount()) {
    return fail(ErrorCode::invalidOption,
                fmt::format("level {} is out of range; use 1 to {}", last, refinement.levelCount()));
  }
  if (options.fewestTiles < 1) {
    return fail(ErrorCode::invalidOption,
                fmt::format("fewestTiles {} is out of range; use 1 or more", options.fewestTiles));
  }
  if (options.workers < 1) {
    return fail(ErrorCode::invalidOption, fmt::format("workers {} is out of range; use 1 or more", options.workers));
  }
  if (options.scratchPoints < 64 || options.scratchPoints > kMostTilePoints) {
    return fail(ErrorCode::invalidOption,
                fmt::format("scratchPoints {} is out of range; use 64 to {}", options.scratchPoints, kMostTilePoints));
  }
  if (options.normals != TileNormalKind::exact) return {};
  if (last < refinement.levelCount()) {
    return fail(ErrorCode::invalidOption, fmt::format("exact normals are of level {} alone; level {} was asked for",
                                                      refinement.levelCount(), last));
  }
  if (refinement.limits().child.sourceCount == 0) {
    return fail(ErrorCode::invalidOption, "exact normals need the limits: refine with RefineOptions::limits");
  }
  return {};
}

}  // namespace

Result<TileTable> buildTileTable(const Refinement& refinement, const TileOptions& options) {
  const std::int32_t last = options.level == 0 ? refinement.levelCount() : options.level;
  if (auto ok = checkOptions(refinement, last, options); !ok) return tl::unexpected(ok.error());
  for (std::int64_t scratch = options.scratchPoints;; scratch = scratch * 3 / 4) {
    TileTable table;
    table.order = options.order;
    table.places = options.places;
    table.lastLevel = last;
    table.normalKind = options.normals;
    TileCut cut{refinement, options, 0, last};
    cut.root = table.rootLevel = chooseRoot(cut, std::max<std::int64_t>(scratch, 1));
    const std::int64_t size = evenPointsPerTile(cut, scratch);
    TilePlan plan(refinement, table.rootLevel, last,
                  static_cast<std::int32_t>(std::min<std::int64_t>(size, kMostTilePoints)), options);
    std::vector<TileParts> parts = assemble(plan);
    if (parts.empty() && plan.owners.tileCount > 0) {
      if (scratch > 0) continue;
      return fail(ErrorCode::tooLarge, "what a single face reads is too much for a tile; evaluate level by level");
    }
    table.rootPoints = plan.units.rootPoints();
    for (std::int32_t k = 0; k <= last; ++k) table.pointCount.push_back(pointsOf(refinement, k));
    for (const TileParts& part : parts) table.largestTile = std::max(table.largestTile, part.largestTile);
    if (auto joined = joinTiles(parts, table); !joined) return tl::unexpected(joined.error());
    table.shared = std::move(plan.sharing).sets();
    copyWeights(plan.units, table);
    if (plan.normals) std::move(*plan.normals).moveTo(table.normals);
    if (plan.limits) std::move(*plan.limits).moveTo(table.limits);
    for (const TileNormalRange& range : table.normals.tiles)
      table.normals.largestTile = std::max(table.normals.largestTile, range.normalCount);
    numberShared(table);
    return table;
  }
}

std::int64_t TileTable::byteCount() const {
  std::int64_t total = bytes(pointCount) + bytes(tiles) + bytes(steps) + bytes(stages) + bytes(imports) +
                       bytes(indices) + bytes(rows) + bytes(outputs) + bytes(written) + bytes(weights) +
                       bytes(weightsSingle);
  total += normals.byteCount() + limits.byteCount();
  for (const SharedPoints& set : shared) total += set.table.byteCount() + bytes(set.written);
  return total;
}

std::int64_t TileLimits::byteCount() const {
  return bytes(tiles) + bytes(frames) + bytes(indices) + bytes(ringTiles) + bytes(rings) + bytes(windows) +
         bytes(weights) + bytes(weightsSingle) + shared.byteCount();
}

std::int64_t TileNormals::byteCount() const {
  std::int64_t total = bytes(tiles) + bytes(imports) + bytes(frames) + bytes(indices) + bytes(firstFace) + bytes(born) +
                       bytes(faces) + bytes(weights) + bytes(weightsSingle);
  for (const LimitRows& rows : shared) total += rows.byteCount();
  return total;
}

std::vector<std::int32_t> TileTable::tilesOf(std::int32_t level, std::span<const std::int32_t> points) const {
  std::vector<std::uint8_t> wanted(at(pointCount[at(level)]), 0);
  for (const std::int32_t point : points) wanted[at(point)] = 1;
  const auto writesAny = [&](const TileStep& step) {
    if (level < step.level || level >= step.level + step.stageCount) return false;
    const std::int32_t first = stages[at(step.firstStage + level - step.level)].firstOutput;
    if (first < 0) return false;
    const std::int32_t each = step.pointsEach();
    for (std::int32_t i = 0; i < step.count * each; ++i) {
      const std::int32_t point =
          order == TileOrder::tiles ? written[at(first + i)] : outputs[at(first + i / each)] + i % each;
      if (wanted[at(point)] != 0) return true;
    }
    return false;
  };
  std::vector<std::int32_t> found;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const auto own = std::span(steps).subspan(at(tiles[t].firstStep), at(tiles[t].stepCount));
    if (std::ranges::any_of(own, writesAny)) found.push_back(static_cast<std::int32_t>(t));
  }
  return found;
}

}  // namespace honeycomb::Far
