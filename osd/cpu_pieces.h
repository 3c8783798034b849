#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <type_traits>

#include "far/base/result.h"
#include "osd/buffer_descriptor.h"
#include "osd/piece.h"

/// What evaluators on the CPU have in common: numbers made known to the compiler, and checks of buffers.
namespace honeycomb::Osd {

template <int N>
using Int = std::integral_constant<int, N>;

/// Calls body(Int<Width>) with the width of a piece.
template <class Body>
void forPieceWidth(std::int32_t width, const Body& body) {
  switch (width) {
    case 1:
      return body(Int<1>{});
    case 2:
      return body(Int<2>{});
    case 3:
      return body(Int<3>{});
    default:
      return body(Int<4>{});
  }
}

/// Calls body(Int<N>) with N = sides where a kernel is specialised for it, else 0.
template <class Body>
void forSides(std::int32_t sides, const Body& body) {
  switch (sides) {
    case 3:
      return body(Int<3>{});
    case 4:
      return body(Int<4>{});
    case 5:
      return body(Int<5>{});
    case 6:
      return body(Int<6>{});
    case 7:
      return body(Int<7>{});
    case 8:
      return body(Int<8>{});
    default:
      return body(Int<0>{});
  }
}

/// Are both buffers large enough for so many points, of the same length?
template <class Real>
Result<void> checkPoints(const Points<Real>& source, std::int64_t sourceCount, const PointsOut<Real>& target,
                         std::int64_t targetCount) {
  if (auto ok = checkDescriptor(source.desc, static_cast<std::int64_t>(source.data.size()), sourceCount, "source");
      !ok) {
    return ok;
  }
  if (auto ok = checkDescriptor(target.desc, static_cast<std::int64_t>(target.data.size()), targetCount, "target");
      !ok) {
    return ok;
  }
  if (source.desc.length != target.desc.length) {
    return fail(ErrorCode::invalidOption,
                fmt::format("source and target differ in length, {} and {}", source.desc.length, target.desc.length));
  }
  return {};
}

/// Can these points have normals, and is there room for so many?
template <class Real>
Result<void> checkNormals(const Points<Real>& points, const PointsOut<Real>& normals, std::int64_t count) {
  if (points.desc.length < 3 || points.desc.length > kPiece || normals.desc.length != 3) {
    return fail(ErrorCode::invalidOption, "normals (length 3) are of positions: points of length 3 or 4");
  }
  return checkDescriptor(normals.desc, static_cast<std::int64_t>(normals.data.size()), count, "normals");
}

template <class Real>
View<const Real> viewOf(const Points<Real>& points) {
  return {points.data.data() + points.desc.offset, points.desc.stride};
}
/// Without data where there is no buffer.
template <class Real>
View<Real> viewOf(const PointsOut<Real>& points) {
  if (points.data.empty()) return {nullptr, 0};
  return {points.data.data() + points.desc.offset, points.desc.stride};
}

}  // namespace honeycomb::Osd
