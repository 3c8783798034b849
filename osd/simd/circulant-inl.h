// The forms of circulant faces on vectors: CirculantForm of far/tables/level_table.h, operation by operation. Compiled
// once a Highway target; no include guard but Highway's.
#if defined(HONEYCOMB_OSD_SIMD_CIRCULANT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_CIRCULANT_INL_H
#undef HONEYCOMB_OSD_SIMD_CIRCULANT_INL_H
#else
#define HONEYCOMB_OSD_SIMD_CIRCULANT_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "far/tables/level_table.h"

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The weights of a form, each in every lane: broadcast once a batch.
template <class D, int kCount>
struct WideWeights {
  hn::Vec<D> w[kCount];
  HWY_INLINE WideWeights(D d, const float* form) {
    HWY_UNROLL(16)
    for (int k = 0; k < kCount; ++k) w[k] = hn::Set(d, form[k]);
  }
  HWY_INLINE hn::Vec<D> operator[](int k) const { return w[k]; }
};

/// The same for as many weights as registers never hold: broadcast where they are used.
template <class D>
struct WideWeights<D, 0> {
  D d;
  const float* form;
  HWY_INLINE WideWeights(D tag, const float* first) : d(tag), form(first) {}
  HWY_INLINE hn::Vec<D> operator[](int k) const { return hn::Set(d, form[k]); }
};

/// The N outputs of faces from their N corners, p[i] -> out[i]; as many faces at a time as a vector has blocks. Vectors
/// hold a point of several faces, xyzw each, but any values will do: lanes never meet. N is 3..8 and `sides` the same,
/// or 0 for any number of sides up to Far::kLargestCirculant. Weights: formWeightCount of them; WideWeights<D, 0> if
/// N is 0.
template <int N, class V, class Weights>
HWY_INLINE void circulantDirect(const Weights& c, const V* p, V* out, int sides = N) {
  const int n = N > 0 ? N : sides;
  HWY_UNROLL(8)
  for (int i = 0; i < n; ++i) {
    V sum = c[0] * p[i];
    HWY_UNROLL(8)
    for (int k = 1; k < n; ++k) sum = sum + c[k] * p[i + k < n ? i + k : i + k - n];
    out[i] = sum;
  }
}

template <int N, class V, class Weights>
HWY_INLINE void circulantEvenOdd(const Weights& form, const V* p, V* out, int sides = N) {
  constexpr int kHalf = N > 0 ? N / 2 : Far::kLargestCirculant / 2;
  const int m = N > 0 ? kHalf : sides / 2;
  V q[kHalf];
  V d[kHalf];
  HWY_UNROLL(4)
  for (int j = 0; j < m; ++j) {
    q[j] = p[j] + p[j + m];
    d[j] = p[j] - p[j + m];
  }
  HWY_UNROLL(4)
  for (int i = 0; i < m; ++i) {
    V even = form[0] * q[i];
    V odd = form[m] * d[i];
    HWY_UNROLL(4)
    for (int k = 1; k < m; ++k) {
      const bool wraps = i + k >= m;
      const int j = wraps ? i + k - m : i + k;
      const V term = form[m + k] * d[j];
      even = even + form[k] * q[j];
      odd = wraps ? odd - term : odd + term;
    }
    out[i] = even + odd;
    out[i + m] = even - odd;
  }
}

template <class V, class Weights>
HWY_INLINE void circulantQuad(const Weights& form, const V* p, V* out) {
  const V d0 = p[0] - p[2];
  const V d1 = p[1] - p[3];
  const V s = form[0] * ((p[0] + p[2]) + (p[1] + p[3]));
  const V o0 = form[1] * (d0 + d1);
  const V o1 = form[1] * (d1 - d0);
  out[0] = s + o0;
  out[1] = s + o1;
  out[2] = s - o0;
  out[3] = s - o1;
}

