// Exact normals of tiles on vectors. Compiled once a Highway target; no include guard but Highway's.
#if defined(HONEYCOMB_OSD_SIMD_TILE_LIMITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_TILE_LIMITS_INL_H
#undef HONEYCOMB_OSD_SIMD_TILE_LIMITS_INL_H
#else
#define HONEYCOMB_OSD_SIMD_TILE_LIMITS_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "osd/simd/points-inl.h"
#include "osd/simd/sinks-inl.h"
#include "osd/simd/tile_normals-inl.h"
#include "osd/tile_normal_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// What the normals of a group of vertices are made of.
struct VertexFrames {
  const Far::TileVertexFrames& group;
  const float* points;   ///< the tile's own
  const float* weights;  ///< of the shape
  const Far::TilePoint* index;
  Kernels::Outputs outputs;
};

/// Of faces `face` .. as many as kTogether vectors of D hold at once; returns the first left. kSides: points a vertex
/// reads, kEach: points of a face, any number if 0.
template <template <int, class> class Weights, int kSides, int kEach, int kTogether, class D, class Sink>
HWY_INLINE std::int32_t facesOfFrames(D d, const VertexFrames frames, Sink sink, std::int32_t face) {
  const int n = kSides > 0 ? kSides : frames.group.sides;
  const int each = kEach > 0 ? kEach : frames.group.each;
  const Weights<kSides, D> w(d, frames.weights, n);
  for (; face + kTogether * kBlocks<D> <= frames.group.count; face += kTogether * kBlocks<D>) {
    hn::Vec<D> v[kTogether * (kEach > 0 ? kEach : Far::kLargestCirculant)];
    for (int t = 0; t < kTogether; ++t) {
      const Far::TilePoint* index = frames.index + at(face + t * kBlocks<D>) * at(each) * at(n);
      HWY_UNROLL(1)
      for (int i = 0; i < each; ++i) {
        v[t * each + i] = spanCross<kSides>(d, w, frames.points, index + i * n, n, at(each) * at(n));
      }
    }
    makeAllUnit(d, v, kTogether * each);
    HWY_UNROLL(2)
    for (int t = 0; t < kTogether; ++t) {
      sink.putInAnyOrder(d, v + t * each, each, frames.outputs, face + t * kBlocks<D>);
    }
  }
  return face;
}

template <template <int, class> class Weights, int kSides, int kEach, class Sink>
void groupOfFrames(const VertexFrames& frames, Sink sink) {
  std::int32_t face = 0;
  const auto upTo = [&](auto d, auto together) HWY_ATTR {
    face = facesOfFrames<Weights, kSides, kEach, decltype(together)::value>(d, frames, sink, face);
  };
  constexpr int kTogether = kUnitTogether<kEach>;
  if constexpr (kTogether > 1) upTo(Crossing(), Int<kTogether>{});
  upTo(Crossing(), Int<1>{});
  upTo(Block(), Int<1>{});
}

/// Points that are not vertices.
template <class Sink>
void zeroVectors(const VertexFrames& frames, Sink sink) {
  const Block d;
  BlockVector zero[Far::kLargestCirculant];
  std::fill_n(zero, frames.group.each, hn::Zero(d));
  for (std::int32_t i = 0; i < frames.group.count; ++i) sink.put(d, zero, frames.group.each, frames.outputs, i);
}

template <class Sink>
void limitNormals(const Far::TileTable& table, std::int32_t tile, const float* points, Sink sink) {
  const Far::TileLimits& limits = table.limits;
  const Far::TileLimits::Range& range = limits.tiles[at(tile)];
  for (std::int32_t b = range.firstFrames; b < range.firstFrames + range.framesCount; ++b) {
    const Far::TileVertexFrames& group = limits.frames[at(b)];
    const VertexFrames frames{group, points, limits.weightsSingle.data() + group.firstWeight,
                              limits.indices.data() + group.firstIndex, Kernels::outputsFrom(table, group.firstOutput)};
    if (group.sides == 0) {
      zeroVectors(frames, sink);
    } else if (group.sides != 6 || !areDifferences<6>(frames.weights + 6)) {
      groupOfFrames<SpanWeights, 0, 0>(frames, sink);
    } else {
      forCommonSides(group.each,
                     [&](auto each) HWY_ATTR { groupOfFrames<Differences, 6, decltype(each)::value>(frames, sink); });
    }
  }
}

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
