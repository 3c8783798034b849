#pragma once

#include <cstdint>
#include <vector>

#include "apps/viewer/gpu.h"
#include "far/topology/topology.h"

namespace honeycomb::Viewer {

/// Lines between points, on the device: line i joins the points 2i and 2i+1 of `pairs`.
struct LineMesh {
  std::int32_t vertexCount = 0;
  std::uint32_t lineCount = 0;
  Buffer pairs;
};

/// The two vertices of every edge, each edge once. Linear; finds the topology's links where they weren't yet.
std::vector<std::int32_t> edgePairs(const Far::Topology& topology);

/// Errors: invalidMesh for a pair of other vertices; outOfMemory.
Result<LineMesh> uploadLines(const Gpu& gpu, std::int32_t vertexCount, std::span<const std::int32_t> pairs);

}  // namespace honeycomb::Viewer
