#pragma once

#include "far/topology/split.h"

/// The parts of the zip split, one file each.
namespace honeycomb::Far {

/// The closed form for closed meshes.
SplitResult zipClosed(const Topology& parent);
SplitResult zipBrick(const Topology& parent);
SplitResult zipEq16(const Topology& parent);
SplitResult zipDrop(const Topology& parent);

}  // namespace honeycomb::Far
