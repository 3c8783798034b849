#pragma once

#include "far/schemes/scheme.h"

namespace honeycomb::Far {

/// D. Finn, course notes "Simple Subdivision Methods", mid-point method: the middles of the edges, on the ambo split.
Scheme midpoint();

}  // namespace honeycomb::Far
