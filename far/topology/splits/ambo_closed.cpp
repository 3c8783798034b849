#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/splits/closed_forms.h"
#include "far/topology/splits/closed_split.h"

/// Ambo on a closed mesh, with the slots of ambo.cpp. A of h keeps the id h; behind them stand the loops of the
/// vertices, B(prev h_0) B(prev h_1) .. with h_0 = outgoing(v). The vertex of an edge has the edge's rank.
namespace honeycomb::Far {

SplitResult amboClosed(const Topology& parent) {
  const std::int32_t halfEdges = parent.halfEdgeCount();
  const std::int32_t edgeCount = halfEdges / 2;
  const EdgeRanks edges(parent);
  const VertexBlocks blocks(parent, 1, parent.faceCount(), halfEdges);
  TopologyArrays child;
  appendFaceRuns(parent, 1, child.runs);
  blocks.appendRuns(child.runs);
  resizeArrays(child, 2 * halfEdges, parent.faceCount() + parent.vertexCount(), edgeCount);
  writeFaceFaces(parent, 1, child);
  Array<NewPoint> points(at(edgeCount));
  Parallel::forEach(0, halfEdges, [&](std::int64_t i) {
    const auto h = static_cast<std::int32_t>(i);
    child.vert[at(h)] = edges.edge(h);
    child.face[at(h)] = parent.face(h);
    if (!edges.leads(h)) return;
    child.outgoing[at(edges.edge(h))] = h;
    points[at(edges.edge(h))] = {PointKind::edgeMiddle, h};
  });
  Parallel::forEach(
      0, parent.vertexCount(),
      [&](std::int64_t i) {
        const auto v = static_cast<std::int32_t>(i);
        const std::int32_t face = blocks.face(v);
        std::int32_t b = blocks.halfEdge(v);
        child.parents[at(face)] = v;
        child.faceOffsets[at(face)] = b;
        for (const std::int32_t h : parent.halfEdgesFrom(v)) {
          const std::int32_t p = parent.prev(h);
          child.vert[at(b)] = edges.edge(h);
          child.twin[at(b)] = p;
          child.face[at(b)] = face;
          child.twin[at(p)] = b++;
        }
      },
      1024);
  return {Topology(std::move(child)), 0, std::move(points)};
}

}  // namespace honeycomb::Far
