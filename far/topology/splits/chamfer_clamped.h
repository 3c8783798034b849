#pragma once

#include "far/topology/split.h"

namespace honeycomb::Far {

/// The chamfer split of a mesh with a clamped boundary, as clamp() and this split make it. Faces and the edges between
/// two inside vertices become what they become under chamfer(), sides stay sides and corners corners. A gap (R_f, L_g,
/// v) becomes the side (Lm, Rm, s1(g,v), s2(v), s1(f,v)) and the gaps (R'_f, Lm, s1(f,v)) and (Rm, L'_g, s1(g,v)).
/// Points beside those of chamfer(): cutStart for L' (halfEdge: the one that leaves L) and Lm (that which leaves R_f),
/// cutEnd for R' (the one that enters R) and Rm (that which enters L_g), fixedCorner for J, halfFaceCorner and
/// cornerFaceCorner for the corner points q of sides and corners.
/// Errors: invalidMesh when the boundary is not clamped, or for a closed mesh that is not three-valent.
Split chamferClamped();

}  // namespace honeycomb::Far
