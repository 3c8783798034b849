#pragma once

#include "far/base/result.h"
#include "far/schemes/half_box.h"

namespace honeycomb::Far {

/// Half-box splines keep creases that are sharp for ever, on both sides of which the surface has a clamped boundary
/// with the same curve: an Akleman step cuts the mesh open, clampBricksStep() makes the curve of its half faces, and
/// the steps after it are those of a clamped boundary. Borders are treated as creases are. Sets the options of the
/// chain for a control mesh with creases. Errors: invalidOption for a crease that becomes smooth, for another
/// conversion, or a border that is not to be clamped; its element is a vertex of the crease.
Result<void> chooseForCreases(const Topology& control, HalfBoxOptions& options);

/// The step of the clampBricks() split: L = (5o + d)/6, R = (o + 5d)/6 of a cut from o to d, the Bezier points of the
/// uniform spline with the vertices of the mesh as joints; (2o + c)/3 and (2d + c)/3 beside a corner c. Other vertices
/// stay.
Scheme clampBricksStep();

}  // namespace honeycomb::Far
