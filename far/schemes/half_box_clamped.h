#pragma once

#include "far/schemes/half_box_rows.h"

namespace honeycomb::Far {

/// How the surface leaves a corner of the clamped boundary of more than 180 degrees.
enum class HalfBoxCorners : std::uint8_t {
  convex,  ///< all weights are positive; there is no tangent plane at the corner
  smooth   ///< a tangent plane at the corner, that of the boundary curve; some weights are negative
};

/// The step that makes the boundary of a three-valent mesh its data (see clamp()): R_f is
/// (2 (v + w) + v' + w')/6 for the edge (v, w) between f and the next face on the boundary and their other neighbours
/// v', w' in f; L_f likewise; J is the centroid of f. On hexagons these are the Bezier points of the boundary curve of
/// the surface; all other vertices stay.
Scheme clampStep();

/// One step of the half-box scheme on a clamped boundary, in the terms of P. Barendrecht, M. Sabin, J. Kosinka, "A
/// bivariate C1 subdivision scheme based on cubic half-box splines", CAGD 2019, 4.3 and Fig 9, which leave the rules of
/// the auxiliary structure open. J = (L + R)/2 on sides; e is the face before f along the boundary, g the one after.
///     curve   L' = (L+J)/2, R' = (R+J)/2, J' = J;  in a gap Lm = (J_f + 2R_f + L_g)/4, Rm = (R_f + 2L_g + J_g)/4
///     S2(v)   v at t gaps, with the inside vertices x as neighbours: t = 0 as elsewhere;
///             else (sum x + sum over the gaps (R + L))/(3 + t)
///     S1      sides: by the polygon of 2m corners completed by 2 pi_i - q_i, where pi_i (clampedMirrorCosine) lies on
///             the boundary. Corners by m:
///             1  (J + q + L + R)/4        2  q_1/4 + R/2 + L/4, q_2/4 + L/2 + R/4        3  as a side, with this J
///             4, 5  convex: the hexagon completed by the images 2J - q of its opposite corners
///             6 and more  convex: the polygon of m + 2 corners completed by J
///             smooth, m > 3: J + (q_i - J)/4 + (alpha_i (R-J) + beta_i (L-J))/4, with alpha and beta such that a
///             corner of a planar honeycomb is halved
/// Weights that pull apart the control points of small faces count for vertices at no gap.
Scheme clampedHalfBoxStep(const TunedWeights& tuned, HalfBoxCorners corners);

}  // namespace honeycomb::Far
