#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "far/base/array.h"
#include "far/tables/level_table.h"

namespace honeycomb::Far {

/// Elements (faces, or vertices by their child faces) of one shape: each reads `sides` points and gets a limit
/// position and two vectors that span its tangent plane by the same three weight rows.
///     position = (m_0 p_0 + m_1 p_1) + ...,  A = (a_0 p_0 + a_1 p_1) + ...,  B = (b_0 p_0 + b_1 p_1) + ...
///     p_j = in[indices[firstIndex + g*sides + j]],  weights at firstWeight: m (sides) | a (sides) | b (sides)
/// For a whole N-gon: m_j = 1/N and A, B the tangents T1, T2: a_j = cos(2 pi j/N), b_j = sin(2 pi j/N), by Akleman and
/// Srinivasan's circulant face matrix. Of whole quads and hexagons T1 and T2 are sums of differences of opposite
/// corners d_j = p_j - p_{j+N/2}, and A, B take fewer operations (kQuadSpan, kHexagonSpan):
///     quad      A = d_0 = T1,  B = d_1 = T2
///     hexagon   A = d_0 + d_1,  B = d_1 + d_2;  T1 = A - B/2,  T2 = sqrt(3)/2 B
/// Sums over more than kProjectionBlock points are taken in blocks, as in ProjectedFace.
struct FrameBatch {
  std::int32_t sides = 0;
  std::int32_t count = 0;
  std::int32_t firstIndex = 0;
  std::int32_t firstElement = 0;  ///< in LimitRows::elements
  std::int32_t firstWeight = 0;
};

/// Rows a | b of whole quads. A term whose weight is 0 may be left out, and one of weight 1 or -1 taken as it is: that
/// changes the sign of a zero at most, which n + 0 below takes away.
constexpr std::array<double, 8> kQuadSpan{1, 0, -1, 0, 0, 1, 0, -1};
/// The same of whole hexagons.
constexpr std::array<double, 12> kHexagonSpan{1, 1, 0, -1, -1, 0, 0, 1, 1, 0, -1, -1};

/// Limit positions and unit normals of a set of elements, from the points of one level.
///     normal = A x B with n_x = (A_y B_z - A_z B_y) + 0 and cyclic; q = (x*x + y*y) + z*z;
///     q < FLT_MIN (DBL_MIN in double) or not finite gives the zero vector, else r = 1/sqrt(q), (x r, y r, z r)
struct LimitRows {
  std::int32_t sourceCount = 0;   ///< points read
  std::int32_t elementCount = 0;  ///< results written
  std::vector<FrameBatch> batches;
  Array<std::int32_t> elements;  ///< result index of each element, batch after batch
  Array<std::int32_t> indices;
  Array<double> weights;
  Array<float> weightsSingle;

  template <class Real>
  std::span<const Real> weightsAs() const;
  std::int64_t byteCount() const;
};

template <>
inline std::span<const double> LimitRows::weightsAs<double>() const {
  return weights;
}
template <>
inline std::span<const float> LimitRows::weightsAs<float>() const {
  return weightsSingle;
}

/// Limits of one level. A face's limit is the centroid of its corners, its normal T1 x T2; a vertex's are those of the
/// face it becomes at the next level, so vertices are evaluated by `child` (this level to the next) and then read
/// their child face; a vertex without one (mid-points and fixed corners of the brick boundary, vertices that `eq16`
/// and `drop` leave behind) is found from this level by `verticesHere`.
struct LimitTable {
  LimitRows faces;         ///< reads this level's points; one result a face
  LevelTable child;        ///< this level's points to the next level's
  LimitRows vertices;      ///< reads the next level's points; results by vertex of this level
  LimitRows verticesHere;  ///< reads this level's points; results by vertex of this level
  std::int64_t byteCount() const;
};

}  // namespace honeycomb::Far
