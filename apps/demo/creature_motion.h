#pragma once

#include <vector>

#include "apps/demo/creature_rig.h"

namespace honeycomb::Demo {

/// The frames of all bones (kBoneCount, numbered as in creature_rig.h) at a time of the loop in [0, 1): two strides of
/// a salamander's walk in place, y up, feet on y = 0. Feet on the ground slide back evenly and do not turn.
std::vector<Frame> poseAt(double time);

}  // namespace honeycomb::Demo
