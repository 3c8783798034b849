// Exact normals of tiles on vectors. Compiled once a Highway target; no include guard but Highway's.
#if defined(HONEYCOMB_OSD_SIMD_TILE_LIMITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_TILE_LIMITS_INL_H
#undef HONEYCOMB_OSD_SIMD_TILE_LIMITS_INL_H
#else
#define HONEYCOMB_OSD_SIMD_TILE_LIMITS_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "osd/simd/circulant-inl.h"
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

/// Three points in a row of the rings of a vector's neighbours.
template <class D>
struct Window {
  hn::Vec<D> first, second, third;
};

/// Of faces whose windows begin at `window`, `sides` apart.
template <class D>
HWY_INLINE Window<D> loadWindow(D d, const float* points, const Far::TilePoint* window, int sides) {
  constexpr int kStep = Kernels::kTileStride * Far::kTileFours;
  return {loadOwn(d, points, window, at(sides)), loadOwn(d, points + kStep, window, at(sides)),
          loadOwn(d, points + 2 * kStep, window, at(sides))};
}

/// A x B of a vertex's hexagon.
template <class D>
HWY_INLINE hn::Vec<D> ringCross(D d, hn::Vec<D> own, hn::Vec<D> before, const Window<D>& left, const Window<D>& right) {
  const hn::Vec<D> hexagon[6] = {own, before, left.second, left.first, right.third, right.second};
  return crossOfCorners<6>(d, hexagon);
}

/// Normals of the vertices of faces whose points of the level behind are `own`, the first of them face `face`.
template <int N, class D, class Sink>
HWY_INLINE float* ringNormals(D d, const Kernels::RingFaces& faces, const float* points, const hn::Vec<D>* own,
                              std::int32_t face, Sink sink, float* to) {
  constexpr int kMost = N > 0 ? N : Far::kLargestCirculant;
  const int n = N > 0 ? N : faces.step.width;
  const Far::TilePoint* const windows = faces.window + face * n;
  hn::Vec<D> v[kMost];
  const Window<D> first = loadWindow(d, points, windows, n);
  Window<D> left = first;
  HWY_UNROLL(8)
  for (int i = 0; i + 1 < n; ++i) {
    const Window<D> right = loadWindow(d, points, windows + i + 1, n);
    v[i] = ringCross(d, own[i], own[i == 0 ? n - 1 : i - 1], left, right);
    left = right;
  }
  v[n - 1] = ringCross(d, own[n - 1], own[n - 2], left, first);
  makeAllUnit(d, v, n);
  return sink.putNext(d, v, n, to, faces.outputs, face);
}

/// Where the first of a face's points of the last level stands.
HWY_INLINE const float* cornersOfRing(const Kernels::RingFaces& faces, const float* points, std::int32_t face) {
  const Far::FacePlaces places = Far::placesOfFace(Far::TilePlaces::fours, face, faces.step.width);
  return points + std::int64_t{Kernels::kTileStride} * (faces.kept + places.first);
}

/// Faces `face`, face + K, .. as long as there are K more. Returns the first that is left.
template <class Known, class D, class Sink, class Points>
HWY_INLINE std::int32_t ringsOfForm(D d, const Kernels::RingFaces& faces, const float* weights, const float* points,
                                    std::int32_t face, Sink sink, Points written) {
  constexpr int N = Known::kSides;
  constexpr int kStep = Kernels::kTileStride * Far::kTileFours;
  const Circulant<Known::kForm, N, D> form(d, weights);
  const auto body = [&](std::int32_t g, float*& to, float*& pointsTo) HWY_ATTR {
    const float* const corners = cornersOfRing(faces, points, g);
    hn::Vec<D> p[N], own[N];
    HWY_UNROLL(8)
    for (int i = 0; i < N; ++i) p[i] = hn::LoadU(d, corners + i * kStep);
    pointsTo = written.putNext(d, p, N, pointsTo, faces.outputs, g);
    form(p, own);
    to = ringNormals<N>(d, faces, points, own, g, sink, to);
  };
  return forVectors<kBlocks<D>>(&faces.outputs, N, face, faces.step.count, sink, written, body);
}

/// Faces of any number of sides, one at a time.
template <class Sink, class Points>
void ringsOfAnyForm(const Kernels::RingFaces& faces, const float* weights, const float* points, Sink sink,
                    Points written) {
  const Block d;
  const int n = faces.step.width;
  const auto body = [&](std::int32_t face, float*& to, float*& pointsTo) HWY_ATTR {
    const float* const corners = cornersOfRing(faces, points, face);
    BlockVector p[Far::kLargestCirculant], own[Far::kLargestCirculant];
    for (int i = 0; i < n; ++i) p[i] = hn::Load(d, corners + i * Kernels::kTileStride * Far::kTileFours);
    pointsTo = written.putNext(d, p, n, pointsTo, faces.outputs, face);
    circulantOfAnyForm(d, faces.step.form, weights, p, own, n);
    to = ringNormals<0>(d, faces, points, own, face, sink, to);
  };
  forVectors<1>(&faces.outputs, n, 0, faces.step.count, sink, written, body);
}

template <class Sink, class Points>
void ringNormalsOf(const Far::TileTable& table, const Far::TileRings& rings, const float* points, Sink sink,
                   Points written) {
  const Kernels::RingFaces faces = Kernels::ringFaces(table, rings);
  const float* const weights = table.weightsSingle.data() + rings.firstWeight;
  forForms(faces.step.form, faces.step.width, [&](auto known) HWY_ATTR {
    using Known = decltype(known);
    if constexpr (Known::kSides > 0) {
      using Wide = HWY_CAPPED(float, 16);
      const std::int32_t face = ringsOfForm<Known>(Wide(), faces, weights, points, 0, sink, written);
      if constexpr (kBlocks < Wide >> 1) ringsOfForm<Known>(Block(), faces, weights, points, face, sink, written);
    } else {
      ringsOfAnyForm(faces, weights, points, sink, written);
    }
  });
}

/// `written`: where the points of rings go, too.
template <class Sink, class Points>
void limitNormals(const Far::TileTable& table, std::int32_t tile, const float* points, Sink sink, Points written) {
  const Far::TileLimits& limits = table.limits;
  const Far::TileLimits::Range& range = limits.tiles[at(tile)];
  for (std::int32_t b = range.first; b < range.first + range.count; ++b) {
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
  const Far::TileLimits::Range& rings = limits.ringTiles[at(tile)];
  for (const Far::TileRings& some : std::span(limits.rings).subspan(at(rings.first), at(rings.count))) {
    ringNormalsOf(table, some, points, sink, written);
  }
}

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
