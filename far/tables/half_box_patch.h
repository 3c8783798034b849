#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "far/tables/patch_value.h"

namespace honeycomb::Far {

/// A point of a patch by its three barycentric coordinates, which sum to 1: coordinate i belongs to the corner in the
/// patch's face i.
using Barycentric = std::array<double, 3>;

/// What the limit surface next to a vertex v reads of one of its faces, the N-gon p_0 = v, p_1, .. p_{N-1} taken
/// counter-clockwise from v.
///     slot     0    1    2    3        4        5
///     corner   p_0  p_1  p_2  p_{N-3}  p_{N-2}  p_{N-1}        all corners of a hexagon; of a triangle, twice
/// Of polygons other than hexagons, also the three sums that the stencil of P. Barendrecht, M. Sabin, J. Kosinka, "A
/// bivariate C1 subdivision scheme based on cubic half-box splines", eq 7, reads and refinement keeps up to a factor
/// (1, 1/2, 1/2). So what a step of refinement costs doesn't depend on N.
template <class Value>
struct PatchFace {
  std::int32_t sides = 6;
  std::array<Value, 6> slots{};
  Value mean{};    ///< (1/N) sum_j p_j
  Value cosine{};  ///< sum_j cos(2 pi j/N) p_j
  Value sine{};    ///< sum_j sin(2 pi j/N) p_j
};

/// The faces f_0, f_1, f_2 counter-clockwise round v. Slot 1 of f_i and slot 5 of f_{i-1} are the same neighbour w_i.
template <class Value>
using PatchFaces = std::array<PatchFace<Value>, 3>;

/// The corner of an N-gon in a slot.
constexpr std::int32_t slotCorner(std::int32_t slot, std::int32_t sides) {
  return slot < 3 ? slot % sides : slot + sides - 6;
}

/// A face of `sides` corners p_j = cornerOf(j). Linear in the sides, which are three or more.
template <class Value, class CornerOf>
PatchFace<Value> gatherPatchFace(std::int32_t sides, const CornerOf& cornerOf) {
  PatchFace<Value> face;
  face.sides = sides;
  for (std::int32_t slot = 0; slot < 6; ++slot) {
    face.slots[static_cast<std::size_t>(slot)] = cornerOf(slotCorner(slot, sides));
  }
  if (sides == 6) return face;
  for (std::int32_t j = 0; j < sides; ++j) {
    const Value corner = cornerOf(j);
    const double angle = 2 * std::numbers::pi * j / sides;
    face.mean += corner;
    face.cosine += std::cos(angle) * corner;
    face.sine += std::sin(angle) * corner;
  }
  face.mean *= 1.0 / sides;
  return face;
}

/// Position and derivatives at a point of a patch. The parameters are the coordinates u = u_0, v = u_1, with
/// u_2 = 1 - u - v; so du points along J_0 - J_2 and dv along J_1 - J_2, J_i being the corners, and du x dv points
/// outward.
template <class Value>
struct PatchDerivatives {
  Value position{}, du{}, dv{}, duu{}, duv{}, dvv{};
  /// At the corner of a face that isn't a hexagon the derivatives by u and v don't exist, only a tangent plane:
  /// du and dv are then T1 = sum_j cos(2 pi j/N) p_j and T2 = sum_j sin(2 pi j/N) p_j of that face, which span it with
  /// T1 x T2 outward but whose lengths and directions mean nothing else, and the second derivatives are zero.
  bool extraordinaryCorner = false;
};

/// A point that is not the corner of a non-hexagon but no further from it than this, in barycentric coordinates, is
/// taken for it: rounding leaves no digits of the second derivatives there.
constexpr double kCornerDistance = 0x1p-50;

/// The limit surface of the half-box scheme (original S2) on the patch of the vertex of `faces`: refines the three
/// faces, without their surroundings, until the point lies in a patch of three hexagons, which is a cubic. At most 52
/// steps. `u` lies in the triangle; coordinates below zero are taken for zero, and the largest for 1 less the others.
/// Second derivatives have a side on the edges between the cubics, where the surface is C1: the patch's own.
template <class Value>
PatchDerivatives<Value> evaluatePatch(const PatchFaces<Value>& faces, const Barycentric& u);

/// The ten Bezier points of a patch of three hexagons, numbered by their exponents of (u_0, u_1, u_2):
///              0:300                             corner in f_0
///           1:210  2:201
///        3:120  4:111  5:102
///     6:030  7:021  8:012  9:003                 corners in f_1 and f_2
/// Barendrecht, Sabin and Kosinka, section 3; every one is a sum of control points over 6.
template <class Value>
std::array<Value, 10> bezierPoints(const PatchFaces<Value>& faces);

/// Position and derivatives of a cubic by its ten Bezier points, by de Casteljau's algorithm.
template <class Value>
PatchDerivatives<Value> evaluateBezier(const std::array<Value, 10>& points, const Barycentric& u);

/// Nine numbers for each of the three faces of a patch, which are its six slots, mean, cosine and sine: how much of
/// each a value on the surface contains.
using PatchRow = PatchValue<27>;

/// Faces whose values are themselves: evaluating them gives weights in place of points.
PatchFaces<PatchRow> unitFaces(const std::array<std::int32_t, 3>& sides);

/// The number of points a patch reads, repeated ones counted for each place.
constexpr std::int32_t patchPointCount(const std::array<std::int32_t, 3>& sides) {
  return sides[0] + sides[1] + sides[2] - 5;
}

/// A row as weights on the points of a patch, in the order of VertexPatch::point.
std::vector<double> pointWeights(const std::array<std::int32_t, 3>& sides, const PatchRow& row);

/// Weights on the points of a patch, in the order of VertexPatch::point: `position` sums to 1, the tangents to 0.
struct PatchFrameWeights {
  std::vector<double> position, tangent1, tangent2;
};

/// Limit position and two tangents (T1 x T2 outward) at the centre u = (1/3, 1/3, 1/3) of the patch of a vertex whose
/// faces have `sides` sides. On hexagons the position is 19/54 v, 13/81 w_i, 2/81 p_2 and p_4, 1/162 p_3 of each face.
/// Linear in the sides.
PatchFrameWeights patchCentreWeights(const std::array<std::int32_t, 3>& sides);

}  // namespace honeycomb::Far
