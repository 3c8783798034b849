#pragma once

#include <span>

#include "far/tables/level_table.h"
#include "osd/vulkan/stage_planner.h"

namespace honeycomb::Osd {

/// The three steps of the large faces of a level, see shaders/projected.glsl.
struct ProjectedPlan {
  std::vector<Dispatch> blocks, sums, outputs;
  std::uint64_t partialBytes = 0;  ///< scratch for block sums and sums
  std::uint64_t sumBytes = 0;      ///< of these the first, which hold the sums
  /// Per face: where among the sums S of its first component is; those of the next component are three numbers behind.
  std::vector<std::uint32_t> sumNumbers;
};

/// Errors: tooLarge, also for a face whose indices or weights pass a page.
Result<ProjectedPlan> planProjected(const StagePlanner& stage, std::span<const Far::ProjectedFace> faces,
                                    const Section& indices, const Section& weights, TableImage& image);

}  // namespace honeycomb::Osd
