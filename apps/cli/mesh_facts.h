#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "far/topology/topology.h"

namespace honeycomb::Cli {

/// How many elements there are of each size.
using Histogram = std::map<std::int32_t, std::int64_t>;

/// What `honeycomb info` says about a manifold.
struct MeshFacts {
  Histogram valences;  ///< edges at a vertex
  std::int64_t components = 0;
  std::vector<std::int64_t> boundaryLoops;  ///< edges of each boundary, longest first
  std::int64_t genus = 0;                   ///< of all components together
};
MeshFacts gatherFacts(const Far::Topology& topology);

/// Faces by their number of sides; needs no manifold.
Histogram countSides(const Far::Polygons& polygons);

}  // namespace honeycomb::Cli
