#pragma once

#include "far/base/result.h"
#include "far/schemes/scheme.h"

namespace honeycomb::Far {

/// What trisect() is free to choose.
struct TrisectOptions {
  double ratio = 1.0 / 3;  ///< how far along its edge a point lies from the vertex it is next to, in (0, 1/2)
};

/// D. Finn, course notes "Simple Subdivision Methods", trisection: corners are cut off, on the truncate split.
/// Errors: invalidOption for a ratio out of range or not a number.
Result<Scheme> trisect(const TrisectOptions& options = {});

}  // namespace honeycomb::Far
