#pragma once

#include "far/schemes/scheme.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {

/// Limits of a level that `lastStep` has made. Errors: those of its split.
Result<LimitTable> buildLimitTable(const Level& level, const Scheme& lastStep);

/// The tangents of the faces of some runs of a level, from its points, by face. Positions are those of their corners
/// alone.
LimitRows buildFaceFrames(const SourceLevel& level, std::span<const FaceRun> runs);

}  // namespace honeycomb::Far
