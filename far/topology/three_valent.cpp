#include "far/topology/three_valent.h"

#include <fmt/format.h>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

bool threeEdges(const Topology& topology, std::int32_t v) {
  const std::int32_t h = topology.outgoing(v);
  const std::int32_t second = topology.nextOutgoing(h);
  if (!topology.onBoundary(v)) {
    if (second == h) return false;
    const std::int32_t third = topology.nextOutgoing(second);
    return third != h && topology.nextOutgoing(third) == h;
  }
  return second < 0 || topology.nextOutgoing(second) < 0;
}

}  // namespace

std::int32_t firstNotThreeValent(const Topology& topology) {
  if (topology.threeValent()) return -1;
  const std::int64_t lowest = Parallel::firstWhere(
      0, topology.vertexCount(), [&](std::int64_t v) { return !threeEdges(topology, static_cast<std::int32_t>(v)); });
  return lowest == topology.vertexCount() ? -1 : static_cast<std::int32_t>(lowest);
}

Result<void> checkThreeValent(const Topology& topology) {
  const std::int32_t v = firstNotThreeValent(topology);
  if (v < 0) return {};
  return fail(ErrorCode::invalidMesh,
              fmt::format("{} has {} edges, and half-box splines need three (two or three on a boundary); convert the "
                          "mesh first",
                          elementName(ElementKind::vertex, v), topology.valence(v)),
              v, ElementKind::vertex);
}

}  // namespace honeycomb::Far
