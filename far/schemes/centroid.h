#pragma once

#include "far/schemes/scheme.h"

namespace honeycomb::Far {

/// D. Finn, course notes "Simple Subdivision Methods", centroid method: every corner half-way to the centroid of its
/// face, on the expand split.
Scheme centroid();

}  // namespace honeycomb::Far
