#include "osd/tile_shared.h"

#include <algorithm>
#include <span>

#include "far/base/index.h"
#include "osd/cpu_kernels.h"
#include "osd/cpu_pieces.h"

namespace honeycomb::Osd {

template <class Real>
Result<void> TileShared<Real>::evaluate(CpuEvaluator& evaluator, Far::LevelTables levels, const Far::TileTable& tiles,
                                        std::int32_t level, const Points<Real>& control, const PointsOut<Real>& refined,
                                        const PointsOut<Real>& normals) {
  const auto wanted = [&](Far::TileNormalKind kind) { return !normals.data.empty() && tiles.normalKind == kind; };
  const bool fast = wanted(Far::TileNormalKind::fast);
  const bool exact = wanted(Far::TileNormalKind::exact);
  normals_.resize(fast ? 3 * at(tiles.normals.sharedCount) : 0);
  root_ = control;
  if (auto done = evaluateRoot(evaluator, levels, tiles, fast); !done) return done;
  if (tiles.shared.empty()) return {};
  if (auto done = evaluateSets(evaluator, tiles, level, exact ? level + 1 : level, refined); !done) return done;
  const std::int32_t length = control.desc.length;
  if (exact) findNormals(tiles.limits.shared, {shared_, {0, length, length}}, viewOf(normals));
  if (!fast) return {};
  for (std::int32_t k = tiles.rootLevel + 1; k < tiles.lastLevel; ++k) {
    findNormals(tiles.normals.shared[at(k)], {shared_, {0, length, length}}, {normals_.data(), 3});
  }
  writeNormals(tiles, normals);
  return {};
}

template <class Real>
Result<void> TileShared<Real>::evaluateRoot(CpuEvaluator& evaluator, Far::LevelTables levels,
                                            const Far::TileTable& tiles, bool normals) {
  const std::int32_t length = root_.desc.length;
  for (std::int32_t k = 0; k <= tiles.rootLevel; ++k) {
    if (k > 0) {
      const Far::LevelTable& table = levels.table(k);
      std::vector<Real>& points = levels_[k % 2];
      points.resize(at(table.targetCount) * at(length));
      const BufferDescriptor packed{0, length, length};
      if (auto done = evaluator.evaluate(table, root_, PointsOut<Real>{points, packed}); !done) return done;
      root_ = {points, packed};
    }
    if (normals) findNormals(tiles.normals.shared[at(k)], root_, {normals_.data(), 3});
  }
  return {};
}

/// Set behind set, each from the one before, up to level `last`.
template <class Real>
Result<void> TileShared<Real>::evaluateSets(CpuEvaluator& evaluator, const Far::TileTable& tiles, std::int32_t level,
                                            std::int32_t last, const PointsOut<Real>& refined) {
  const std::int32_t length = root_.desc.length;
  const Far::SharedPoints& lastSet = tiles.shared.back();
  shared_.resize(at(lastSet.firstPoint + lastSet.table.targetCount) * at(length));
  Points<Real> source = root_;
  for (std::int32_t k = tiles.rootLevel + 1; k <= last; ++k) {
    const Far::SharedPoints& set = tiles.shared[at(k - tiles.rootLevel - 1)];
    const std::span<Real> points =
        std::span(shared_).subspan(at(set.firstPoint) * at(length), at(set.table.targetCount) * at(length));
    const BufferDescriptor packed{0, length, length};
    if (!points.empty()) {
      if (auto done = evaluator.evaluate(set.table, source, PointsOut<Real>{points, packed}); !done) return done;
    }
    source = {points, packed};
    if (k != level) continue;
    for (const Far::SharedPoints::Run& run : set.written) {
      for (std::int32_t i = 0; i < run.count; ++i) {
        std::copy_n(points.data() + at(run.point + i) * at(length), length,
                    refined.data.data() + refined.desc.offset + std::int64_t{run.output + i} * refined.desc.stride);
      }
    }
  }
  return {};
}

template <class Real>
void TileShared<Real>::findNormals(const Far::LimitRows& rows, const Points<Real>& points, const View<Real>& normals) {
  const View<const Real> in = viewOf(points);
  for (const Far::FrameBatch& batch : rows.batches) {
    Kernels::frames(rows, batch, in, View<Real>{nullptr, 0}, normals, 0, batch.count);
  }
}

template <class Real>
void TileShared<Real>::writeNormals(const Far::TileTable& tiles, const PointsOut<Real>& normals) const {
  const View<const Real> from{normals_.data(), 3};
  const View<Real> to = viewOf(normals);
  std::size_t point = 0;
  for (const Far::SharedPoints::Run& run : tiles.shared.back().written) {
    for (std::int32_t i = 0; i < run.count; ++i, ++point) {
      const std::int32_t first = tiles.normals.sharedOffsets[point];
      const std::int32_t count = tiles.normals.sharedOffsets[point + 1] - first;
      Kernels::store(Kernels::normalSum(tiles.normals.sharedFaces.data() + first, count, from),
                     to.point(run.output + i));
    }
  }
}

template class TileShared<float>;
template class TileShared<double>;

}  // namespace honeycomb::Osd
