#pragma once

#include <vector>

#include "far/tables/level_table.h"
#include "osd/vulkan/projected_plan.h"
#include "osd/vulkan/stage_planner.h"

namespace honeycomb::Osd {

/// The dispatches of a level's summed rows, to be run behind `projected.sums`. Sections: the level's indices and
/// weights. Errors: tooLarge, also where the sums of all large faces pass a page.
Result<std::vector<Dispatch>> planSummed(const StagePlanner& stage, const Far::LevelTable& table,
                                         const Section& indices, const Section& weights, const ProjectedPlan& projected,
                                         TableImage& image);

}  // namespace honeycomb::Osd
