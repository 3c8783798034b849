#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "far/base/index.h"
#include "far/tables/tile_table.h"
#include "osd/cpu_kernels.h"
#include "osd/cpu_pieces.h"

/// Tiles in plain loops: the reference for the SIMD kernels of osd/simd, and what double precision runs on.
namespace honeycomb::Osd::Kernels {

/// Numbers from one of a tile's own points to the next.
constexpr std::int32_t kTileStride = 4;

/// A tile's own points (or normals) by Far::TilePoint, which is twice their number.
template <class Real>
View<const Real> byTilePoint(const Real* own) {
  return {own, kTileStride / 2};
}

/// Numbers gathered before they go past the caches. Shorter rows of whole lines suit the memory less; behind longer
/// ones the thread waits for it instead of working on meanwhile. Measured where memory is the limit: 5 to 30 % less
/// time than with 64 to 256, 5 to 15 % less than with 2048.
constexpr std::int64_t kStreamNumbers = 512;
/// Room for these, a begun line, and the outputs of the largest face or of a vector of smaller ones.
constexpr std::int64_t kStreamRoom = kStreamNumbers + 16 + 4 * Far::kLargestCirculant + 16;

/// What a tile is evaluated on.
template <class Real>
struct TileViews {
  View<const Real> root;    ///< points of the root level
  View<const Real> shared;  ///< shared points of all levels
  View<Real> target;        ///< points of the wanted level
  Real* scratch;            ///< the tile's own points, kTileStride apart
  std::int32_t level;       ///< the wanted level, behind the root level
  std::int32_t last;        ///< that, or the one behind it where its points are to be kept too
  Real* stream = nullptr;   ///< room for kStreamNumbers and a point, on a cache line: the target is written past the
                            ///< caches; none: as all else
  Real* normals = nullptr;  ///< NormalViews::scratch, where fast normals follow: kernels that have a face's corners at
                            ///< hand may leave T1 x T2 there for those that make it unit
  std::span<const Far::TileRings> later = {};  ///< the steps whose points of the wanted level leave with their normals:
                                               ///< NormalViews::points
};

/// A place in the target for each face (or row) of a step: that of its first point.
struct Outputs {
  const std::int32_t* each = nullptr;  ///< TileOrder::levels: one a face
  std::int32_t first = 0;              ///< TileOrder::tiles: of the first face, the others follow
  std::int32_t of(std::int32_t face, std::int32_t points) const {
    return each != nullptr ? each[face] : first + face * points;
  }
};

/// `first`: as TileStage::firstOutput.
inline Outputs outputsFrom(const Far::TileTable& table, std::int32_t first) {
  if (table.order == Far::TileOrder::tiles) return {nullptr, first};
  return {table.outputs.data() + first, 0};
}

/// Where a stage's points go: to the scratch where others read them, to the target where its level is the wanted one
/// and the tile writes it.
struct StageTarget {
  std::int32_t kept = -1;  ///< TileStage::firstPoint; -1: not kept
  bool wanted = false;
  Outputs outputs;
};

inline StageTarget stageTarget(const Far::TileTable& table, const Far::TileStep& step, std::int32_t s,
                               std::int32_t level, std::int32_t last) {
  const Far::TileStage& stage = table.stages[at(step.firstStage + s)];
  const std::int32_t here = step.level + s;
  StageTarget target;
  if (here < level || last > level) target.kept = stage.firstPoint;
  target.wanted = here == level && stage.firstOutput >= 0;
  if (target.wanted) target.outputs = outputsFrom(table, stage.firstOutput);
  return target;
}

/// The same without the points that leave later.
template <class Real>
StageTarget stageTarget(const Far::TileTable& table, const Far::TileStep& step, std::int32_t s,
                        const TileViews<Real>& views) {
  StageTarget target = stageTarget(table, step, s, views.level, views.last);
  const auto number = &step - table.steps.data();
  for (const Far::TileRings& rings : views.later) target.wanted &= rings.step != number;
  return target;
}

/// How many of a step's stages are evaluated: those whose points the tile reads, and that of the wanted level if the
/// tile writes it.
inline std::int32_t stagesFor(const Far::TileTable& table, const Far::TileStep& step, std::int32_t level,
                              std::int32_t last) {
  const std::int32_t upTo = std::min<std::int32_t>(step.stageCount, last - step.level + 1);
  if (upTo < 1 || last > level || step.level + upTo - 1 < level) return upTo;
  return table.stages[at(step.firstStage + upTo - 1)].firstOutput >= 0 ? upTo : upTo - 1;
}

/// What the faces of a step are born from.
inline Far::TileCorners cornersOf(const Far::TileTable& table, const Far::TileStep& step) {
  return {table.indices.data() + step.firstIndex, step.width, step.pairs};
}

/// The points of a step's outputs of the last level.
inline Outputs lastOutputs(const Far::TileTable& table, const Far::TileStep& step) {
  return outputsFrom(table, table.stages[at(step.firstStage + step.stageCount - 1)].firstOutput);
}

template <int Width, class Real>
void importPoints(const Far::TileTable& table, const Far::Tile& tile, const TileViews<Real>& views) {
  Real* own = views.scratch;
  for (std::int32_t i = 0; i < tile.importCount; ++i, own += kTileStride) {
    const std::int32_t point = table.imports[at(tile.firstImport + i)];
    const bool ofRoot = point < table.rootPoints;
    store(load<Width>(ofRoot ? views.root.point(point) : views.shared.point(point - table.rootPoints)), own);
  }
}

template <int N, int Width, class Real>
void tileFaces(const Far::TileTable& table, const Far::TileStep& step, std::int32_t stages,
               const TileViews<Real>& views) {
  const std::int32_t n = N > 0 ? N : step.width;
  const View<Real> own{views.scratch, kTileStride};
  const View<const Real> read = byTilePoint<Real>(views.scratch);
  constexpr int kMost = N > 0 ? N : Far::kLargestCirculant;
  const bool fours = table.places == Far::TilePlaces::fours;
  const Far::TileCorners corners = cornersOf(table, step);
  Far::TilePoint room[kMost];
  std::array<Real, at(Width)> p[kMost];
  StageTarget targets[Far::kMaxLevels + 1];
  for (std::int32_t s = 0; s < stages; ++s) targets[s] = stageTarget(table, step, s, views);
  for (std::int32_t g = 0; g < step.count; ++g) {
    const Far::TilePoint* index = corners.of(g, room);
    for (std::int32_t i = 0; i < n; ++i) p[i] = load<Width>(read.point(index[i]));
    const Far::FacePlaces places = Far::placesOfFace(table.places, g, n);
    for (std::int32_t s = 0; s < stages; ++s) {
      const StageTarget& target = targets[s];
      const bool kept = target.kept >= 0;
      const View<Real> out = kept ? View<Real>{own.point(target.kept + places.first), own.stride * places.step}
                                  : View<Real>{views.target.point(target.outputs.of(g, n)), views.target.stride};
      const Real* weights = table.weightsAs<Real>().data() + table.stages[at(step.firstStage + s)].firstWeight;
      circulantFace<N>(step.form, weights, p, n, out, 0);
      if (kept && fours) store(load<Width>(out.point(n - 1)), out.point(-1));
      if (kept && target.wanted) {
        const std::int32_t first = target.outputs.of(g, n);
        for (std::int32_t i = 0; i < n; ++i) store(load<Width>(out.point(i)), views.target.point(first + i));
      }
      if (s + 1 == stages) break;
      for (std::int32_t i = 0; i < n; ++i) p[i] = load<Width>(out.point(i));
    }
  }
}

/// The point of a row to wherever it is wanted.
template <int Width, class Real>
void storeRow(const std::array<Real, at(Width)>& point, const StageTarget& target, std::int32_t row,
              const TileViews<Real>& views) {
  if (target.kept >= 0) store(point, views.scratch + std::int64_t{kTileStride} * (target.kept + row));
  if (target.wanted) store(point, views.target.point(target.outputs.of(row, 1)));
}

template <int Width, class Real>
void tileDense(const Far::TileTable& table, const Far::TileStep& step, const TileViews<Real>& views) {
  const StageTarget target = stageTarget(table, step, 0, views);
  const View<const Real> own = byTilePoint<Real>(views.scratch);
  const Real* w = table.weightsAs<Real>().data() + table.stages[at(step.firstStage)].firstWeight;
  const Far::TilePoint* index = table.indices.data() + step.firstIndex;
  for (std::int32_t r = 0; r < step.count; ++r, index += step.width) {
    storeRow<Width>(rowSum<Width>(w, index, 0, step.width, own), target, r, views);
  }
}

template <int Width, class Real>
void tileLoose(const Far::TileTable& table, const Far::TileStep& step, const TileViews<Real>& views) {
  const StageTarget target = stageTarget(table, step, 0, views);
  const View<const Real> own = byTilePoint<Real>(views.scratch);
  const Real* weights = table.weightsAs<Real>().data();
  const Far::TilePoint* index = table.indices.data() + step.firstIndex;
  for (std::int32_t r = 0; r < step.count; ++r) {
    const Far::TileRow& row = table.rows[at(step.firstRow + r)];
    storeRow<Width>(rowSum<Width>(weights + row.firstWeight, index, 0, row.entries, own), target, r, views);
    index += row.entries;
  }
}

template <int Width, class Real>
void evaluateTile(const Far::TileTable& table, const Far::Tile& tile, const TileViews<Real>& views) {
  importPoints<Width>(table, tile, views);
  for (const Far::TileStep& step : std::span(table.steps).subspan(at(tile.firstStep), at(tile.stepCount))) {
    const std::int32_t stages = stagesFor(table, step, views.level, views.last);
    if (stages < 1) continue;
    switch (step.kind) {
      case Far::TileStep::Kind::circulant:
        forSides(step.width, [&](auto sides) { tileFaces<decltype(sides)::value, Width>(table, step, stages, views); });
        break;
      case Far::TileStep::Kind::dense:
        tileDense<Width>(table, step, views);
        break;
      case Far::TileStep::Kind::loose:
        tileLoose<Width>(table, step, views);
        break;
    }
  }
}

}  // namespace honeycomb::Osd::Kernels
