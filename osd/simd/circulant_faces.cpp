// Circulant faces on vectors: K faces at a time, corner i of each in one vector.
#include "osd/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "osd/simd/circulant_faces.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway's own first.
#include "osd/simd/circulant-inl.h"
#include "osd/simd/level_kernels.h"
#include "osd/simd/points-inl.h"
#include "osd/simd/run.h"

#if HWY_ONCE
#include <hwy/cache_control.h>

#include "osd/plain_kernels.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

#if HONEYCOMB_HAS_VECTORS

using Faces = hn::ScalableTag<float>;
using FacesVector = hn::Vec<Faces>;
constexpr int kFaces = kBlocks<Faces>;

/// Is the group of faces at `index` one for the plain kernels?
HWY_INLINE bool readsNarrowPoint(const Run& run, const std::int32_t* index, int sides) {
  return run.narrowPoint >= 0 && contains(index, std::int64_t{kFaces} * sides, run.narrowPoint);
}

/// Groups end before the last face where a store of the last point would pass its end.
template <Access kAccess>
HWY_INLINE std::int64_t lastGroup(const Run& run) {
  return run.count - kFaces - (kAccess == Access::overlapping ? 1 : 0);
}

// Runs come by value: stores to points of unknown whereabouts then leave their numbers in registers.
template <Access kAccess, Far::CirculantForm kForm, int N>
Progress facesOf(const Run run) {
  const Faces d;
  const Circulant<kForm, N, Faces> circulant(d, run.weights);
  const std::int32_t* index = run.index;
  float* target = run.target;
  std::int64_t g = 0;
  for (; g <= lastGroup<kAccess>(run); g += kFaces) {
    if (readsNarrowPoint(run, index, N)) return {g, kFaces};
    FacesVector p[N];
    FacesVector out[N];
    HWY_UNROLL(8)
    for (int i = 0; i < N; ++i) p[i] = loadPoints<kAccess>(d, run.source, run.sourceStride, index + i, N);
    circulant(p, out);
    storeFaces<kAccess>(d, out, N, target, run.targetStride);
    index += kFaces * N;
    target += kFaces * N * run.targetStride;
  }
  return {g, run.count - g};
}

template <Access kAccess>
Progress facesOfAnySides(const Run run) {
  const Faces d;
  const std::int32_t* index = run.index;
  float* target = run.target;
  std::int64_t g = 0;
  for (; g <= lastGroup<kAccess>(run); g += kFaces) {
    if (readsNarrowPoint(run, index, run.inputs)) return {g, kFaces};
    FacesVector p[Far::kLargestCirculant];
    FacesVector out[Far::kLargestCirculant];
    for (int i = 0; i < run.inputs; ++i) {
      p[i] = loadPoints<kAccess>(d, run.source, run.sourceStride, index + i, run.inputs);
    }
    circulantAnySides(d, run.weights, p, out, run.inputs);
    storeFaces<kAccess>(d, out, run.inputs, target, run.targetStride);
    index += std::int64_t{kFaces} * run.inputs;
    target += std::int64_t{kFaces} * run.inputs * run.targetStride;
  }
  return {g, run.count - g};
}

template <Access kAccess>
Progress facesBySides(Far::CirculantForm form, const Run& run) {
  using Form = Far::CirculantForm;
  switch (run.inputs) {
    case 3:
      return facesOf<kAccess, Form::direct, 3>(run);
    case 4:
      return form == Form::quad ? facesOf<kAccess, Form::quad, 4>(run) : facesOf<kAccess, Form::evenOdd, 4>(run);
    case 5:
      return facesOf<kAccess, Form::direct, 5>(run);
    case 6:
      return form == Form::hexagon ? facesOf<kAccess, Form::hexagon, 6>(run) : facesOf<kAccess, Form::evenOdd, 6>(run);
    case 7:
      return facesOf<kAccess, Form::direct, 7>(run);
    case 8:
      return facesOf<kAccess, Form::evenOdd, 8>(run);
    default:
      return facesOfAnySides<kAccess>(run);
  }
}

Progress faces(Far::CirculantForm form, const Run& run) {
  switch (run.access) {
    case Access::whole:
      return facesBySides<Access::whole>(form, run);
    case Access::streamed:
      return facesBySides<Access::streamed>(form, run);
    case Access::overlapping:
      return facesBySides<Access::overlapping>(form, run);
    case Access::three:
      return facesBySides<Access::three>(form, run);
    case Access::two:
      return facesBySides<Access::two>(form, run);
    default:
      return facesBySides<Access::one>(form, run);
  }
}

#else

Progress faces(Far::CirculantForm, const Run& run) {
  return {0, run.count};
}

#endif

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace honeycomb::Osd::Simd {

HWY_EXPORT(faces);

void circulantFaces(const Far::LevelTable& table, const Far::CirculantBatch& batch, const Piece<float>& piece,
                    std::int64_t begin, std::int64_t end) {
  const auto vectors = [&](std::int64_t from, std::int64_t count) {
    const Run run{.source = piece.in.data,
                  .sourceStride = piece.in.stride,
                  .narrowPoint = piece.narrowPoint,
                  .access = faceAccessOf(piece),
                  .index = table.indices.data() + batch.firstIndex + from * batch.sides,
                  .weights = table.weightsSingle.data() + batch.firstForm,
                  .target = piece.out.data + (batch.firstOutput + from * batch.sides) * piece.out.stride,
                  .targetStride = piece.out.stride,
                  .count = count,
                  .inputs = batch.sides};
    return HWY_DYNAMIC_DISPATCH(faces)(batch.form, run);
  };
  runBoth(begin, end, vectors,
          [&](std::int64_t from, std::int64_t to) { Plain::circulantFaces(table, batch, piece, from, to); });
}

}  // namespace honeycomb::Osd::Simd
#endif
