#pragma once

#include "far/schemes/scheme.h"

namespace honeycomb::Far {

/// The dual as a step of a chain: a vertex at the centroid of each face, a face for each vertex inside. Triangle meshes
/// become three-valent. Errors of its split: see dualSplit().
Scheme dualStep();

}  // namespace honeycomb::Far
