#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {

std::vector<std::int32_t> Refinement::triangles(std::int32_t k) const {
  const Topology& topology = level(k).topology;
  // A face of N sides gives N - 2 triangles: those of face f start at its first half-edge less two for each face
  // before.
  std::vector<std::int32_t> triangles(3 * at(topology.halfEdgeCount() - 2 * topology.faceCount()));
  Parallel::forEach(
      0, topology.faceCount(),
      [&](std::int64_t f) {
        const std::int32_t first = topology.faceOffsets()[at(f)];
        const std::int32_t end = topology.faceOffsets()[at(f) + 1];
        std::size_t out = 3 * at(first - 2 * f);
        for (std::int32_t h = first + 1; h + 1 < end; ++h) {
          triangles[out++] = topology.vert(first);
          triangles[out++] = topology.vert(h);
          triangles[out++] = topology.vert(h + 1);
        }
      },
      1024);
  return triangles;
}

std::vector<std::int32_t> Refinement::lines(std::int32_t k) const {
  const Topology& topology = level(k).topology;
  const auto leads = [&topology](std::int64_t h) { return topology.leads(static_cast<std::int32_t>(h)); };
  std::vector<std::int32_t> place(at(topology.halfEdgeCount()));
  Parallel::forEach(0, topology.halfEdgeCount(), [&](std::int64_t h) { place[at(h)] = leads(h) ? 1 : 0; });
  const std::int64_t edges = Parallel::exclusiveScan(place);
  std::vector<std::int32_t> lines(2 * at(edges));
  Parallel::forEach(0, topology.halfEdgeCount(), [&](std::int64_t h) {
    if (!leads(h)) return;
    lines[2 * at(place[at(h)])] = topology.vert()[at(h)];
    lines[2 * at(place[at(h)]) + 1] = topology.dest(static_cast<std::int32_t>(h));
  });
  return lines;
}

}  // namespace honeycomb::Far
