// Faces of tiles on vectors, along their chains. Compiled once a Highway target; no include guard but Highway's.
#if defined(HONEYCOMB_OSD_SIMD_TILE_FACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_TILE_FACES_INL_H
#undef HONEYCOMB_OSD_SIMD_TILE_FACES_INL_H
#else
#define HONEYCOMB_OSD_SIMD_TILE_FACES_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "osd/simd/circulant-inl.h"
#include "osd/simd/points-inl.h"
#include "osd/simd/sinks-inl.h"
#include "osd/simd/unit_vectors-inl.h"
#include "osd/tile_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Far::CirculantForm;
using Far::TilePoint;
using Far::TileStep;
using Kernels::kTileStride;
using Kernels::StageTarget;

using Wide = HWY_CAPPED(float, 16);
constexpr int kWideBlocks = kBlocks<Wide>;

constexpr int kMostStages = Far::kMaxLevels + 1;

/// The faces of a step on a tile's own points.
struct StepFaces {
  const TileStep& step;
  float* own;
  const TilePoint* index;
  std::int32_t stages;
  StageTarget targets[kMostStages];
  const float* weights[kMostStages];
  bool fours;
  float* crosses = nullptr;            ///< where T1 x T2 of each face goes, kTileStride apart, if wanted
  const float* spanWeights = nullptr;  ///< and of what: a | b of FrameBatch, null where crossOfCorners does

  StepFaces(const Far::TileTable& table, const TileStep& s, const Kernels::TileViews<float>& views,
            std::int32_t stageCount)
      : step(s),
        own(views.scratch),
        index(table.indices.data() + s.firstIndex),
        stages(stageCount),
        fours(table.places == Far::TilePlaces::fours) {
    for (std::int32_t i = 0; i < stages; ++i) {
      targets[i] = Kernels::stageTarget(table, s, i, views);
      weights[i] = table.weightsSingle.data() + table.stages[at(s.firstStage + i)].firstWeight;
    }
    if (views.normals == nullptr) return;
    const Far::TileNormals& normals = table.normals;
    const Far::TileBorn& born = normals.born[at(&s - table.steps.data())];
    if (born.firstNormal < 0) return;
    crosses = views.normals + std::int64_t{kTileStride} * born.firstNormal;
    const float* const spans = normals.weightsSingle.data() + born.firstWeight + s.width;
    const bool differ = (s.width == 4 && areDifferences<4>(spans)) || (s.width == 6 && areDifferences<6>(spans));
    spanWeights = differ ? nullptr : spans;
  }

  /// Of the stage that is written; null if none is.
  const Kernels::Outputs* outputs() const {
    for (std::int32_t i = 0; i < stages; ++i) {
      if (targets[i].wanted) return &targets[i].outputs;
    }
    return nullptr;
  }
};

/// Corners of the faces of a vector, those of the first at `index`; N sides, or `sides` if 0.
template <int N, bool kPairs, class D>
HWY_INLINE void loadCorners(D d, const float* own, const TilePoint* index, hn::Vec<D>* p, int sides = N) {
  const int n = N > 0 ? N : sides;
  if constexpr (kPairs) {
    HWY_UNROLL(4)
    for (int i = 0; i < n / 2; ++i) {
      p[2 * i] = loadOwn(d, own + kTileStride * Far::kTileFours, index + i, at(n / 2));
      p[2 * i + 1] = loadOwn(d, own, index + i, at(n / 2));
    }
  } else {
    HWY_UNROLL(8)
    for (int i = 0; i < n; ++i) p[i] = loadOwn(d, own, index + i, at(n));
  }
}

/// A x B of faces with corners p and weights a | b.
template <class D>
HWY_INLINE hn::Vec<D> crossOfSpans(D d, const float* w, const hn::Vec<D>* p, int n) {
  auto a = hn::Set(d, w[0]) * p[0];
  auto b = hn::Set(d, w[n]) * p[0];
  HWY_UNROLL(8)
  for (int j = 1; j < n; ++j) {
    a = a + hn::Set(d, w[j]) * p[j];
    b = b + hn::Set(d, w[n + j]) * p[j];
  }
  return cross(d, a, b);
}

/// Points of the faces of a vector, `face` and those behind it, to where the tile keeps them.
template <bool kFours, class D>
HWY_INLINE void keep(D d, const hn::Vec<D>* out, int n, const StageTarget& stage, std::int32_t face, float* own) {
  const Far::TilePlaces places = kFours ? Far::TilePlaces::fours : Far::TilePlaces::faces;
  float* const p = own + std::size_t{kTileStride} * at(stage.kept + Far::placesOfFace(places, face, n).first);
  if constexpr (kFours) {
    constexpr std::int32_t kStep = kTileStride * Far::kTileFours;
    hn::StoreU(out[n - 1], d, p - kStep);
    HWY_UNROLL(8)
    for (int i = 0; i < n; ++i) hn::StoreU(out[i], d, p + i * kStep);
  } else {
    storeFaces<Access::whole>(d, out, n, p, kTileStride);
  }
}

