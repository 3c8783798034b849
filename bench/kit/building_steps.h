#pragma once

#include <vector>

#include "bench/kit/building.h"
#include "bench/kit/evaluators.h"

namespace honeycomb::Bench {

/// Something that is built: a frame of `build` builds it once.
struct BuildStep {
  BuildTime time;  ///< all but the time
  Prepared build;
};

/// What honeycomb builds. Errors: those of refine().
Result<std::vector<BuildStep>> buildSteps(const Building& building);

/// Appends what OpenSubdiv builds for about `vertices` refined vertices.
void addOpenSubdivSteps(std::int64_t vertices, std::int32_t level, std::vector<BuildStep>& steps);

}  // namespace honeycomb::Bench
