#include "osd/simd/tiles.h"

#include "osd/simd/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "osd/simd/tiles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HONEYCOMB_HAS_VECTORS
#include "osd/simd/circulant-inl.h"
#include "osd/simd/points-inl.h"
#include "osd/simd/sinks-inl.h"
#include "osd/simd/tile_limits-inl.h"
#include "osd/simd/tile_normals-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

#if HONEYCOMB_HAS_VECTORS

using Far::CirculantForm;
using Far::TilePoint;
using Far::TileStep;
using Kernels::kTileStride;
using Kernels::StageTarget;
using Views = Kernels::TileViews<float>;

using Wide = HWY_CAPPED(float, 16);

constexpr int kMostStages = Far::kMaxLevels + 1;

/// The faces of a step on a tile's own points.
struct StepFaces {
  const TileStep& step;
  float* own;
  const TilePoint* index;
  std::int32_t stages;
  StageTarget targets[kMostStages];
  const float* weights[kMostStages];

  StepFaces(const Far::TileTable& table, const TileStep& s, const Views& views, std::int32_t stageCount)
      : step(s), own(views.scratch), index(table.indices.data() + s.firstIndex), stages(stageCount) {
    for (std::int32_t i = 0; i < stages; ++i) {
      targets[i] = Kernels::stageTarget(table, s, i, views.level, views.last);
      weights[i] = table.weightsSingle.data() + table.stages[at(s.firstStage + i)].firstWeight;
    }
  }
};

/// Points of the faces of a vector, `face` and those behind it, to where the tile keeps them: as TilePlaces::fours or
/// one face behind the other.
template <bool kFours, class D>
HWY_INLINE void keep(D d, const hn::Vec<D>* out, int n, std::int32_t first, std::int32_t face, float* own) {
  if constexpr (kFours) {
    constexpr std::int32_t kStep = kTileStride * Far::kTileFours;
    const std::int32_t among = face % Far::kTileFours;
    float* p = own + std::size_t{kTileStride} * at(first + (face - among) * n + among);
    HWY_UNROLL(8)
    for (int i = 0; i < n; ++i) hn::StoreU(out[i], d, p + i * kStep);
  } else {
    storeInRow<Access::whole>(d, out, n, own + std::size_t{kTileStride} * at(first + face * n), kTileStride);
  }
}

template <bool kFours, class D, class Sink>
HWY_INLINE void storeStage(D d, const hn::Vec<D>* out, int n, const StageTarget& stage, std::int32_t face, float* own,
                           Sink& sink) {
  if (stage.kept >= 0) keep<kFours>(d, out, n, stage.kept, face, own);
  if (stage.wanted) sink.put(d, out, n, stage.outputs, face);
}

/// Faces `face`, face + K, .. as long as there are K more before `end`, whose matrix is the same at all stages. Returns
/// the first that is left.
template <CirculantForm kForm, int N, bool kFours, class D, class Sink>
HWY_INLINE std::int32_t evolve(D d, const StepFaces& faces, std::int32_t face, std::int32_t end, Sink& sink) {
  const Circulant<kForm, N, D> kernel(d, faces.weights[0]);
  float* const own = faces.own;
  const StageTarget* const first = faces.targets;
  const StageTarget* const last = first + faces.stages - 1;
  const TilePoint* index = faces.index + at(face) * N;
  for (; face + kBlocks<D> <= end; face += kBlocks<D>, index += kBlocks<D> * N) {
    hn::Vec<D> p[N];
    hn::Vec<D> out[N];
    HWY_UNROLL(8)
    for (int i = 0; i < N; ++i) p[i] = loadOwn(d, own, index + i, N);
    for (const StageTarget* stage = first;; ++stage) {
      kernel(p, out);
      storeStage<kFours>(d, out, N, *stage, face, own, sink);
      if (stage == last) break;
      HWY_UNROLL(8)
      for (int i = 0; i < N; ++i) p[i] = out[i];
    }
  }
  return face;
}

template <CirculantForm kForm, int N, class Sink>
void facesOfForm(const StepFaces& faces, Sink& sink) {
  std::int32_t face = evolve<kForm, N, true>(Wide(), faces, 0, faces.targets[0].fours, sink);
  face = evolve<kForm, N, false>(Wide(), faces, face, faces.step.count, sink);
  evolve<kForm, N, false>(Block(), faces, face, faces.step.count, sink);
}

/// Faces of any number of sides, or with weights of their own at each stage: one at a time.
template <class Sink>
void facesOfAnyKind(const StepFaces& faces, Sink& sink) {
  const Block d;
  const int n = faces.step.width;
  BlockVector p[Far::kLargestCirculant];
  BlockVector out[Far::kLargestCirculant];
  for (std::int32_t face = 0; face < faces.step.count; ++face) {
    for (int i = 0; i < n; ++i) p[i] = loadOwn(d, faces.own, faces.index + face * n + i, 1);
    for (std::int32_t s = 0; s < faces.stages; ++s) {
      switch (faces.step.form) {
        case CirculantForm::quad:
          circulantQuad(WideWeights<Block, 2>(d, faces.weights[s]), p, out);
          break;
        case CirculantForm::hexagon:
          circulantHexagon(WideWeights<Block, 3>(d, faces.weights[s]), p, out);
          break;
        default:
          circulantAnySides(d, faces.weights[s], p, out, n);
      }
      if (face < faces.targets[s].fours) {
        storeStage<true>(d, out, n, faces.targets[s], face, faces.own, sink);
      } else {
        storeStage<false>(d, out, n, faces.targets[s], face, faces.own, sink);
      }
      for (int i = 0; i < n; ++i) p[i] = out[i];
    }
  }
}

