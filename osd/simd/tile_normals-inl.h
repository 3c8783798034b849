// Fast normals of tiles on vectors. Compiled once a Highway target; no include guard but Highway's.
#if defined(HONEYCOMB_OSD_SIMD_TILE_NORMALS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_TILE_NORMALS_INL_H
#undef HONEYCOMB_OSD_SIMD_TILE_NORMALS_INL_H
#else
#define HONEYCOMB_OSD_SIMD_TILE_NORMALS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "osd/cpu_pieces.h"
#include "osd/simd/points-inl.h"
#include "osd/simd/sinks-inl.h"
#include "osd/tile_normal_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Calls body(Int<N>) where N = sides is common enough for kernels of its own (the faces of quads and what becomes of
/// their vertices), else body(Int<0>).
template <class Body>
HWY_INLINE void forCommonSides(std::int32_t sides, const Body& body) {
  switch (sides) {
    case 6:
      return body(Int<6>{});
#ifndef HONEYCOMB_NARROW_SIMD
    case 4:
      return body(Int<4>{});
    case 8:
      return body(Int<8>{});
#endif
    default:
      return body(Int<0>{});
  }
}

/// (y z x w) of each block.
template <class D>
HWY_INLINE hn::Vec<D> turnedOnce(D d, hn::Vec<D> v) {
  const hn::Repartition<std::uint8_t, D> bytes;
  alignas(16) static constexpr std::uint8_t kTurn[16] = {4, 5, 6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 12, 13, 14, 15};
  return hn::BitCast(d, hn::TableLookupBytes(hn::BitCast(bytes, v), hn::LoadDup128(bytes, kTurn)));
}

/// a x b, with the operations of Kernels::unitNormal: found as (z x y), then turned, which is one turn less.
template <class D>
HWY_INLINE hn::Vec<D> cross(D d, hn::Vec<D> a, hn::Vec<D> b) {
  return turnedOnce(d, (a * turnedOnce(d, b) - turnedOnce(d, a) * b) + hn::Zero(d));
}

/// The squares of the lengths of the blocks of one to four vectors: lane i of a block is that of v[i].
template <int kCount, class D>
HWY_INLINE hn::Vec<D> squareLengths(D d, const hn::Vec<D>* v) {
  const hn::Repartition<double, D> pairs;
  const auto both = [&](auto a, auto b) {
    return hn::InterleaveLower(pairs, hn::BitCast(pairs, a), hn::BitCast(pairs, b));
  };
  const auto a = v[kCount > 1 ? 1 : 0];
  const auto b = v[kCount > 2 ? 2 : 0];
  const auto c = v[kCount > 3 ? 3 : 0];
  const auto xy01 = hn::InterleaveLower(d, v[0], a);
  const auto xy23 = hn::InterleaveLower(d, b, c);
  const auto x = hn::BitCast(d, both(xy01, xy23));
  const auto y = hn::BitCast(d, hn::InterleaveUpper(pairs, hn::BitCast(pairs, xy01), hn::BitCast(pairs, xy23)));
  const auto z = hn::BitCast(d, both(hn::InterleaveUpper(d, v[0], a), hn::InterleaveUpper(d, b, c)));
  return (x * x + y * y) + z * z;
}

/// v[i] * (lane i of r), the zero vector where that lane is 0; `sound`: none is.
template <int kLane, int kCount, class D>
HWY_INLINE void scale(D d, hn::Vec<D>* v, hn::Vec<D> r, bool sound) {
  const auto own = hn::Broadcast<kLane>(r);
  v[kLane] = sound ? v[kLane] * own : hn::IfThenElseZero(own != hn::Zero(d), v[kLane] * own);
  if constexpr (kLane + 1 < kCount) scale<kLane + 1, kCount>(d, v, r, sound);
}

/// Makes the blocks of one to four vectors unit, those too short or not finite zero. Root and division are slow, so
/// that they do all at once.
template <int kCount, class D>
HWY_INLINE void makeUnit(D d, hn::Vec<D>* v) {
  const auto q = squareLengths<kCount>(d, v);
  const auto sound =
      hn::And(q >= hn::Set(d, std::numeric_limits<float>::min()), q <= hn::Set(d, std::numeric_limits<float>::max()));
  const auto r = hn::Set(d, 1.0f) / hn::Sqrt(q);
  if (HWY_LIKELY(hn::AllTrue(d, sound))) {
    scale<0, kCount>(d, v, r, true);
  } else {
    scale<0, kCount>(d, v, hn::IfThenElseZero(sound, r), false);
  }
}

/// The same for any number of vectors.
template <class D>
HWY_INLINE void makeAllUnit(D d, hn::Vec<D>* v, int count) {
  int i = 0;
  for (; i + 4 <= count; i += 4) makeUnit<4>(d, v + i);
  for (; i + 2 <= count; i += 2) makeUnit<2>(d, v + i);
  if (i < count) makeUnit<1>(d, v + i);
}

