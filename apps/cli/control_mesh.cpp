#include "apps/cli/control_mesh.h"

#include "apps/cli/memory.h"
#include "far/topology/spatial_order.h"

namespace honeycomb::Cli {

Result<ControlMesh> prepareControl(MeshInput input, const SchemeOptions& options, const ChainRequest& request,
                                   Far::FaceOrder order) {
  tagCorners(options, input.mesh.polygons);
  Result<Far::Topology> topology = makeTopology(input, order);
  if (!topology) return tl::unexpected(topology.error());
  if (order == Far::FaceOrder::spatial) {
    renumberVertices(input, Far::spatialVertexOrder(*topology));
    topology = makeTopology(input, order);
    if (!topology) return tl::unexpected(topology.error());
  }
  Result<SchemeChain> chain = makeChain(request, options, *topology, checkChain);
  if (chain) return ControlMesh{std::move(input), std::move(*topology), std::move(*chain)};
  // Options are wrong whatever the mesh, unless an element of it is named.
  const Error& error = chain.error();
  const bool ofOptions = error.code == ErrorCode::invalidOption && error.kind == ElementKind::other;
  return tl::unexpected(ofOptions ? error : located(input, error));
}

}  // namespace honeycomb::Cli
