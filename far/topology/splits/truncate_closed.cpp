#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/splits/closed_forms.h"
#include "far/topology/splits/closed_split.h"

/// Truncation of a closed mesh, with the slots of truncate.cpp. A of h is 2h and B is 2h+1; behind them stand the loops
/// of the vertices, C(prev h_0) C(prev h_1) .. with h_0 = outgoing(v), from 2H on.
namespace honeycomb::Far {

SplitResult truncateClosed(const Topology& parent) {
  const std::int32_t halfEdges = parent.halfEdgeCount();
  const VertexBlocks blocks(parent, 1, parent.faceCount(), 2 * halfEdges);
  TopologyArrays child;
  child.threeValent = true;
  appendFaceRuns(parent, 2, child.runs);
  blocks.appendRuns(child.runs);
  resizeArrays(child, 3 * halfEdges, parent.faceCount() + parent.vertexCount(), halfEdges);
  writeFaceFaces(parent, 2, child);
  Array<NewPoint> points(at(halfEdges));
  Parallel::forEach(0, halfEdges, [&](std::int64_t i) {
    const auto h = static_cast<std::int32_t>(i);
    const std::int32_t t = parent.twin(h);
    child.vert[at(2 * h)] = h;
    child.vert[at(2 * h + 1)] = t;
    child.twin[at(2 * h)] = 2 * t;
    child.face[at(2 * h)] = child.face[at(2 * h + 1)] = parent.face(h);
    child.outgoing[at(h)] = std::min(2 * h, 2 * t + 1);
    points[at(h)] = {PointKind::edgeStart, h};
  });
  Parallel::forEach(
      0, parent.vertexCount(),
      [&](std::int64_t i) {
        const auto v = static_cast<std::int32_t>(i);
        const std::int32_t face = blocks.face(v);
        std::int32_t c = blocks.halfEdge(v);
        child.parents[at(face)] = v;
        child.faceOffsets[at(face)] = c;
        for (const std::int32_t h : parent.halfEdgesFrom(v)) {
          const std::int32_t b = 2 * parent.prev(h) + 1;
          child.vert[at(c)] = h;
          child.twin[at(c)] = b;
          child.face[at(c)] = face;
          child.twin[at(b)] = c++;
        }
      },
      1024);
  return {Topology(std::move(child)), 0, std::move(points)};
}

}  // namespace honeycomb::Far
