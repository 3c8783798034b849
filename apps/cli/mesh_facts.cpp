#include "apps/cli/mesh_facts.h"

#include <algorithm>
#include <functional>

#include "far/base/index.h"

namespace honeycomb::Cli {
namespace {

Histogram countValences(const Far::Topology& topology) {
  std::vector<std::int32_t> valence(at(topology.vertexCount()), 0);
  for (const std::int32_t v : topology.vert()) ++valence[at(v)];
  // The edge that enters a boundary vertex along the boundary has no half-edge leaving it.
  for (const std::int32_t h : topology.boundary()) ++valence[at(topology.vert(h))];
  Histogram histogram;
  for (const std::int32_t n : valence) ++histogram[n];
  return histogram;
}

/// Connected sets of faces, by flooding over twins.
std::int64_t countComponents(const Far::Topology& topology) {
  std::vector<std::uint8_t> seen(at(topology.faceCount()), 0);
  std::vector<std::int32_t> open;
  std::int64_t components = 0;
  for (std::int32_t seed = 0; seed < topology.faceCount(); ++seed) {
    if (seen[at(seed)]) continue;
    ++components;
    seen[at(seed)] = 1;
    open.push_back(seed);
    while (!open.empty()) {
      const std::int32_t f = open.back();
      open.pop_back();
      const std::int32_t first = topology.faceOffsets()[at(f)];
      for (std::int32_t h = first; h < first + topology.sides(f); ++h) {
        const std::int32_t neighbour = topology.twin(h) < 0 ? f : topology.face(topology.twin(h));
        if (seen[at(neighbour)]) continue;
        seen[at(neighbour)] = 1;
        open.push_back(neighbour);
      }
    }
  }
  return components;
}

std::vector<std::int64_t> measureBoundaries(const Far::Topology& topology) {
  std::vector<std::uint8_t> seen(at(topology.vertexCount()), 0);
  std::vector<std::int64_t> loops;
  for (const std::int32_t start : topology.boundary()) {
    std::int64_t edges = 0;
    for (std::int32_t h = start; !seen[at(topology.vert(h))]; h = topology.outgoing(topology.dest(h))) {
      seen[at(topology.vert(h))] = 1;
      ++edges;
    }
    if (edges > 0) loops.push_back(edges);
  }
  std::sort(loops.begin(), loops.end(), std::greater<>());
  return loops;
}

}  // namespace

MeshFacts gatherFacts(const Far::Topology& topology) {
  MeshFacts facts;
  facts.valences = countValences(topology);
  facts.components = countComponents(topology);
  facts.boundaryLoops = measureBoundaries(topology);
  // V - E + F = 2 components - 2 genus - boundaries
  facts.genus = (2 * facts.components - std::ssize(facts.boundaryLoops) - topology.eulerCharacteristic()) / 2;
  return facts;
}

Histogram countSides(const Far::Polygons& polygons) {
  Histogram histogram;
  for (std::size_t f = 0; f + 1 < polygons.faceOffsets.size(); ++f)
    ++histogram[static_cast<std::int32_t>(polygons.faceOffsets[f + 1] - polygons.faceOffsets[f])];
  return histogram;
}

}  // namespace honeycomb::Cli
