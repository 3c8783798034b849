#pragma once

#include <cstdint>

namespace honeycomb::Osd {

/// A buffer of points as kernels see it.
template <class Real>
struct View {
  Real* data;  ///< the first value of point 0
  std::int64_t stride;
  /// The first value of point i.
  Real* point(std::int32_t i) const { return data + i * stride; }
};

/// Values of a point handled together: primvars of any length are cut into pieces of at most this many.
constexpr std::int32_t kPiece = 4;

/// A piece of every point of a source and of a target.
template <class Real>
struct Piece {
  View<const Real> in;
  View<Real> out;
  std::int32_t width = 3;         ///< values a point, 1..kPiece
  std::int32_t narrowPoint = -1;  ///< the source point behind whose values the buffer ends before kPiece; -1: none
  bool padded = false;            ///< kPiece values may be written at every target point
  bool streamed = false;          ///< the target is too large to be found in a cache later
};

}  // namespace honeycomb::Osd
