#pragma once

#include "far/topology/split.h"

namespace honeycomb::Far {

/// Turns the boundary that one step of the brick rule makes into a clamped one (see clamp()), of the same faces: a half
/// face (o, d, q_1 .. q_m) becomes the side (L, R, q_1 .. q_m), a corner face (o, c, d, q_1 .. q_m) the corner
/// (L, c, R, q_1 .. q_m), and each mid vertex between two of them a gap. The curve then depends on the boundary alone,
/// which is what the two sides of a crease need; clamp() takes it from the faces beside it. Points: vertexPoint of each
/// inside vertex, cutStart for L and cutEnd for R of the cut edges, fixedCorner for c.
/// A closed mesh stays as it is. Errors: invalidMesh for a boundary that is not as one brick step leaves it.
Split clampBricks();

}  // namespace honeycomb::Far
