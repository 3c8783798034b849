#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "far/tables/refinement.h"

namespace honeycomb::Far {

/// An axis-aligned box; low > high (infinities) when it holds nothing.
template <class Real>
struct Box {
  std::array<Real, 3> low;
  std::array<Real, 3> high;
  bool empty() const { return !(low[0] <= high[0]); }
};

/// The box of points whose x y z stand `stride` numbers apart, from the first: 3 or more; a tail shorter than three
/// numbers is no point. Coordinates that are not numbers are passed over. Linear, parallel.
template <class Real>
Box<Real> bounds(std::span<const Real> points, std::int32_t stride = 3);

/// Is it certain that all weights of all levels are non-negative (as with the paper's tension at t = 1/2)? Then every
/// refined point lies in the convex hull of the control points, so that the box of the control points, a handful of
/// numbers a frame, bounds every level and the limit surface. Half faces of more than kLargestCirculant / 2 sides leave
/// it open: false.
bool isConvex(const Refinement& refinement);

}  // namespace honeycomb::Far