/// The rows a | b of FrameBatch for faces of N sides, each weight in every lane; any number of sides if N is 0.
template <int N, class D>
struct SpanWeights {
  hn::Vec<D> a[N], b[N];
  HWY_INLINE SpanWeights(D d, const float* w, int) {
    HWY_UNROLL(8)
    for (int j = 0; j < N; ++j) {
      a[j] = hn::Set(d, w[N + j]);
      b[j] = hn::Set(d, w[2 * N + j]);
    }
  }
  HWY_INLINE hn::Vec<D> first(int j) const { return a[j]; }
  HWY_INLINE hn::Vec<D> second(int j) const { return b[j]; }
};
template <class D>
struct SpanWeights<0, D> {
  D d;
  const float* w;
  int n;
  HWY_INLINE SpanWeights(D tag, const float* weights, int sides) : d(tag), w(weights), n(sides) {}
  HWY_INLINE hn::Vec<D> first(int j) const { return hn::Set(d, w[n + j]); }
  HWY_INLINE hn::Vec<D> second(int j) const { return hn::Set(d, w[2 * n + j]); }
};

/// Stands for the weights of Far::kQuadSpan and kHexagonSpan, which nobody needs to multiply with.
template <int N, class D>
struct Differences {
  HWY_INLINE Differences(D, const float*, int) {}
};

/// Is that what `weights` are?
template <int N>
HWY_INLINE bool areDifferences(const float* weights) {
  if constexpr (N == 4) return std::equal(Far::kQuadSpan.begin(), Far::kQuadSpan.end(), weights + N);
  if constexpr (N == 6) return std::equal(Far::kHexagonSpan.begin(), Far::kHexagonSpan.end(), weights + N);
  return false;
}

/// A x B of the K faces whose n corners begin at `index`, `step` apart.
template <int N, class D>
HWY_INLINE hn::Vec<D> spanCross(D d, const SpanWeights<N, D>& w, const float* points, const Far::TilePoint* index,
                                int n, std::size_t step) {
  const auto p = loadOwn(d, points, index, step);
  auto a = w.first(0) * p;
  auto b = w.second(0) * p;
  HWY_UNROLL(8)
  for (int j = 1; j < n; ++j) {
    const auto q = loadOwn(d, points, index + j, step);
    a = a + w.first(j) * q;
    b = b + w.second(j) * q;
  }
  return cross(d, a, b);
}

template <int N, class D>
HWY_INLINE hn::Vec<D> spanCross(D d, const Differences<N, D>&, const float* points, const Far::TilePoint* index, int,
                                std::size_t step) {
  hn::Vec<D> p[N];
  HWY_UNROLL(8)
  for (int j = 0; j < N; ++j) p[j] = loadOwn(d, points, index + j, step);
  if constexpr (N == 4) return cross(d, p[0] - p[2], p[1] - p[3]);
  if constexpr (N == 6) return cross(d, ((p[0] + p[1]) - p[3]) - p[4], ((p[1] + p[2]) - p[4]) - p[5]);
}

/// Normals of faces g .. of a batch, as many as vectors of D hold at once, kAtOnce vectors at a time. Returns the first
/// face left. N: their sides, or 0. Weights: SpanWeights or Differences.
template <template <int, class> class Weights, int N, int kAtOnce, class D>
HWY_INLINE std::int32_t frameNormals(D d, const Far::TileFrames& frames, const float* weights,
                                     const Far::TilePoint* index, const float* points, float* normals, std::int32_t g) {
  const int n = N > 0 ? N : frames.sides;
  const Weights<N, D> w(d, weights, n);
  for (; g + kAtOnce * kBlocks<D> <= frames.count; g += kAtOnce * kBlocks<D>) {
    hn::Vec<D> v[kAtOnce];
    HWY_UNROLL(4)
    for (int i = 0; i < kAtOnce; ++i) {
      v[i] = spanCross<N>(d, w, points, index + (g + i * kBlocks<D>)*n, n, at(n));
    }
    makeUnit<kAtOnce>(d, v);
    HWY_UNROLL(4)
    for (int i = 0; i < kAtOnce; ++i) hn::StoreU(v[i], d, normals + Kernels::kTileStride * (g + i * kBlocks<D>));
  }
  return g;
}

template <template <int, class> class Weights, int N>
void normalsOfFrames(const Far::TileFrames& frames, const float* w, const Far::TilePoint* index, const float* points,
                     float* normals) {
  std::int32_t g = frameNormals<Weights, N, 4>(HWY_CAPPED(float, 16)(), frames, w, index, points, normals, 0);
  g = frameNormals<Weights, N, 4>(Block(), frames, w, index, points, normals, g);
  frameNormals<Weights, N, 1>(Block(), frames, w, index, points, normals, g);
}

