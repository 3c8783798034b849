#include "far/tables/refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "far/base/bytes.h"
#include "far/base/index.h"
#include "far/schemes/creases.h"
#include "far/tables/level_step.h"
#include "far/tables/limit_table_builder.h"
#include "far/topology/crease_cut.h"

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
  // Counted by corners, which is faster than walking round each vertex.
  std::vector<std::int32_t> facesAt(at(control.vertexCount()), 0);
  for (const std::int32_t v : control.vert()) ++facesAt[at(v)];
  std::vector<std::uint8_t> seen;
  weights.later = weights.first;
  for (const std::int32_t faces : facesAt) {
    if (at(faces) >= seen.size()) seen.resize(at(faces) + 1, 0);
    if (seen[at(faces)] == 0) weights.later += weightCount(2 * std::int64_t{faces});
    seen[at(faces)] = 1;
  }
  return weights;
}

/// Bytes of a level's links: two numbers a half-edge, one a vertex.
std::int64_t linkBytes(const Census& census) {
  return 8 * census.halfEdges + 4 * census.vertices;
}

/// Does a level wait with its links until they are asked for?
bool hasLaterLinks(const Census& census, const Scheme* scheme) {
  return scheme != nullptr && scheme->split.laterLinks && census.boundaryEdges == 0;
}

/// Bytes of a table, about: the indices, which are the corners of the level before where all points come from whole
/// faces, and the weights; points of the boundary rule have rows of about six entries.
std::int64_t tableBytes(const Census& census, std::int64_t weights, const Scheme& scheme) {
  constexpr std::int64_t kWeight = sizeof(double) + sizeof(float);
  constexpr std::int64_t kLooseRow = 2 * sizeof(std::int32_t) + 6 * (sizeof(std::int32_t) + kWeight);
  const bool sharesCorners = census.boundaryEdges == 0 && scheme.entriesPerVertex == 1 && !scheme.centralPoints;
  const std::int64_t indices = sharesCorners ? 0 : 4 * scheme.entriesPerVertex * census.vertices;
  return indices + kLooseRow * std::min(census.boundaryEdges * 3, census.vertices) + kWeight * weights;
}

/// Bytes of the arrays of a level and its table, about: one number a half-edge, two a face, and the links.
std::int64_t levelBytes(const Census& census, std::int64_t weights, const Scheme* scheme) {
  const std::int64_t loops = 4 * census.halfEdges + 8 * census.faces + 5 * census.boundaryEdges;
  const std::int64_t tags = census.boundaryEdges > 0 ? census.vertices : 0;
  const std::int64_t links = hasLaterLinks(census, scheme) ? 0 : linkBytes(census);
  return loops + tags + links + (scheme == nullptr ? 0 : tableBytes(census, weights, *scheme));
}

/// What making a level takes besides it, a half-edge: the closed forms keep one number, splits along a boundary the
/// slots, the order of their candidates and where each went. Rows that no circulant makes are computed in pieces and
/// joined.
std::int64_t scratchBytes(const Census& census, const Scheme* scheme) {
  constexpr std::int64_t kClosedForm = 4, kSlots = 20, kRowEntry = 2 * (sizeof(std::int32_t) + sizeof(double));
  if (scheme == nullptr) return 0;
  const bool closedForm = census.boundaryEdges == 0;
  const std::int64_t rows =
      scheme->entriesPerVertex > 1 ? kRowEntry * scheme->entriesPerVertex * census.vertices : std::int64_t{0};
  return (closedForm ? kClosedForm : kSlots) * census.halfEdges + rows;
}

/// `scheme`: that of the level's table, which has that many weights; none at level 0.
LevelCounts counts(const Census& census, std::int64_t weights, const Scheme* scheme) {
  LevelCounts c;
  c.vertices = census.vertices;
  c.edges = census.edges;
  c.faces = census.faces;
  c.halfEdges = census.halfEdges;
  c.boundaryEdges = census.boundaryEdges;
  c.points = census.vertices + (scheme != nullptr && scheme->centralPoints ? census.faces : 0);
  c.bytes = levelBytes(census, weights, scheme);
  c.links = hasLaterLinks(census, scheme) ? linkBytes(census) : 0;
  c.scratch = scratchBytes(census, scheme);
  c.exact = census.exact;
  return c;
}

Census grow(const Split& split, const Census& parent) {
  if (parent.halfEdges > kCountable) return parent;
  Census child = split.grow(parent);
  child.exact = child.exact && child.halfEdges <= kCountable;
  return child;
}

/// The census of one level after the other. A mesh with creases is counted twice, as if they were never closed and as
/// if there were none: the levels on which some are closed lie between.
class Growth {
 public:
  explicit Growth(const Topology& control) : smooth_(takeCensus(control)) {
    for (const CreaseEdge& crease : control.creases()) {
      firstClosed_ = std::min(firstClosed_, std::ceil(crease.sharpness));
      lastClosed_ = std::max(lastClosed_, std::ceil(crease.sharpness));
    }
    if (lastClosed_ > 0) cut_ = takeCensus(cutCreases(control, 0).topology);
  }