template <class Sink>
void facesOf(const StepFaces& faces, Sink& sink) {
  if (!faces.step.sameWeights && faces.stages > 1) return facesOfAnyKind(faces, sink);
  switch (faces.step.form) {
    case CirculantForm::quad:
      return facesOfForm<CirculantForm::quad, 4>(faces, sink);
    case CirculantForm::hexagon:
      return facesOfForm<CirculantForm::hexagon, 6>(faces, sink);
    case CirculantForm::evenOdd:
      if (faces.step.width == 4) return facesOfForm<CirculantForm::evenOdd, 4>(faces, sink);
      if (faces.step.width == 6) return facesOfForm<CirculantForm::evenOdd, 6>(faces, sink);
      if (faces.step.width == 8) return facesOfForm<CirculantForm::evenOdd, 8>(faces, sink);
      break;
    case CirculantForm::direct:
      if (faces.step.width == 3) return facesOfForm<CirculantForm::direct, 3>(faces, sink);
      if (faces.step.width == 5) return facesOfForm<CirculantForm::direct, 5>(faces, sink);
      if (faces.step.width == 7) return facesOfForm<CirculantForm::direct, 7>(faces, sink);
      break;
  }
  facesOfAnyKind(faces, sink);
}

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
                          Sink& sink) {
  if (target.kept >= 0) hn::StoreU(v, d, views.scratch + kTileStride * (target.kept + row));
  if (target.wanted) sink.put(d, &v, 1, target.outputs, row);
}

template <class Sink>
void denseRows(const Far::TileTable& table, const TileStep& step, const Views& views, Sink& sink) {
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
void looseRows(const Far::TileTable& table, const TileStep& step, const Views& views, Sink& sink) {
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

template <int Width, class Sink>
void evaluate(const Far::TileTable& table, const Far::Tile& tile, const Views& views) {
  Sink sink(views.target, views.stream);
  Kernels::importPoints<Width>(table, tile, views);
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
  sink.finish();
}

void evaluateTile(const Far::TileTable& table, const Far::Tile& tile, const Views& views, std::int32_t length) {
  const bool streams = views.stream != nullptr && views.target.stride == length;
  switch (length) {
    case 1:
      return evaluate<1, DirectSink<Access::one>>(table, tile, views);
    case 2:
      return evaluate<2, DirectSink<Access::two>>(table, tile, views);
    case 3:
      if (streams) return evaluate<3, StreamSink<Access::overlapping>>(table, tile, views);
      if (views.target.stride == 3) return evaluate<3, DirectSink<Access::overlapping>>(table, tile, views);
      return evaluate<3, DirectSink<Access::three>>(table, tile, views);
    default:
      if (streams) return evaluate<4, StreamSink<Access::whole>>(table, tile, views);
      return evaluate<4, DirectSink<Access::whole>>(table, tile, views);
  }
}

template <class Sink>
void tileNormals(const Far::TileTable& table, std::int32_t tile, const float* points,
                 const Kernels::NormalViews<float>& views) {
  if (table.normalKind == Far::TileNormalKind::exact) return limitNormals<Sink>(table, tile, points, views);
  faceNormals(table.normals, table.normals.tiles[at(tile)], points, views);
  vertexNormals<Sink>(table, table.tiles[at(tile)], views);
}

void evaluateTileNormals(const Far::TileTable& table, std::int32_t tile, const float* points,
                         const Kernels::NormalViews<float>& views) {
  if (views.target.stride != 3) return tileNormals<DirectSink<Access::three>>(table, tile, points, views);
  if (views.stream != nullptr) return tileNormals<StreamSink<Access::overlapping>>(table, tile, points, views);
  tileNormals<DirectSink<Access::overlapping>>(table, tile, points, views);
}

#else

void evaluateTileNormals(const Far::TileTable& table, std::int32_t tile, const float* points,
                         const Kernels::NormalViews<float>& views) {
  Kernels::evaluateTileNormals(table, tile, points, views);
}

void evaluateTile(const Far::TileTable& table, const Far::Tile& tile, const Kernels::TileViews<float>& views,
                  std::int32_t length) {
  switch (length) {
    case 1:
      return Kernels::evaluateTile<1>(table, tile, views);
    case 2:
      return Kernels::evaluateTile<2>(table, tile, views);
    case 3:
      return Kernels::evaluateTile<3>(table, tile, views);
    default:
      return Kernels::evaluateTile<4>(table, tile, views);
  }
}

#endif

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace honeycomb::Osd::Simd {

HWY_EXPORT(evaluateTile);
HWY_EXPORT(evaluateTileNormals);

void evaluateTileNormals(const Far::TileTable& table, std::int32_t tile, const float* points,
                         const Kernels::NormalViews<float>& views) {
  HWY_DYNAMIC_DISPATCH(evaluateTileNormals)(table, tile, points, views);
}

void evaluateTile(const Far::TileTable& table, const Far::Tile& tile, const Kernels::TileViews<float>& views,
                  std::int32_t length) {
  HWY_DYNAMIC_DISPATCH(evaluateTile)(table, tile, views, length);
}

}  // namespace honeycomb::Osd::Simd
#endif
