#pragma once

#include <span>
#include <string_view>

#include "far/base/result.h"
#include "far/schemes/scheme.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// Creases: edges that stay sharp for as many steps as their sharpness says, then become smooth.
///
/// The first step cuts the mesh open along them; sharp steps refine both sides by the boundary rule of the scheme,
/// whose points depend on the crease alone, so that the sides keep the same points, bit for bit, in two copies with a
/// normal each. With s steps left, s <= 1, the step closes the mesh again and takes (1 - s) times the smooth and s
/// times the sharp positions. Levels are not more for creases, and once all are closed the level has the connectivity
/// that it has without, up to numbering. In the spirit of the semi-sharp creases of Beets et al.
///
/// A vertex stays in place while a crease changes its sharpness there, meets the boundary or more than one other
/// crease, or while it is tagged a corner; OpenSubdiv has the same rule for more than two sharp edges. Where a crease
/// ends inside the mesh, its end follows the surface. Limits of a level that is still cut take the cut for a boundary.
///
/// Checks that each step of the chain has a rule for the creases that are sharp when it comes.
/// Errors: invalidOption naming the scheme; its element is a vertex of a crease.
Result<void> checkCreases(const Topology& control, std::span<const Scheme> chain);

/// The error that names a crease by its vertices, and says why it is refused and what to do.
tl::unexpected<Error> refuseCrease(const Topology& control, const CreaseEdge& crease, std::string_view why);

}  // namespace honeycomb::Far
