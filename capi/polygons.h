#pragma once

#include "capi/include/honeycomb.h"
#include "far/base/result.h"
#include "far/topology/polygons.h"

namespace honeycomb::Capi {

/// A copy of the caller's arrays, whose shape is sound: no NULL, no negative count, sizes that add up. What the
/// vertices say is Far::Topology's business. Errors: invalidOption, invalidMesh.
Result<Far::Polygons> readPolygons(const hc_polygons* polygons);

}  // namespace honeycomb::Capi
