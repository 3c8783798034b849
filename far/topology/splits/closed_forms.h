#pragma once

#include "far/topology/split.h"

/// The splits on a closed mesh, element for element what their slots give in assemble(): one file each.
namespace honeycomb::Far {

SplitResult chamferClosed(const Topology& parent);
SplitResult expandClosed(const Topology& parent);
SplitResult amboClosed(const Topology& parent);
SplitResult truncateClosed(const Topology& parent);
SplitResult dualClosed(const Topology& parent);

/// The same by their slots, on any mesh.
SplitResult chamferBySlots(const Topology& parent);
SplitResult expandBySlots(const Topology& parent);
SplitResult amboBySlots(const Topology& parent);
SplitResult truncateBySlots(const Topology& parent);
SplitResult dualBySlots(const Topology& parent);

}  // namespace honeycomb::Far
