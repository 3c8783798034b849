#include "osd/simd/tiles.h"

#include "osd/simd/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "osd/simd/tiles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "osd/cpu_pieces.h"
#if HONEYCOMB_HAS_VECTORS
#include "osd/simd/points-inl.h"
#include "osd/simd/sinks-inl.h"
#include "osd/simd/tile_faces-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

#if HONEYCOMB_HAS_VECTORS

using Views = Kernels::TileViews<float>;

/// One row: weights[0] p_0 + ..., its index'th entries `step` apart for K rows at a time. N entries, or `entries` if 0.
template <int N, class D, class Weights>
HWY_INLINE hn::Vec<D> rowsSum(D d, const float* own, const Weights& weights, const TilePoint* index,
                              std::int32_t entries) {
  const int n = N > 0 ? N : entries;
  auto sum = weights[0] * loadOwn(d, own, index, at(n));
  HWY_UNROLL(4)
  for (int j = 1; j < n; ++j) sum = sum + weights[j] * loadOwn(d, own, index + j, at(n));
  return sum;
}

template <class D, class Sink>
HWY_INLINE void storeRows(D d, hn::Vec<D> v, const StageTarget& target, float* own, std::int32_t row, Sink sink) {
  if (target.kept >= 0) hn::StoreU(v, d, own + kTileStride * (target.kept + row));
  if (target.wanted) sink.put(d, &v, 1, target.outputs, row);
}

/// The rows of a dense step on a tile's own points.
struct DenseRows {
  float* own;
  const TilePoint* index;
  const float* weights;
  StageTarget target;
  std::int32_t count;
  std::int32_t width;

  DenseRows(const Far::TileTable& table, const TileStep& step, const Views& views)
      : own(views.scratch),
        index(table.indices.data() + step.firstIndex),
        weights(table.weightsSingle.data() + table.stages[at(step.firstStage)].firstWeight),
        target(Kernels::stageTarget(table, step, 0, views)),
        count(step.count),
        width(step.width) {}
};

/// Rows `row`, row + K, .. as long as there are K more. Returns the first that is left.
template <int N, class D, class Sink>
HWY_INLINE std::int32_t someDenseRows(D d, const DenseRows& rows, std::int32_t row, Sink sink) {
  const StageTarget target = rows.target;
  const WideWeights<D, N> weights(d, rows.weights);
  const int n = N > 0 ? N : rows.width;
  const TilePoint* index = rows.index + at(row) * at(n);
  for (; row + kBlocks<D> <= rows.count; row += kBlocks<D>, index += kBlocks<D> * n) {
    storeRows(d, rowsSum<N>(d, rows.own, weights, index, n), target, rows.own, row, sink);
  }
  return row;
}

template <int N, class Sink>
void denseRowsOf(const DenseRows& rows, Sink sink) {
  const std::int32_t row = someDenseRows<N>(Wide(), rows, 0, sink);
  if constexpr (kWideBlocks > 1) someDenseRows<N>(Block(), rows, row, sink);
}

template <class Sink>
void denseRows(const DenseRows& rows, Sink sink) {
  switch (rows.width) {
    case 2:
      return denseRowsOf<2>(rows, sink);
    case 3:
      return denseRowsOf<3>(rows, sink);
    case 4:
      return denseRowsOf<4>(rows, sink);
    default:
      denseRowsOf<0>(rows, sink);
  }
}

template <class Sink>
void looseRows(const Far::TileTable& table, const TileStep& step, const Views& views, Sink sink) {
  const Block d;
  const StageTarget target = Kernels::stageTarget(table, step, 0, views);
  const TilePoint* index = table.indices.data() + step.firstIndex;
  for (std::int32_t r = 0; r < step.count; ++r) {
    const Far::TileRow& row = table.rows[at(step.firstRow + r)];
    const WideWeights<Block, 0> weights(d, table.weightsSingle.data() + row.firstWeight);
    storeRows(d, rowsSum<0>(d, views.scratch, weights, index, row.entries), target, views.scratch, r, sink);
    index += row.entries;
  }
}

template <class Sink>
void stepsOf(const Far::TileTable& table, const Far::Tile& tile, const Views& views, Sink sink) {
  for (std::int32_t i = 0; i < tile.stepCount; ++i) {
    const TileStep& step = table.steps[at(tile.firstStep + i)];
    const std::int32_t stages = Kernels::stagesFor(table, step, views.level, views.last);
    if (stages < 1) continue;
    switch (step.kind) {
      case TileStep::Kind::circulant:
        facesOf(StepFaces(table, step, views, stages), sink);
        break;
      case TileStep::Kind::dense:
        denseRows(DenseRows(table, step, views), sink);
        break;
      case TileStep::Kind::loose:
        looseRows(table, step, views, sink);
        break;
    }
  }
}

void evaluateTile(const Far::TileTable& table, const Far::Tile& tile, const Views& views, std::int32_t length) {
  forPieceWidth(length, [&](auto width) { Kernels::importPoints<decltype(width)::value>(table, tile, views); });
  withSink(views.target, length, views.stream, [&](auto sink) HWY_ATTR { stepsOf(table, tile, views, sink); });
}

#else

void evaluateTile(const Far::TileTable& table, const Far::Tile& tile, const Kernels::TileViews<float>& views,
                  std::int32_t length) {
  forPieceWidth(length, [&](auto width) { Kernels::evaluateTile<decltype(width)::value>(table, tile, views); });
}

#endif

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace honeycomb::Osd::Simd {

HWY_EXPORT(evaluateTile);

void evaluateTile(const Far::TileTable& table, const Far::Tile& tile, const Kernels::TileViews<float>& views,
                  std::int32_t length) {
  HWY_DYNAMIC_DISPATCH(evaluateTile)(table, tile, views, length);
}

}  // namespace honeycomb::Osd::Simd
#endif
