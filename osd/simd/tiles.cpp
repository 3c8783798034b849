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

/// One row: weights[0] p_0 + ..., its index'th entries `step` apart for K rows at a time.
template <class D>
HWY_INLINE hn::Vec<D> rowsSum(D d, const float* scratch, const float* weights, const TilePoint* index,
                              std::int32_t entries) {
  auto sum = hn::Set(d, weights[0]) * loadOwn(d, scratch, index, at(entries));
  for (std::int32_t j = 1; j < entries; ++j) {
    sum = sum + hn::Set(d, weights[j]) * loadOwn(d, scratch, index + j, at(entries));
  }
  return sum;
}

template <class D, class Sink>
HWY_INLINE void storeRows(D d, hn::Vec<D> v, const StageTarget& target, const Views& views, std::int32_t row,
                          Sink sink) {
  if (target.kept >= 0) hn::StoreU(v, d, views.scratch + kTileStride * (target.kept + row));
  if (target.wanted) sink.put(d, &v, 1, target.outputs, row);
}

template <class Sink>
void denseRows(const Far::TileTable& table, const TileStep& step, const Views& views, Sink sink) {
  const Wide d;
  const StageTarget target = Kernels::stageTarget(table, step, 0, views.level, views.last);
  const float* w = table.weightsSingle.data() + table.stages[at(step.firstStage)].firstWeight;
  const TilePoint* index = table.indices.data() + step.firstIndex;
  constexpr std::int32_t kAtOnce = kBlocks<Wide>;
  std::int32_t row = 0;
  for (; row + kAtOnce <= step.count; row += kAtOnce) {
    storeRows(d, rowsSum(d, views.scratch, w, index + row * step.width, step.width), target, views, row, sink);
  }
  const Block block;
  for (; row < step.count; ++row) {
    storeRows(block, rowsSum(block, views.scratch, w, index + row * step.width, step.width), target, views, row, sink);
  }
}

template <class Sink>
void looseRows(const Far::TileTable& table, const TileStep& step, const Views& views, Sink sink) {
  const Block d;
  const StageTarget target = Kernels::stageTarget(table, step, 0, views.level, views.last);
  const TilePoint* index = table.indices.data() + step.firstIndex;
  for (std::int32_t r = 0; r < step.count; ++r) {
    const Far::TileRow& row = table.rows[at(step.firstRow + r)];
    const float* w = table.weightsSingle.data() + row.firstWeight;
    storeRows(d, rowsSum(d, views.scratch, w, index, row.entries), target, views, r, sink);
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
        denseRows(table, step, views, sink);
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
