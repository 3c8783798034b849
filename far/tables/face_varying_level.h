#pragma once

#include "far/tables/charts.h"
#include "far/tables/face_varying.h"

namespace honeycomb::Far {

/// The values of level `child` of a refinement and their table, from those of its parent level. `values` are the
/// parent's, and become the child's where both have seams and a length of 2 (nothing needs them otherwise). The values
/// of the child are [one a vertex | one a central control vertex, where it has any | further ones of vertices on
/// seams].
FaceVaryingLevel buildFaceVaryingLevel(const Level& parent, const Level& child, const Charts& charts,
                                       std::int32_t parentValueCount, std::int32_t length, std::vector<double>& values);

}  // namespace honeycomb::Far
