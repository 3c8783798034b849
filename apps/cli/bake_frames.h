#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "apps/cli/animation_input.h"
#include "apps/cli/central_points.h"
#include "apps/cli/console.h"
#include "apps/cli/mesh_input.h"
#include "apps/cli/ranks.h"
#include "apps/cli/surface_evaluator.h"
#include "far/base/result.h"
#include "io/frame_writer.h"

namespace honeycomb::Cli {

/// What to bake; everything outlives the job.
struct BakeFrames {
  const Animation& animation;
  const MeshInput& input;
  const CentralPoints& central;
  const FrameEvaluators& evaluators;
  /// Frames in memory.
  int atOnce() const {
    return evaluators.stream ? evaluators.stream->depth() : static_cast<int>(evaluators.each.size());
  }
};

/// The refined points of the first frame of the range. Errors: whatever is wrong with it.
Result<std::vector<float>> bakeFirstFrame(const BakeFrames& job);

/// How far a rank came.
struct BakeOutcome {
  Result<void> done;       ///< the error of the first of its frames that has one
  std::int64_t frame = 0;  ///< that frame
};

/// Reads, refines and writes those of `frames` (counted from the first of the range) that `ranks` hands out to this
/// process: through the evaluators' stream, or as many of them at a time as there are evaluators, each a task of its
/// own.
BakeOutcome bakeFrames(const BakeFrames& job, const Session& session, const std::vector<std::int32_t>& frames,
                       Ranks& ranks, Io::FrameWriter& writer);

}  // namespace honeycomb::Cli
