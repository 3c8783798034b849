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
  float* crosses = nullptr;  ///< where T1 x T2 of each face goes, kTileStride apart, if wanted

  StepFaces(const Far::TileTable& table, const TileStep& s, const Kernels::TileViews<float>& views,
            std::int32_t stageCount)
      : step(s), own(views.scratch), index(table.indices.data() + s.firstIndex), stages(stageCount) {
    for (std::int32_t i = 0; i < stages; ++i) {
      targets[i] = Kernels::stageTarget(table, s, i, views.level, views.last);
      weights[i] = table.weightsSingle.data() + table.stages[at(s.firstStage + i)].firstWeight;
    }
    const auto number = static_cast<std::int32_t>(&s - table.steps.data());
    if (views.normals == nullptr || !crossedAtBirth(table, number)) return;
    crosses = views.normals + std::int64_t{kTileStride} * table.normals.born[at(number)].firstNormal;
  }
};

/// Points of the faces of a vector, `face` and those behind it, to where the tile keeps them: as TilePlaces::fours or
/// one face behind the other.
template <bool kFours, class D>
HWY_INLINE void keep(D d, const hn::Vec<D>* out, int n, const StageTarget& stage, std::int32_t face, float* own) {
  if constexpr (kFours) {
    constexpr std::int32_t kStep = kTileStride * Far::kTileFours;
    const std::int32_t among = face % Far::kTileFours;
    float* p = own + std::size_t{kTileStride} * at(stage.kept + (face - among) * n + among);
    HWY_UNROLL(8)
    for (int i = 0; i < n; ++i) hn::StoreU(out[i], d, p + i * kStep);
  } else {
    storeFaces<Access::whole>(d, out, n, own + std::size_t{kTileStride} * at(stage.kept + face * n), kTileStride);
  }
}

/// The same as rings.
template <class D>
HWY_INLINE void keepRings(D d, const hn::Vec<D>* out, int n, const StageTarget& stage, std::int32_t face, float* own) {
  constexpr std::int32_t kStep = kTileStride * Far::kTileFours;
  float* p = own + std::size_t{kTileStride} * at(stage.kept + Far::placesOfRing(face, n).first);
  hn::StoreU(out[n - 1], d, p);
  HWY_UNROLL(8)
  for (int i = 0; i < n; ++i) hn::StoreU(out[i], d, p + (i + 1) * kStep);
}

template <bool kFours, class D, class Sink>
HWY_INLINE void storeStage(D d, const hn::Vec<D>* out, int n, const StageTarget& stage, std::int32_t face, float* own,
                           Sink sink) {
  if (stage.rings) {
    keepRings(d, out, n, stage, face, own);
  } else if (stage.kept >= 0) {
    keep<kFours>(d, out, n, stage, face, own);
  }
  if (stage.wanted) sink.put(d, out, n, stage.outputs, face);
}

/// Faces `face`, face + K, .. as long as there are K more before `end`, whose matrix is the same at all stages. Returns
/// the first that is left.
template <CirculantForm kForm, int N, bool kFours, class D, class Sink>
HWY_INLINE std::int32_t evolve(D d, const StepFaces& faces, std::int32_t face, std::int32_t end, Sink sink) {
  const Circulant<kForm, N, D> kernel(d, faces.weights[0]);
  float* const own = faces.own;
  float* const crosses = faces.crosses;
  const StageTarget* const first = faces.targets;
  const StageTarget* const last = first + faces.stages - 1;
  const TilePoint* index = faces.index + at(face) * N;
  for (; face + kBlocks<D> <= end; face += kBlocks<D>, index += kBlocks<D> * N) {
    hn::Vec<D> p[N];
    hn::Vec<D> out[N];
    HWY_UNROLL(8)
    for (int i = 0; i < N; ++i) p[i] = loadOwn(d, own, index + i, N);
    if constexpr (N == 4 || N == 6) {
      if (crosses != nullptr) hn::StoreU(crossOfCorners<N>(d, p), d, crosses + std::int64_t{kTileStride} * face);
    }
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
void facesOfForm(const StepFaces& faces, Sink sink) {
  std::int32_t face = evolve<kForm, N, true>(Wide(), faces, 0, faces.targets[0].fours, sink);
  face = evolve<kForm, N, false>(Wide(), faces, face, faces.step.count, sink);
  if constexpr (kWideBlocks > 1) evolve<kForm, N, false>(Block(), faces, face, faces.step.count, sink);
}

/// Faces of any number of sides, or with weights of their own at each stage: one at a time.
template <class Sink>
void facesOfAnyKind(const StepFaces& faces, Sink sink) {
  const Block d;
  const int n = faces.step.width;
  BlockVector p[Far::kLargestCirculant];
  BlockVector out[Far::kLargestCirculant];
  for (std::int32_t face = 0; face < faces.step.count; ++face) {
    for (int i = 0; i < n; ++i) p[i] = loadOwn(d, faces.own, faces.index + face * n + i, 1);
    for (std::int32_t s = 0; s < faces.stages; ++s) {
      circulantOfAnyForm(d, faces.step.form, faces.weights[s], p, out, n);
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
