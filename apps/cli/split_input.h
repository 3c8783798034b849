#pragma once

#include "apps/cli/mesh_input.h"

namespace honeycomb::Cli {

/// Duplicates vertices until the mesh is a manifold (Far::splitNonManifold), and notes how many. Frames follow.
void splitNonManifold(MeshInput& input);

}  // namespace honeycomb::Cli
