#include "far/tables/refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "far/base/index.h"
#include "far/tables/level_table_builder.h"
#include "far/tables/limit_table_builder.h"

namespace honeycomb::Far {

namespace {

/// Past this the counts only say "too many"; growing them further would overflow.
constexpr std::int64_t kCountable = std::int64_t{1} << 48;

/// Weights of the batches of whole faces, one set a side count: rows and their even and odd halves, or projections.
std::int64_t weightCount(std::int64_t sides) {
  return sides <= kLargestCirculant ? 2 * sides : 6 * sides + 2;
}

/// The weights a level's batches hold: for the side counts of the control faces, and behind the first level for those
/// of the control vertices' faces too.
struct BatchWeights {
  std::int64_t first = 0, later = 0;
};

BatchWeights batchWeights(const Topology& control) {
  BatchWeights weights;
  for (const FaceRun& run : control.runs()) weights.first += weightCount(run.sides);
  std::vector<std::uint8_t> seen;
  weights.later = weights.first;
  for (std::int32_t v = 0; v < control.vertexCount(); ++v) {
    const std::size_t faces = at(control.facesAt(v));
    if (faces >= seen.size()) seen.resize(faces + 1, 0);
    if (seen[faces] == 0) weights.later += weightCount(2 * static_cast<std::int64_t>(faces));
    seen[faces] = 1;
  }
  return weights;
}

/// Bytes of the arrays of a level and its table, about: three numbers a half-edge, two a face, one a vertex, an index
/// an output and the weights; points of the boundary rule have rows of about six entries.
std::int64_t levelBytes(const Census& census, std::int64_t weights) {
  constexpr std::int64_t kWeight = sizeof(double) + sizeof(float);
  constexpr std::int64_t kLooseRow = 2 * sizeof(std::int32_t) + 6 * (sizeof(std::int32_t) + kWeight);
  const std::int64_t topology =
      12 * census.halfEdges + 8 * census.faces + 4 * census.vertices + 5 * census.boundaryEdges;
  const std::int64_t tags = census.boundaryEdges > 0 ? census.vertices : 0;
  if (weights == 0) return topology + tags;
  const std::int64_t table = 4 * census.vertices + kLooseRow * std::min(census.boundaryEdges * 3, census.vertices);
  return topology + tags + table + kWeight * weights;
}

/// `weights`: of the level's table; none at level 0.
LevelCounts counts(const Census& census, std::int64_t weights) {
  LevelCounts c;
  c.vertices = census.vertices;
  c.edges = census.edges;
  c.faces = census.faces;
  c.halfEdges = census.halfEdges;
  c.boundaryEdges = census.boundaryEdges;
  c.bytes = levelBytes(census, weights);
  c.exact = census.exact;
  return c;
}

Census grow(const Scheme& scheme, const Census& parent) {
  if (parent.halfEdges > kCountable) return parent;
  Census child = scheme.split.grow(parent);
  child.exact = child.exact && child.halfEdges <= kCountable;
  return child;
}

/// About what refine() holds at its peak: all levels, the scratch of the split that makes the largest, and with limits
/// the rows that read the child level.
std::int64_t peakBytes(const std::vector<LevelCounts>& levels, bool limits) {
  std::int64_t bytes = 0;
  for (const LevelCounts& level : levels) bytes += level.bytes;
  bytes += 4 * levels.back().halfEdges;
  if (limits) bytes += 12 * levels.back().halfEdges;
  return bytes;
}

Result<void> checkSize(const Topology& control, std::span<const Scheme> perLevel, const RefineOptions& options) {
  std::vector<Scheme> steps(perLevel.begin(), perLevel.end());
  if (options.limits && !steps.empty()) steps.push_back(steps.back());
  std::vector<LevelCounts> levels = predict(control, steps);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    // Bounds are not refused: what is really built is checked by the split.
    if (levels[k].exact && levels[k].halfEdges > std::numeric_limits<std::int32_t>::max()) {
      return fail(ErrorCode::tooLarge,
                  fmt::format("level {} would have {} half-edges, past 2^31 - 1; use at most {} levels", k,
                              levels[k].halfEdges, k - (k == perLevel.size() + 1 ? 2 : 1)),
                  static_cast<std::int64_t>(k));
    }
  }
  const std::int64_t bytes = peakBytes(levels, options.limits);
  if (options.memoryLimit > 0 && bytes > options.memoryLimit) {
    return fail(ErrorCode::tooLarge,
                fmt::format("{} levels would take about {} MB of tables, and {} MB may be used; use fewer levels",
                            perLevel.size(), bytes >> 20, options.memoryLimit >> 20));
  }
  return {};
}

}  // namespace

std::vector<LevelCounts> predict(const Topology& control, std::span<const Scheme> perLevel) {
  Census census = takeCensus(control);
  const BatchWeights weights = batchWeights(control);
  std::vector<LevelCounts> levels{counts(census, 0)};
  for (const Scheme& scheme : perLevel) {
    census = grow(scheme, census);
    levels.push_back(counts(census, levels.size() == 1 ? weights.first : weights.later));
  }
  return levels;
}

Result<Refinement> refine(const Topology& control, std::span<const Scheme> perLevel, const RefineOptions& options) {
  if (perLevel.size() > at(kMaxLevels)) {
    return fail(ErrorCode::tooLarge,
                fmt::format("{} levels are too many; use at most {}", perLevel.size(), kMaxLevels));
  }
  if (options.limits && perLevel.empty()) {
    return fail(ErrorCode::invalidOption, "limits need a scheme; refine by at least one level");
  }
  if (auto sized = checkSize(control, perLevel, options); !sized) return tl::unexpected(sized.error());
  std::vector<Level> levels;
  levels.reserve(perLevel.size() + 1);
  levels.push_back({control, {}});
  for (const Scheme& scheme : perLevel) {
    Result<SplitResult> split = scheme.split.apply(levels.back().topology);
    if (!split) return tl::unexpected(split.error());
    LevelTable table = buildLevelTable(levels.back().topology, *split, scheme);
    levels.push_back({std::move(split->topology), std::move(table)});
  }
  LimitTable limits;
  if (options.limits) {
    const Result<SplitResult> child = perLevel.back().split.apply(levels.back().topology);
    if (!child) return tl::unexpected(child.error());
    limits = buildLimitTable(levels.back().topology, *child,
                             buildLevelTable(levels.back().topology, *child, perLevel.back()));
  }
  return Refinement(std::move(levels), std::move(limits));
}

Result<Refinement> refine(const Topology& control, const Scheme& scheme, std::int32_t levels,
                          const RefineOptions& options) {
  if (levels < 0 || levels > kMaxLevels) {
    return fail(ErrorCode::invalidOption, fmt::format("{} levels are out of range; use 0 to {}", levels, kMaxLevels));
  }
  const std::vector<Scheme> perLevel(at(levels), scheme);
  return refine(control, perLevel, options);
}

std::int64_t Refinement::byteCount() const {
  std::int64_t bytes = limits_.byteCount();
  for (const Level& level : levels_) bytes += level.topology.byteCount() + level.table.byteCount();
  return bytes;
}

}  // namespace honeycomb::Far
