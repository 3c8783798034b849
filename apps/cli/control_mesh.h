#pragma once

#include "apps/cli/chain.h"
#include "apps/cli/mesh_input.h"
#include "far/topology/topology.h"

namespace honeycomb::Cli {

/// A mesh and how it is to be refined, validated.
struct ControlMesh {
  MeshInput input;
  Far::Topology topology;
  SchemeChain chain;
};

/// Makes the connectivity, its faces (and with `spatial` the vertices) in that order, and the steps for a mesh that was
/// read. Errors: invalidMesh, naming line, face or vertex; those of makeChain.
Result<ControlMesh> prepareControl(MeshInput input, const SchemeOptions& options, const ChainRequest& request,
                                   Far::FaceOrder order = Far::FaceOrder::input);

}  // namespace honeycomb::Cli
