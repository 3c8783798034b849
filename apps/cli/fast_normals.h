#pragma once

#include <span>

#include "apps/cli/surface_evaluator.h"
#include "far/base/result.h"
#include "far/tables/refinement.h"

namespace honeycomb::Cli {

/// Fast normals of the last level's vertices (Far::NormalRule) from the control points that gave the surface's points;
/// these are found once more and have the bits they had. Errors: those of the tables.
template <class Real>
Result<void> setFastNormals(const Far::Refinement& refinement, std::span<const Real> control, Surface<Real>& surface);

}  // namespace honeycomb::Cli