template <class V, class Weights>
HWY_INLINE void circulantHexagon(const Weights& form, const V* p, V* out) {
  const V q[3] = {p[0] + p[3], p[1] + p[4], p[2] + p[5]};
  const V d[3] = {p[0] - p[3], p[1] - p[4], p[2] - p[5]};
  const V s = form[0] * ((q[0] + q[1]) + q[2]);
  const V e[3] = {s - form[1] * q[2], s - form[1] * q[0], s - form[1] * q[1]};
  const V o[3] = {form[2] * (d[0] + d[1]), form[2] * (d[1] + d[2]), form[2] * (d[2] - d[0])};
  HWY_UNROLL(3)
  for (int i = 0; i < 3; ++i) {
    out[i] = e[i] + o[i];
    out[i + 3] = e[i] - o[i];
  }
}

/// The kernel of a form with N known to the compiler and its weights at hand:
///     const Circulant<CirculantForm::hexagon, 6, D> hexagon(d, weights);   once a batch
///     hexagon(p, out);                                                     once for every few faces
template <Far::CirculantForm kForm, int N, class D>
class Circulant {
 public:
  using V = hn::Vec<D>;
  HWY_INLINE Circulant(D d, const float* form) : weights_(d, form) {}

  HWY_INLINE void operator()(const V (&p)[N], V (&out)[N]) const {
    if constexpr (kForm == Far::CirculantForm::direct) circulantDirect<N>(weights_, p, out);
    if constexpr (kForm == Far::CirculantForm::evenOdd) circulantEvenOdd<N>(weights_, p, out);
    if constexpr (kForm == Far::CirculantForm::quad) circulantQuad(weights_, p, out);
    if constexpr (kForm == Far::CirculantForm::hexagon) circulantHexagon(weights_, p, out);
  }

 private:
  WideWeights<D, Far::formWeightCount(kForm, N)> weights_;
};

/// Any number of sides: outputs of the direct form (odd) or the even/odd form (even).
template <class D>
HWY_INLINE void circulantAnySides(D d, const float* form, const hn::Vec<D>* p, hn::Vec<D>* out, int sides) {
  const WideWeights<D, 0> weights(d, form);
  sides % 2 == 0 ? circulantEvenOdd<0>(weights, p, out, sides) : circulantDirect<0>(weights, p, out, sides);
}

/// A form and a number of sides known to the compiler; of N = 0 none is.
template <Far::CirculantForm kWhich, int N>
struct KnownForm {
  static constexpr Far::CirculantForm kForm = kWhich;
  static constexpr int kSides = N;
};

/// Calls body(KnownForm) for faces of `sides` sides and this form.
template <class Body>
HWY_INLINE void forForms(Far::CirculantForm form, [[maybe_unused]] std::int32_t sides, const Body& body) {
  using Far::CirculantForm;
  switch (form) {
    case CirculantForm::quad:
      return body(KnownForm<CirculantForm::quad, 4>{});
    case CirculantForm::hexagon:
      return body(KnownForm<CirculantForm::hexagon, 6>{});
    default:
      break;
  }
#ifndef HONEYCOMB_NARROW_SIMD
  // The form follows from the number of sides.
  switch (sides) {
    case 3:
      return body(KnownForm<CirculantForm::direct, 3>{});
    case 4:
      return body(KnownForm<CirculantForm::evenOdd, 4>{});
    case 5:
      return body(KnownForm<CirculantForm::direct, 5>{});
    case 6:
      return body(KnownForm<CirculantForm::evenOdd, 6>{});
    case 7:
      return body(KnownForm<CirculantForm::direct, 7>{});
    case 8:
      return body(KnownForm<CirculantForm::evenOdd, 8>{});
    default:
      break;
  }
#endif
  body(KnownForm<CirculantForm::direct, 0>{});
}

/// A face of any form and number of sides.
template <class D>
HWY_INLINE void circulantOfAnyForm(D d, Far::CirculantForm form, const float* weights, const hn::Vec<D>* p,
                                   hn::Vec<D>* out, int sides) {
  switch (form) {
    case Far::CirculantForm::quad:
      return circulantQuad(WideWeights<D, 2>(d, weights), p, out);
    case Far::CirculantForm::hexagon:
      return circulantHexagon(WideWeights<D, 3>(d, weights), p, out);
    default:
      return circulantAnySides(d, weights, p, out, sides);
  }
}

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
