#pragma once

#include <cstdint>

#include "far/base/result.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// The first vertex that hasn't three edges (on a boundary two or three); -1 when the mesh is three-valent.
std::int32_t firstNotThreeValent(const Topology& topology);

/// invalidMesh, naming that vertex and its number of edges; the vertex is the error's element.
Result<void> checkThreeValent(const Topology& topology);

}  // namespace honeycomb::Far
