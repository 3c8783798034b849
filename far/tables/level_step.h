#pragma once

#include "far/base/result.h"
#include "far/schemes/scheme.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {

/// The level behind `parent` by a step of `scheme`: its connectivity and table, creases and all. Errors: those of the
/// scheme's split.
Result<Level> nextLevel(const Level& parent, const Scheme& scheme);

/// The central control vertices of the levels that a scheme makes.
inline CentralPoints centralPointsOf(const Scheme& scheme) {
  return scheme.centralPoints ? CentralPoints::byFace : CentralPoints::none;
}

/// The split for the level as it is: where it is cut open along creases, that of the scheme's rule for creases.
const Split& splitFor(const Topology& level, const Scheme& scheme);

}  // namespace honeycomb::Far
