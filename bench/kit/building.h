#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "bench/kit/meshes.h"
#include "bench/kit/sampling.h"
#include "far/schemes/scheme.h"
#include "far/topology/topology.h"

namespace honeycomb::Bench {

/// What is built, and of what.
struct Building {
  const Far::Polygons& polygons;
  const Far::Topology& control;  ///< made of these
  std::span<const Far::Scheme> steps;
  std::int64_t memory = 0;  ///< bytes that flattened tables may take
  SamplingOptions sampling = {};
};

/// What it took.
struct BuildTime {
  std::string_view library;  ///< "honeycomb", "opensubdiv"
  std::string_view what;
  Spread nsPerVertex;         ///< of the last level
  std::int64_t vertices = 0;  ///< of the last level
  std::int64_t bytes = 0;     ///< of what is built
};

/// Times, in turns, on as many threads as loops may use:
///     honeycomb   control    level 0 from polygons, validated
///                 topology   all levels' connectivity from level 0, links left for when they are asked for
///                 full-topology   the same with the links of every level
///                 tables     topology and the level tables
///                 flattened  the StencilTable of the last level from these
///     opensubdiv  control    a TopologyRefiner from polygons
///                 topology   RefineUniform, without the last level's full topology, which stencils don't need
///                 full-topology   RefineUniform, with it
///                 stencils   StencilTableFactory::Create, from the control vertices to the last level
/// OpenSubdiv's mesh is a torus of quads whose Catmull-Clark subdivision has about as many vertices (catmarkMesh); it
/// has one thread for this. What doesn't fit or isn't built in is left out. Errors: those of refine().
Result<std::vector<BuildTime>> measureBuilding(const Building& building);

}  // namespace honeycomb::Bench
