#pragma once

#include "far/schemes/scheme.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {

/// Limits of a level that `lastStep` has made. Errors: those of its split.
Result<LimitTable> buildLimitTable(const Level& level, const Scheme& lastStep);

}  // namespace honeycomb::Far