  void step(const Scheme& scheme) {
    ++level_;
    if (level_ < lastClosed_ && scheme.creases.reach != CreaseRule::Reach::none)
      cut_ = grow(scheme.creases.split, cut_);
    smooth_ = grow(scheme.split, smooth_);
  }

  Census census() const {
    if (level_ == 0 || level_ >= lastClosed_) return smooth_;
    Census census = cut_;
    census.exact = census.exact && level_ < firstClosed_;
    return census;
  }

 private:
  double firstClosed_ = std::numeric_limits<double>::infinity();  // the first level on which a crease is closed,
  double lastClosed_ = 0;                                         // and the first on which all are
  double level_ = 0;
  Census smooth_, cut_;
};

/// An error of the step to level k + 1. Numbers of a refined level's vertices and faces mean nothing to the caller.
Error ofStep(std::size_t k, Error error) {
  if (k == 0) return error;
  return {error.code, fmt::format("level {}: {}", k, error.message)};
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
  const BuildBytes build = buildBytes(levels, options.limits);
  const std::int64_t bytes = build.tables + build.scratch;
  if (options.memoryLimit > 0 && bytes > options.memoryLimit) {
    return fail(ErrorCode::tooLarge,
                fmt::format("{} levels would take about {} MB of tables, and {} MB may be used; use fewer levels",
                            perLevel.size(), bytes >> 20, options.memoryLimit >> 20));
  }
  return {};
}

}  // namespace

std::vector<LevelCounts> predict(const Topology& control, std::span<const Scheme> perLevel) {
  Growth growth(control);
  const BatchWeights weights = batchWeights(control);
  std::vector<LevelCounts> levels{counts(growth.census(), 0, nullptr)};
  for (const Scheme& scheme : perLevel) {
    growth.step(scheme);
    levels.push_back(counts(growth.census(), levels.size() == 1 ? weights.first : weights.later, &scheme));
  }
  return levels;
}

BuildBytes buildBytes(std::span<const LevelCounts> levels, bool limits) {
  constexpr std::int64_t kLimitRows = 12;  // of the limits, a half-edge
  BuildBytes bytes;
  for (const LevelCounts& level : levels) {
    bytes.tables += level.bytes;
    bytes.scratch = std::max(bytes.scratch, level.scratch);
  }
  if (!limits || levels.empty()) return bytes;
  bytes.tables += kLimitRows * levels.back().halfEdges;
  // They ask for the links.
  for (const LevelCounts& level : levels.last(std::min<std::size_t>(levels.size(), 2))) bytes.tables += level.links;
  return bytes;
}

Result<Refinement> refine(const Topology& control, std::span<const Scheme> perLevel, const RefineOptions& options) {
  if (perLevel.size() > at(kMaxLevels)) {
    return fail(ErrorCode::tooLarge,
                fmt::format("{} levels are too many; use at most {}", perLevel.size(), kMaxLevels));
  }
  if (options.limits && perLevel.empty()) {
    return fail(ErrorCode::invalidOption, "limits need a scheme; refine by at least one level");
  }
  if (auto creased = checkCreases(control, perLevel); !creased) return tl::unexpected(creased.error());
  if (auto sized = checkSize(control, perLevel, options); !sized) return tl::unexpected(sized.error());
  std::vector<Level> levels;
  levels.reserve(perLevel.size() + 1);
  levels.push_back({control, {}, options.centralPoints ? CentralPoints::byInputFace : CentralPoints::none});
  for (const Scheme& scheme : perLevel) {
    Result<Level> level = nextLevel(levels.back(), scheme);
    if (!level) return tl::unexpected(ofStep(levels.size() - 1, level.error()));
    levels.push_back(std::move(*level));
  }
  LimitTable limits;
  if (options.limits) {
    Result<LimitTable> built = buildLimitTable(levels.back(), perLevel.back());
    if (!built) return tl::unexpected(built.error());
    limits = std::move(*built);
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

Refinement Refinement::followedBy(Level level) && {
  levels_.push_back(std::move(level));
  return Refinement(std::move(levels_), {});
}

std::int64_t Refinement::byteCount(std::int32_t k) const {
  const LevelTable& table = level(k).table;
  const bool shared = k > 0 && table.indices.sharesWith(level(k - 1).topology.sharedVert());
  return level(k).topology.byteCount() + table.byteCount() - (shared ? bytes(table.indices) : 0);
}

std::int64_t Refinement::byteCount() const {
  std::int64_t total = limits_.byteCount();
  for (std::int32_t k = 0; k <= levelCount(); ++k) total += byteCount(k);
  return total;
}

}  // namespace honeycomb::Far