HWY_INLINE void faceNormals(const Far::TileNormals& table, const Far::TileNormalRange& tile, const float* points,
                            const Kernels::NormalViews<float>& views) {
  float* normals = views.scratch;
  for (std::int32_t i = 0; i < tile.importCount; ++i, normals += Kernels::kTileStride) {
    const float* from = views.shared.point(table.imports[at(tile.firstImport + i)]);
    std::copy_n(from, 3, normals);
    normals[3] = 0;
  }
  for (std::int32_t b = tile.firstFrames; b < tile.firstFrames + tile.framesCount; ++b) {
    const Far::TileFrames& frames = table.frames[at(b)];
    const float* w = table.weightsSingle.data() + frames.firstWeight;
    const Far::TilePoint* index = table.indices.data() + frames.firstIndex;
    forCommonSides(frames.sides, [&](auto sides) {
      constexpr int kSides = decltype(sides)::value;
      if constexpr (kSides == 4 || kSides == 6) {
        if (areDifferences<kSides>(w)) return normalsOfFrames<Differences, kSides>(frames, w, index, points, normals);
      }
      normalsOfFrames<SpanWeights, kSides>(frames, w, index, points, normals);
    });
    normals += Kernels::kTileStride * frames.count;
  }
}

/// Vectors of faces made unit together, so that those of hexagons are whole fours.
template <int N>
constexpr int kUnitTogether = N == 6 ? 2 : 1;

/// Normals of the outputs of the faces of a step, kTogether vectors of faces at a time; N sides, or any number if 0.
/// Returns the first face left.
template <int N, int kTogether, class D, class Sink>
HWY_INLINE std::int32_t cornerNormals(D d, const Far::TileStep& step, const Far::TilePoint* faces, int neighbours,
                                      const Kernels::Outputs outputs, const float* normals, Sink sink, std::int32_t g) {
  const int n = N > 0 ? N : step.width;
  const std::size_t stride = at(1 + n * neighbours);
  for (; g + kTogether * kBlocks<D> <= step.count; g += kTogether * kBlocks<D>) {
    hn::Vec<D> v[kTogether * (N > 0 ? N : Far::kLargestCirculant)];
    HWY_UNROLL(2)
    for (int t = 0; t < kTogether; ++t) {
      const Far::TilePoint* index = faces + at(g + t * kBlocks<D>) * stride;
      const auto own = loadOwn(d, normals, index++, stride);
      const auto twice = own + own;
      HWY_UNROLL(8)
      for (int i = t * n; i < (t + 1) * n; ++i) {
        v[i] = twice + loadOwn(d, normals, index++, stride);
        if (neighbours > 1) v[i] = v[i] + loadOwn(d, normals, index++, stride);
      }
    }
    makeAllUnit(d, v, kTogether * n);
    HWY_UNROLL(2)
    for (int t = 0; t < kTogether; ++t) sink.put(d, v + t * n, n, outputs, g + t * kBlocks<D>);
  }
  return g;
}

template <int N, class Sink>
void stepCornerNormals(const Far::TileStep& step, const Far::TilePoint* faces, int neighbours,
                       const Kernels::Outputs& outputs, const float* normals, Sink sink) {
  std::int32_t g = 0;
  const auto upTo = [&](auto d, auto together) HWY_ATTR {
    g = cornerNormals<N, decltype(together)::value>(d, step, faces, neighbours, outputs, normals, sink, g);
  };
  if constexpr (N > 0) {
    using Wide = HWY_CAPPED(float, 16);
    constexpr int kTogether = kUnitTogether<N>;
    upTo(Wide(), Int<kTogether>{});
    if constexpr (kTogether > 1) upTo(Wide(), Int<1>{});
  }
  upTo(Block(), Int<1>{});
}

template <class Sink>
void rowNormals(const Far::TileStep& step, const Far::TilePoint* faces, const Kernels::Outputs& outputs,
                const float* normals, Sink sink) {
  const Block d;
  for (std::int32_t r = 0; r < step.count; ++r) {
    const std::int32_t count = *faces++;
    auto sum = hn::Zero(d);
    if (count > 0) sum = loadOwn(d, normals, faces, 1);
    for (std::int32_t i = 1; i < count; ++i) sum = sum + loadOwn(d, normals, faces + i, 1);
    makeUnit<1>(d, &sum);
    sink.put(d, &sum, 1, outputs, r);
    faces += count;
  }
}

template <class Sink>
void vertexNormals(const Far::TileTable& table, const Far::Tile& tile, const Kernels::NormalViews<float>& views,
                   Sink sink) {
  for (std::int32_t s = tile.firstStep; s < tile.firstStep + tile.stepCount; ++s) {
    if (table.normals.firstFace[at(s)] < 0) continue;
    const Far::TileStep& step = table.steps[at(s)];
    const Kernels::Outputs outputs = Kernels::lastOutputs(table, step);
    const Far::TilePoint* faces = table.normals.faces.data() + table.normals.firstFace[at(s)];
    const int neighbours = table.normals.neighbours;
    if (step.kind != Far::TileStep::Kind::circulant) {
      rowNormals(step, faces, outputs, views.scratch, sink);
    } else {
      forCommonSides(step.width, [&](auto sides) HWY_ATTR {
        stepCornerNormals<decltype(sides)::value>(step, faces, neighbours, outputs, views.scratch, sink);
      });
    }
  }
}

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
