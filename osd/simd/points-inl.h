// Points in and out of vectors of K blocks of four lanes, a point's up to four values in a block. Compiled once a
// Highway target; no include guard but Highway's.
//     lane    0 1 2 3   4 5 6 7   ...
//     point   x y z w   x y z w         block k: the point of face (or row) k
#if defined(HONEYCOMB_OSD_SIMD_POINTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_POINTS_INL_H
#undef HONEYCOMB_OSD_SIMD_POINTS_INL_H
#else
#define HONEYCOMB_OSD_SIMD_POINTS_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "osd/simd/point_access.h"
#include "osd/simd/targets.h"

#if HONEYCOMB_HAS_VECTORS
HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Block = hn::FixedTag<float, 4>;  ///< one point
using BlockVector = hn::Vec<Block>;

/// K: the points a vector of D holds.
template <class D>
constexpr int kBlocks = static_cast<int>(hn::MaxLanes(D())) / 4;

/// The point at p. Lanes that it has no values for hold what lies behind it (Access::whole, overlapping, three: four
/// floats are read) or zero.
template <Access kAccess>
HWY_INLINE BlockVector loadPoint(const float* p) {
  if constexpr (kAccess == Access::one) {
    const hn::FixedTag<float, 2> pair;
    return hn::ZeroExtendVector(Block(), hn::ZeroExtendVector(pair, hn::LoadU(hn::FixedTag<float, 1>(), p)));
  } else if constexpr (kAccess == Access::two) {
    return hn::ZeroExtendVector(Block(), hn::LoadU(hn::FixedTag<float, 2>(), p));
  } else {
    return hn::LoadU(Block(), p);
  }
}

/// Points index[0], index[step], .. index[(K-1) step] of a buffer whose point i is at data + i*stride.
template <Access kAccess, class D>
HWY_INLINE hn::Vec<D> loadPoints([[maybe_unused]] D d, const float* data, std::int64_t stride,
                                 const std::int32_t* index, std::int64_t step) {
  if constexpr (kBlocks<D> == 1) {
    return loadPoint<kAccess>(data + index[0] * stride);
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, loadPoints<kAccess>(half, data, stride, index + kBlocks<D> / 2 * step, step),
                       loadPoints<kAccess>(half, data, stride, index, step));
  }
}

/// Block k of a vector.
template <int k, class D>
HWY_INLINE BlockVector blockOf([[maybe_unused]] D d, hn::Vec<D> v) {
  if constexpr (kBlocks<D> == 1) {
    return v;
  } else {
    const hn::Half<D> half;
    if constexpr (k < kBlocks<D> / 2) {
      return blockOf<k>(half, hn::LowerHalf(half, v));
    } else {
      return blockOf<k - kBlocks<D> / 2>(half, hn::UpperHalf(half, v));
    }
  }
}

/// Writes a point's values to p. Access::whole, streamed and overlapping write four floats. Streamed ones reach other
/// threads by hwy::FlushStream().
template <Access kAccess>
HWY_INLINE void storePoint(BlockVector v, float* p) {
  const hn::FixedTag<float, 1> one;
  const hn::FixedTag<float, 2> two;
  if constexpr (kAccess == Access::whole || kAccess == Access::overlapping) {
    hn::StoreU(v, Block(), p);
  } else if constexpr (kAccess == Access::streamed) {
    hn::Stream(v, Block(), p);
  } else if constexpr (kAccess == Access::one) {
    hn::StoreU(hn::LowerHalf(one, hn::LowerHalf(two, v)), one, p);
  } else {
    hn::StoreU(hn::LowerHalf(two, v), two, p);
    if constexpr (kAccess == Access::three) hn::StoreU(hn::LowerHalf(one, hn::UpperHalf(two, v)), one, p + 2);
  }
}

/// The outputs of K faces of n sides, which follow each other: block k of out[i] to p + (k*n + i) * stride. In
/// ascending order, so that Access::overlapping leaves only the float behind the last point undone.
template <Access kAccess, int k = 0, class D>
HWY_INLINE void storeFaces(D d, const hn::Vec<D>* out, int n, float* p, std::int64_t stride) {
  if constexpr (k < kBlocks<D>) {
    HWY_UNROLL(8)
    for (int i = 0; i < n; ++i) storePoint<kAccess>(blockOf<k>(d, out[i]), p + i * stride);
    storeFaces<kAccess, k + 1>(d, out, n, p + n * stride, stride);
  }
}

/// Is `wanted` among `count` numbers?
HWY_INLINE bool contains(const std::int32_t* numbers, std::int64_t count, std::int32_t wanted) {
  const hn::FixedTag<std::int32_t, 4> d;
  const auto same = hn::Set(d, wanted);
  std::int64_t i = 0;
  auto found = hn::MaskFromVec(hn::Zero(d));
  for (; i + 4 <= count; i += 4) found = hn::Or(found, hn::LoadU(d, numbers + i) == same);
  bool any = !hn::AllFalse(d, found);
  for (; i < count; ++i) any = any || numbers[i] == wanted;
  return any;
}

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
