#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "apps/cli/animation_input.h"
#include "apps/cli/central_points.h"
#include "apps/cli/console.h"
#include "apps/cli/mesh_input.h"
#include "apps/cli/surface_evaluator.h"
#include "far/base/result.h"
#include "far/tables/refinement.h"
#include "io/pc2.h"

namespace honeycomb::Cli {

/// What to bake; everything outlives the job.
struct BakeFrames {
  const Animation& animation;
  const MeshInput& input;
  const CentralPoints& central;
  const Far::Refinement& refinement;
  const FrameEvaluators& evaluators;
  /// Frames in memory.
  int atOnce() const {
    return evaluators.stream ? evaluators.stream->depth() : static_cast<int>(evaluators.each.size());
  }
};

/// Reads, refines and writes the frames in order: through the evaluators' stream, or as many of them in memory as there
/// are evaluators, each a task of its own. Keeps the points of the first one in `firstFrame` unless that is null.
/// Errors: the first frame's that has one.
Result<void> bakeFrames(const BakeFrames& job, const Session& session, Io::Pc2Writer& writer,
                        std::vector<float>* firstFrame);

}  // namespace honeycomb::Cli
