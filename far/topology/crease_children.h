#pragma once

#include "far/topology/split.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// The creases of the next level, one step less sharp: what the split of a parent that is cut open along its creases
/// made of them, and of the corners that are held. The two sides of a cut are paired by the labels of their new points:
/// the middle of an edge is that of its mate, the point next to the start of a cut that next to its mate's end. So no
/// rule of refinement has to know of creases.
struct CreaseChildren {
  std::vector<CreaseEdge> creases;
  std::vector<std::int32_t> heldCorners;
};
CreaseChildren creaseChildren(const Topology& parent, const SplitResult& child);

}  // namespace honeycomb::Far
