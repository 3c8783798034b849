#pragma once

#include "far/schemes/scheme.h"
#include "far/topology/splits/zip.h"

namespace honeycomb::Far {

/// Stencils of the points that the boundary rules of the zip split add; the boundary curve depends on the boundary
/// alone. brick: the middle of an edge on the line; 5/6, 1/6 next to a mid-point and 3/4, 1/4 next to a vertex of a cut
/// (2/3, 1/3 and 1/2, 1/2 beside a corner); corners stay. In two steps this is the ternary mask (1,4,8,10,8,4,1)/12.
/// A corner face's points: the mean of the edge's ends and the corner.
/// eq16 (Zhang and Wang, "Honeycomb Subdivision"): v_b = (1-s) v + s (v_1+v_2)/2 with v_1, v_2 the neighbours on the
/// boundary and s = `vertexWeight`.
void addZipBoundaryRow(const Topology& parent, const NewPoint& point, double vertexWeight, Row& row);

/// The crease rule of the schemes on the zip split, which is brick's on both sides; `boundary`: theirs on borders.
CreaseRule zipCreases(BoundaryRule boundary);

}  // namespace honeycomb::Far
