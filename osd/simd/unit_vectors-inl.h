// Vectors made unit, and cross products. Compiled once a Highway target; no include guard but Highway's.
#if defined(HONEYCOMB_OSD_SIMD_UNIT_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_UNIT_VECTORS_INL_H
#undef HONEYCOMB_OSD_SIMD_UNIT_VECTORS_INL_H
#else
#define HONEYCOMB_OSD_SIMD_UNIT_VECTORS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "far/tables/limit_table.h"
#include "far/tables/tile_table.h"
#include "osd/simd/points-inl.h"

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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

/// Does a face with tangent weights `weights`, a | b of FrameBatch, have T1 x T2 = crossOfCorners of its corners?
template <int N>
HWY_INLINE bool areDifferences(const float* weights) {
  if constexpr (N == 4) return std::equal(Far::kQuadSpan.begin(), Far::kQuadSpan.end(), weights);
  if constexpr (N == 6) return std::equal(Far::kHexagonSpan.begin(), Far::kHexagonSpan.end(), weights);
  return false;
}

/// T1 x T2 of faces of four or six corners p whose weights are Far::kQuadSpan or kHexagonSpan, which nobody needs to
/// multiply with.
template <int N, class D>
HWY_INLINE hn::Vec<D> crossOfCorners(D d, const hn::Vec<D>* p) {
  static_assert(N == 4 || N == 6);
  if constexpr (N == 4) return cross(d, p[0] - p[2], p[1] - p[3]);
  if constexpr (N == 6) return cross(d, ((p[0] + p[1]) - p[3]) - p[4], ((p[1] + p[2]) - p[4]) - p[5]);
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

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