/// `to`: of `sink`, if the stage is written.
template <bool kFours, class D, class Sink>
HWY_INLINE void storeStage(D d, const hn::Vec<D>* out, int n, const StageTarget& stage, std::int32_t face, float* own,
                           Sink sink, float*& to) {
  if (stage.kept >= 0) keep<kFours>(d, out, n, stage, face, own);
  if (stage.wanted) to = sink.putNext(d, out, n, to, stage.outputs, face);
}

/// Faces `face`, face + K, .. of the step as long as there are K more, whose matrix is the same at all stages. Returns
/// the first that is left.
template <CirculantForm kForm, int N, bool kFours, bool kPairs, class D, class Sink>
HWY_INLINE std::int32_t evolve(D d, const StepFaces& faces, std::int32_t face, Sink sink) {
  constexpr int kEach = kPairs ? N / 2 : N;
  const Circulant<kForm, N, D> kernel(d, faces.weights[0]);
  float* const own = faces.own;
  float* const crosses = faces.crosses;
  const StageTarget* const first = faces.targets;
  const StageTarget* const last = first + faces.stages - 1;
  const TilePoint* index = faces.index + at(face) * kEach;
  const auto body = [&](std::int32_t g, float*& to, float*) HWY_ATTR {
    hn::Vec<D> p[N];
    hn::Vec<D> out[N];
    loadCorners<N, kPairs>(d, own, index, p);
    index += kBlocks<D> * kEach;
    if (crosses != nullptr) {
      float* const cross = crosses + std::int64_t{kTileStride} * g;
      if ((N != 4 && N != 6) || faces.spanWeights != nullptr) {
        hn::StoreU(crossOfSpans(d, faces.spanWeights, p, N), d, cross);
      } else if constexpr (N == 4 || N == 6) {
        hn::StoreU(crossOfCorners<N>(d, p), d, cross);
      }
    }
    for (const StageTarget* stage = first;; ++stage) {
      kernel(p, out);
      storeStage<kFours>(d, out, N, *stage, g, own, sink, to);
      if (stage == last) break;
      HWY_UNROLL(8)
      for (int i = 0; i < N; ++i) p[i] = out[i];
    }
  };
  return forVectors<kBlocks<D>>(faces.outputs(), N, face, faces.step.count, sink, NoSink{}, body);
}

template <CirculantForm kForm, int N, bool kFours, bool kPairs, class Sink>
void facesAsPlaced(const StepFaces& faces, Sink sink) {
  const std::int32_t face = evolve<kForm, N, kFours, kPairs>(Wide(), faces, 0, sink);
  if constexpr (kWideBlocks > 1) evolve<kForm, N, kFours, kPairs>(Block(), faces, face, sink);
}

template <CirculantForm kForm, int N, class Sink>
void facesOfForm(const StepFaces& faces, Sink sink) {
  if constexpr (N % 2 == 0) {
    if (faces.step.pairs) return facesAsPlaced<kForm, N, true, true>(faces, sink);
  }
  faces.fours ? facesAsPlaced<kForm, N, true, false>(faces, sink) : facesAsPlaced<kForm, N, false, false>(faces, sink);
}

/// T1 x T2 of a face of any number of sides.
HWY_INLINE BlockVector crossOfAny(Block d, const StepFaces& faces, const BlockVector* p) {
  if (faces.spanWeights != nullptr) return crossOfSpans(d, faces.spanWeights, p, faces.step.width);
  return faces.step.width == 4 ? crossOfCorners<4>(d, p) : crossOfCorners<6>(d, p);
}

/// Faces of any number of sides, or with weights of their own at each stage: one at a time.
template <class Sink>
void facesOfAnyKind(const StepFaces& faces, Sink sink) {
  const Block d;
  const int n = faces.step.width;
  BlockVector p[Far::kLargestCirculant];
  BlockVector out[Far::kLargestCirculant];
  const auto body = [&](std::int32_t face, float*& to, float*) HWY_ATTR {
    if (faces.step.pairs) {
      loadCorners<0, true>(d, faces.own, faces.index + face * (n / 2), p, n);
    } else {
      loadCorners<0, false>(d, faces.own, faces.index + face * n, p, n);
    }
    if (faces.crosses != nullptr) {
      float* const cross = faces.crosses + std::int64_t{kTileStride} * face;
      hn::Store(crossOfAny(d, faces, p), d, cross);
    }
    for (std::int32_t s = 0; s < faces.stages; ++s) {
      circulantOfAnyForm(d, faces.step.form, faces.weights[s], p, out, n);
      if (faces.fours) {
        storeStage<true>(d, out, n, faces.targets[s], face, faces.own, sink, to);
      } else {
        storeStage<false>(d, out, n, faces.targets[s], face, faces.own, sink, to);
      }
      for (int i = 0; i < n; ++i) p[i] = out[i];
    }
  };
  forVectors<1>(faces.outputs(), n, 0, faces.step.count, sink, NoSink{}, body);
}

template <class Sink>
void facesOf(const StepFaces& faces, Sink sink) {
  if (!faces.step.sameWeights && faces.stages > 1) return facesOfAnyKind(faces, sink);
  forForms(faces.step.form, faces.step.width, [&](auto known) HWY_ATTR {
    using Known = decltype(known);
    if constexpr (Known::kSides > 0) {
      facesOfForm<Known::kForm, Known::kSides>(faces, sink);
    } else {
      facesOfAnyKind(faces, sink);
    }
  });
}

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
