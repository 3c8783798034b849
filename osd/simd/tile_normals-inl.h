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

#include "osd/cpu_pieces.h"
#include "osd/simd/packed_units-inl.h"
#include "osd/simd/points-inl.h"
#include "osd/simd/sinks-inl.h"
#include "osd/simd/unit_vectors-inl.h"
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
  return crossOfCorners<N>(d, p);
}

/// What tangents are crossed on. Measured on AVX-512: 5 % less time than on sixteen lanes, since of the three ports for
/// narrower vectors one is shut while wide ones are under way.
using Crossing = HWY_CAPPED(float, 8);

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
  std::int32_t g = frameNormals<Weights, N, 4>(Crossing(), frames, w, index, points, normals, 0);
  g = frameNormals<Weights, N, 4>(Block(), frames, w, index, points, normals, g);
  frameNormals<Weights, N, 1>(Block(), frames, w, index, points, normals, g);
}

/// Normals of faces of whatever shape.
HWY_INLINE void normalsOfFaces(const Far::TileNormals& table, const Far::TileFrames& frames,
                               const Far::TilePoint* index, const float* points, float* normals) {
  const float* w = table.weightsSingle.data() + frames.firstWeight;
  forCommonSides(frames.sides, [&](auto sides) {
    constexpr int kSides = decltype(sides)::value;
    if constexpr (kSides == 4 || kSides == 6) {
      if (areDifferences<kSides>(w + kSides)) {
        return normalsOfFrames<Differences, kSides>(frames, w, index, points, normals);
      }
    }
    normalsOfFrames<SpanWeights, kSides>(frames, w, index, points, normals);
  });
}

/// Makes `count` vectors unit that follow each other.
HWY_INLINE void makeRowUnit(float* v, std::int32_t count) {
  const Packing d;
  constexpr int kAtOnce = 4 * kBlocks<Packing>;
  std::int32_t i = 0;
  for (; i + kAtOnce <= count; i += kAtOnce, v += kAtOnce * Kernels::kTileStride) {
    hn::Vec<Packing> four[4];
    HWY_UNROLL(4)
    for (int q = 0; q < 4; ++q) four[q] = hn::LoadU(d, v + q * 4 * kBlocks<Packing>);
    makeUnit<4>(d, four);
    HWY_UNROLL(4)
    for (int q = 0; q < 4; ++q) hn::StoreU(four[q], d, v + q * 4 * kBlocks<Packing>);
  }
  const Block one;
  for (; i < count; ++i, v += Kernels::kTileStride) {
    BlockVector single = hn::LoadU(one, v);
    makeUnit<1>(one, &single);
    hn::StoreU(single, one, v);
  }
}

HWY_INLINE void faceNormals(const Far::TileTable& table, std::int32_t number, const float* points,
                            const Kernels::NormalViews<float>& views) {
  const Far::TileNormals& normals = table.normals;
  const Far::TileNormalRange& range = normals.tiles[at(number)];
  const auto to = [&](std::int32_t normal) { return views.scratch + std::int64_t{Kernels::kTileStride} * normal; };
  for (std::int32_t i = 0; i < range.importCount; ++i) {
    std::copy_n(views.shared.point(normals.imports[at(range.firstImport + i)]), 3, to(i));
    to(i)[3] = 0;
  }
  // The kernels of points left T1 x T2 of the faces they had at hand.
  const auto find = [&](const Far::TileFrames& frames, const Far::TileCorners& corners, std::int32_t first,
                        std::int32_t step) HWY_ATTR {
    if (step >= 0) return makeRowUnit(to(first), frames.count);
    normalsOfFaces(normals, frames, corners.indices, points, to(first));
  };
  Kernels::forTileFrames(table, number, find);
}

/// Vectors of faces made unit together, so that those of hexagons are whole fours.
template <int N>
constexpr int kUnitTogether = N == 6 ? 2 : 1;

/// The faces of a step and the normals that their outputs sum.
struct CornerFaces {
  const Far::TileStep& step;
  const Far::TilePoint* faces;  ///< as TileNormals::faces
  int neighbours;
  Kernels::Outputs outputs;
  const float* normals;
};

