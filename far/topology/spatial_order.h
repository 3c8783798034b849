#pragma once

#include <cstdint>
#include <vector>

#include "far/topology/edge_matching.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// The caller's faces in an order in which neighbours are near each other: order[i] is the face at place i. Patches of
/// neighbouring faces in patches of patches, each grown breadth first from the rim of those before it: a front over the
/// whole mesh would be a long thin strip. By connectivity alone, since positions move; a permutation of the faces of
/// any mesh, the same one on every machine. Linear in the corners.
std::vector<std::int32_t> spatialFaceOrder(const Polygons& polygons, const Inspection& inspection);

/// The vertices of a level 0 in the order in which its half-edges first leave them. A topology keeps the caller's
/// vertex numbers, and the faces that vertices become are in their order: where that is random too, most of what
/// FaceOrder::spatial can gain comes of numbering the vertices of the polygons like this and gathering the control
/// points each frame.
std::vector<std::int32_t> spatialVertexOrder(const Topology& topology);

}  // namespace honeycomb::Far
