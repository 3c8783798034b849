#pragma once

#include "far/topology/split.h"

namespace honeycomb::Far {

/// Ends a three-valent mesh in the Bezier points of the boundary curve of its half-box surface, after Fig 9 of
/// P. Barendrecht, M. Sabin, J. Kosinka, "A bivariate C1 subdivision scheme based on cubic half-box splines", CAGD
/// 2019: a face on the boundary with the inside vertices q_1 .. q_m in a row becomes (L, R, q_1 .. q_m) where it has 2m
/// sides and (L, J, R, q_1 .. q_m) elsewhere; between a face f and the next one, g, comes the triangle (R_f, L_g, q)
/// with q = q_1 of f = q_m of g. Faces without a vertex inside are dropped; a face whose inside vertices lie in several
/// rows becomes a face for each, for the surface only touches itself there. Vertices inside stay as they are. Points:
/// vertexPoint of each inside vertex, besideEdge for L and R (the edge from q_m, and the one to q_1), faceCentre for J.
/// A closed mesh stays as it is. Errors: invalidMesh naming a vertex that has not three edges (two or three on the
/// boundary), or when no vertex lies inside.
Split clamp();

}  // namespace honeycomb::Far
