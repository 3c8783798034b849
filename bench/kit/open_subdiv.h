#pragma once

#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

#include "bench/kit/meshes.h"

namespace honeycomb::Bench {

/// Not OpenSubdiv's StencilTable: its factory returns this and calls it one.
using ForeignTable = OpenSubdiv::Far::StencilTableReal<float>;

/// A mesh as OpenSubdiv takes it, for Catmull-Clark subdivision, and what it makes of it. Null where it refuses.
using Refiner = std::unique_ptr<OpenSubdiv::Far::TopologyRefiner>;
using Stencils = std::unique_ptr<const ForeignTable>;
Refiner catmarkRefiner(const Far::Polygons& polygons);

/// Stencils of the last level from the control vertices, as its evaluators want them.
Stencils catmarkStencils(const OpenSubdiv::Far::TopologyRefiner& refiner, std::int32_t level);

/// A torus of quads that Catmull-Clark subdivision of `level` steps refines to about as many vertices.
Mesh catmarkMesh(std::int64_t refinedVertices, std::int32_t level);

}  // namespace honeycomb::Bench
