// Unit vectors of vertices that follow each other in the target, which leave as whole registers. Compiled once a
// Highway target; no include guard but Highway's.
//     v[q]      x y z w of vertices 4q .. 4q + 3
//     target    x y z x y z ..             48 numbers of sixteen vertices
#if defined(HONEYCOMB_OSD_SIMD_PACKED_UNITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_PACKED_UNITS_INL_H
#undef HONEYCOMB_OSD_SIMD_PACKED_UNITS_INL_H
#else
#define HONEYCOMB_OSD_SIMD_PACKED_UNITS_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "osd/simd/points-inl.h"
#include "osd/simd/unit_vectors-inl.h"
#include "osd/tile_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Packing = HWY_CAPPED(float, 16);

/// Do the registers have room for it? Narrower ones would need as many instructions as point by point.
template <class Sink>
constexpr bool kPacksUnits = kBlocks<Packing> == 4 && Sink::kNumbers == 3;

/// Faces of N sides, a whole number of vectors, whose vertices are whole sixteens.
template <int N>
constexpr int kPackedFaces = 0;
template <>
constexpr int kPackedFaces<4> = 4;
template <>
constexpr int kPackedFaces<6> = 8;
template <>
constexpr int kPackedFaces<8> = 4;
static_assert(3 * 6 * kPackedFaces<6> <= 4 * Far::kLargestCirculant, "Stream's room");

/// Makes the blocks of four vectors unit and writes them to p, 48 numbers.
template <class D>
HWY_INLINE void putPackedUnits(D d, hn::Vec<D>* v, float* p) {
  const hn::RebindToSigned<D> places;
  alignas(64) static constexpr std::int32_t kFrom[16] = {0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15};
  makeUnit<4>(d, v);
  const auto from = hn::IndicesFromVec(d, hn::Load(places, kFrom));
  const auto first = hn::FirstN(d, 12);
  HWY_UNROLL(4)
  for (int q = 0; q < 4; ++q) hn::BlendedStore(hn::TableLookupLanes(v[q], from), first, d, p + 12 * q);
}

/// The unit vectors of kVertices vertices that follow each other, to p. make(Int<j>()): those of j .. j + 3.
template <int kVertices, int kFirst = 0, class D, class Make>
HWY_INLINE void packedUnits(D d, const Make& make, float* p) {
  hn::Vec<D> v[4] = {make(Int<kFirst>{}), make(Int<kFirst + 4>{}), make(Int<kFirst + 8>{}), make(Int<kFirst + 12>{})};
  putPackedUnits(d, v, p + 3 * kFirst);
  if constexpr (kFirst + 16 < kVertices) packedUnits<kVertices, kFirst + 16>(d, make, p);
}

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
