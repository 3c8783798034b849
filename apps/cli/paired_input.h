#pragma once

#include "apps/cli/mesh_input.h"

namespace honeycomb::Cli {

/// Joins pairs of triangles to quads (Far::pairTriangles), and notes how many. Frames stay as they are.
void pairTriangles(MeshInput& input);

}  // namespace honeycomb::Cli
