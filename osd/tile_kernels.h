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

/// Numbers gathered before they go past the caches: longer rows of whole lines suit the memory better.
constexpr std::int64_t kStreamNumbers = 1024;
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
  Real* stream = nullptr;   ///< room for kStreamNumbers and a point, on a cache line: the target is written past the
                            ///< caches; none: as all else
};

/// A stage's outputs: in the scratch, or in the target where its level is the wanted one.
struct StageTarget {
  bool wanted = false;
  const std::int32_t* outputs = nullptr;  ///< wanted, TileOrder::levels: first output of each face or row
  std::int32_t first = 0;                 ///< else: output of the first, the others follow
  std::int32_t of(std::int32_t item, std::int32_t each) const {
    return outputs != nullptr ? outputs[item] : first + item * each;
  }
};

inline StageTarget stageTarget(const Far::TileTable& table, const Far::TileStep& step, std::int32_t s,
                               std::int32_t level) {
  const Far::TileStage& stage = table.stages[at(step.firstStage + s)];
  if (step.level + s < level) return {false, nullptr, stage.firstPoint};
  if (table.order == Far::TileOrder::tiles) return {true, nullptr, stage.firstOutput};
  return {true, table.outputs.data() + stage.firstOutput, 0};
}

/// How many of a step's stages are evaluated for a wanted level: those before it that the tile reads, and its own if
/// the tile writes it.
inline std::int32_t stagesFor(const Far::TileTable& table, const Far::TileStep& step, std::int32_t level) {
  const std::int32_t upTo = std::min<std::int32_t>(step.stageCount, level - step.level + 1);
  if (upTo < 1 || step.level + upTo - 1 < level) return upTo;
  return table.stages[at(step.firstStage + upTo - 1)].firstOutput >= 0 ? upTo : upTo - 1;
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
  const Far::TilePoint* index = table.indices.data() + step.firstIndex;
  std::array<Real, at(Width)> p[N > 0 ? N : Far::kLargestCirculant];
  for (std::int32_t g = 0; g < step.count; ++g, index += n) {
    for (std::int32_t i = 0; i < n; ++i) p[i] = load<Width>(read.point(index[i]));
    for (std::int32_t s = 0; s < stages; ++s) {
      const StageTarget target = stageTarget(table, step, s, views.level);
      const View<Real>& out = target.wanted ? views.target : own;
      const std::int32_t first = target.of(g, n);
      const Real* weights = table.weightsAs<Real>().data() + table.stages[at(step.firstStage + s)].firstWeight;
      circulantFace<N>(step.form, weights, p, n, out, first);
      if (s + 1 == stages) break;
      for (std::int32_t i = 0; i < n; ++i) p[i] = load<Width>(out.point(first + i));
    }
  }
}

template <int Width, class Real>
void tileDense(const Far::TileTable& table, const Far::TileStep& step, const TileViews<Real>& views) {
  const StageTarget target = stageTarget(table, step, 0, views.level);
  const View<Real> own{views.scratch, kTileStride};
  const View<Real>& out = target.wanted ? views.target : own;
  const Real* w = table.weightsAs<Real>().data() + table.stages[at(step.firstStage)].firstWeight;
  const Far::TilePoint* index = table.indices.data() + step.firstIndex;
  for (std::int32_t r = 0; r < step.count; ++r, index += step.width) {
    store(rowSum<Width>(w, index, 0, step.width, byTilePoint<Real>(own.data)), out.point(target.of(r, 1)));
  }
}

template <int Width, class Real>
void tileLoose(const Far::TileTable& table, const Far::TileStep& step, const TileViews<Real>& views) {
  const StageTarget target = stageTarget(table, step, 0, views.level);
  const View<Real> own{views.scratch, kTileStride};
  const View<Real>& out = target.wanted ? views.target : own;
  const Real* weights = table.weightsAs<Real>().data();
  const Far::TilePoint* index = table.indices.data() + step.firstIndex;
  for (std::int32_t r = 0; r < step.count; ++r) {
    const Far::TileRow& row = table.rows[at(step.firstRow + r)];
    store(rowSum<Width>(weights + row.firstWeight, index, 0, row.entries, byTilePoint<Real>(own.data)),
          out.point(target.of(r, 1)));
    index += row.entries;
  }
}

template <int Width, class Real>
void evaluateTile(const Far::TileTable& table, const Far::Tile& tile, const TileViews<Real>& views) {
  importPoints<Width>(table, tile, views);
  for (const Far::TileStep& step : std::span(table.steps).subspan(at(tile.firstStep), at(tile.stepCount))) {
    const std::int32_t stages = stagesFor(table, step, views.level);
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