/// Normals of the outputs of faces g .. end - 1, kTogether vectors of faces at a time; N sides, or any number if 0;
/// kNeighbours of each corner, or any number if 0. Returns the first face left.
template <int N, int kNeighbours, int kTogether, class D, class Sink>
HWY_INLINE std::int32_t cornerNormals(D d, const CornerFaces& corners, Sink sink, std::int32_t g, std::int32_t end) {
  const int n = N > 0 ? N : corners.step.width;
  const int neighbours = kNeighbours > 0 ? kNeighbours : corners.neighbours;
  const std::size_t stride = at(1 + n * neighbours);
  const float* const normals = corners.normals;
  const auto body = [&](std::int32_t face, float*& to, float*) HWY_ATTR {
    hn::Vec<D> v[kTogether * (N > 0 ? N : Far::kLargestCirculant)];
    HWY_UNROLL(2)
    for (int t = 0; t < kTogether; ++t) {
      const Far::TilePoint* index = corners.faces + at(face + t * kBlocks<D>) * stride;
      const auto own = loadOwn(d, normals, index++, stride);
      const auto twice = own + own;
      HWY_UNROLL(8)
      for (int i = t * n; i < (t + 1) * n; ++i) {
        v[i] = twice + loadOwn(d, normals, index++, stride);
        for (int j = 1; j < neighbours; ++j) v[i] = v[i] + loadOwn(d, normals, index++, stride);
      }
    }
    makeAllUnit(d, v, kTogether * n);
    HWY_UNROLL(2)
    for (int t = 0; t < kTogether; ++t) {
      to = sink.putNext(d, v + t * n, n, to, corners.outputs, face + t * kBlocks<D>);
    }
  };
  return forVectors<kTogether * kBlocks<D>>(&corners.outputs, n, g, end, sink, NoSink{}, body);
}

/// The same, as wide as it goes.
template <int N, int kNeighbours, class Sink>
HWY_INLINE std::int32_t wideCornerNormals(const CornerFaces& corners, Sink sink, std::int32_t g, std::int32_t end) {
  using Wide = HWY_CAPPED(float, 16);
  constexpr int kTogether = kUnitTogether<N>;
  if constexpr (N > 0) {
    g = cornerNormals<N, kNeighbours, kTogether>(Wide(), corners, sink, g, end);
    if constexpr (kTogether > 1) g = cornerNormals<N, kNeighbours, 1>(Wide(), corners, sink, g, end);
  }
  return cornerNormals<N, kNeighbours, 1>(Block(), corners, sink, g, end);
}

/// The sums of corners j .. j + 3 of faces of N sides with one neighbour a corner; `face`: the first of them.
template <int N, int j, class D>
HWY_INLINE hn::Vec<D> fourSums(D d, const float* normals, const Far::TilePoint* face) {
  static_assert(j % N == 0 || j % N == 2 || j % N == 4);
  const hn::Half<D> half;
  const auto dup = [&](auto tag, int f) HWY_ATTR { return hn::LoadDup128(tag, ownPoint(normals, face[f * (N + 1)])); };
  const auto own = [&]() HWY_ATTR {
    if constexpr (j / N == (j + 3) / N) {
      return dup(d, j / N);
    } else {
      return hn::Combine(d, dup(half, (j + 3) / N), dup(half, j / N));
    }
  }();
  const auto corner = [](int i) { return j + i + (j + i) / N + 1; };
  const hn::Half<hn::Half<D>> one;
  const auto load = [&](int i) HWY_ATTR { return hn::Load(one, ownPoint(normals, face[corner(i)])); };
  const auto low = hn::Combine(half, load(1), load(0));
  const auto high = hn::Combine(half, load(3), load(2));
  return (own + own) + hn::Combine(d, high, low);
}

/// Where the outputs of eight faces or so follow each other, they leave as whole registers.
template <int N, class Sink>
HWY_INLINE std::int32_t packedCornerNormals(const CornerFaces& corners, Sink sink, std::int32_t g) {
  constexpr int kFaces = kPackedFaces<N>;
  const Packing d;
  const auto body = [&](std::int32_t faces, float*& to, float*) HWY_ATTR {
    if (to == nullptr) {
      wideCornerNormals<N, 1>(corners, sink, faces, faces + kFaces);
      return;
    }
    const Far::TilePoint* face = corners.faces + at(faces) * (N + 1);
    packedUnits<kFaces * N>(
        d, [&](auto j) HWY_ATTR { return fourSums<N, decltype(j)::value>(d, corners.normals, face); }, to);
    to += 3 * kFaces * N;
  };
  return forVectors<kFaces>(&corners.outputs, N, g, corners.step.count, sink, NoSink{}, body);
}

template <int N, class Sink>
void stepCornerNormals(const CornerFaces& corners, Sink sink) {
  const std::int32_t count = corners.step.count;
  std::int32_t g = 0;
  if constexpr (N > 0) {
    if (corners.neighbours == 1) {
      if constexpr (kPacksUnits<Sink>) g = packedCornerNormals<N>(corners, sink, 0);
      wideCornerNormals<N, 1>(corners, sink, g, count);
      return;
    }
  }
  wideCornerNormals<N, 0>(corners, sink, 0, count);
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
    if (step.kind != Far::TileStep::Kind::circulant) {
      rowNormals(step, faces, outputs, views.scratch, sink);
      continue;
    }
    const CornerFaces corners{step, faces, table.normals.neighbours, outputs, views.scratch};
    forCommonSides(step.width, [&](auto sides) HWY_ATTR { stepCornerNormals<decltype(sides)::value>(corners, sink); });
  }
}

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
