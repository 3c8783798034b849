#include "far/topology/three_valent.h"

#include <fmt/format.h>

#include <atomic>

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
  std::atomic<std::int32_t> lowest{topology.vertexCount()};
  Parallel::forEach(0, topology.vertexCount(), [&](std::int64_t i) {
    const auto v = static_cast<std::int32_t>(i);
    if (v >= lowest.load(std::memory_order_relaxed) || threeEdges(topology, v)) return;
    std::int32_t seen = lowest.load(std::memory_order_relaxed);
    while (v < seen && !lowest.compare_exchange_weak(seen, v, std::memory_order_relaxed)) {
    }
  });
  return lowest.load() == topology.vertexCount() ? -1 : lowest.load();
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
