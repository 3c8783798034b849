#pragma once

#include <cstdint>
#include <vector>

#include "far/topology/topology.h"

namespace honeycomb::Far {

/// A limit position and two tangents (T1 x T2 outward) as weights on points of a level.
struct LimitFrame {
  std::vector<std::int32_t> points;
  std::vector<double> position, tangent1, tangent2;
};

/// A face cut by a clamped boundary: see FaceKind and clampedHalfBoxStep().
///     side    limit (L+R)/2; T1 = R - L along the curve, T2 = sum_i sin(theta_i) (q_i - J) + x (L_g - J + R_e - J)
///     with
///             theta_i = pi (2i-1)/(2m): the left eigenvectors of 1/2, so that the normal is that of the limit surface
///     corner  limit J; m = 1, 2: the tangents R - J and L - J of the curve, which span the tangent plane; m = 3 as a
///             side; more: the same two from the other side where the scheme has a tangent plane there (smoothCorners),
///             else the plane nearest the inside vertices
///     gap     the middle of the boundary curve between two faces, with its tangent; the other tangent runs to q
LimitFrame clampedFaceFrame(const Topology& topology, std::int32_t f, bool smoothCorners);

/// Is v a vertex of the boundary curve's control polygon?
bool onClampedBoundary(const Topology& topology, std::int32_t v);
/// Such a vertex: R and L stand for the points of the curve at 1/3 and 2/3 between the limits of their faces, with the
/// tangent there and the direction to q of their gap; J for itself.
LimitFrame clampedBoundaryFrame(const Topology& topology, std::int32_t v, bool smoothCorners);

/// Is v inside, in the face of a clamped boundary?
bool besideClampedBoundary(const Topology& topology, std::int32_t v);
/// The patch centre of a vertex in the middle of a side of three inside vertices that a gap became, whose faces are
/// otherwise hexagons: by the images of q_i over the boundary, which complete the sides.
LimitFrame clampedPatchCentre(const Topology& topology, std::int32_t v);

}  // namespace honeycomb::Far
