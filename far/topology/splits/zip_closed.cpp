#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/splits/closed_split.h"
#include "far/topology/splits/zip_rules.h"

/// Zip on a closed mesh. With n and p the next and previous half-edge of h in its face and t its twin, every old
/// half-edge h makes three:
///     A  v'_h -> v'_n   in the face-face of face(h)       twin: C of n
///     B  v'_h -> v'_t   in the vertex-face of vert(n)     twin: B of t
///     C  v'_h -> v'_p   in the vertex-face of vert(h)     twin: A of p
/// Stored as loops: A of h keeps the id h, so face-faces keep their place; behind them vertex v's loop is one block
///     C(h_0) B(prev h_0) C(h_1) B(prev h_1) ...           h_0 = outgoing(v), h_{i+1} = twin(prev h_i)
/// at H + 6v where all vertices are three-valent, else at a prefix sum over the vertices sorted by valence.
namespace honeycomb::Far {

namespace {

/// The loop of v at `slot`, and for each of its edges where its B half went.
void writeVertexFace(const Topology& parent, std::int32_t v, std::int32_t face, std::int32_t slot,
                     TopologyArrays& child, Array<std::int32_t>& bridge) {
  child.faceOffsets[at(face)] = slot;
  child.parents[at(face)] = v;
  for (const std::int32_t h : parent.halfEdgesFrom(v)) {
    const std::int32_t p = parent.prev(h);
    child.vert[at(slot)] = h;
    child.twin[at(slot)] = p;
    child.face[at(slot)] = face;
    child.twin[at(p)] = slot;
    child.vert[at(slot + 1)] = p;
    child.face[at(slot + 1)] = face;
    bridge[at(p)] = slot + 1;
    slot += 2;
  }
}

}  // namespace

SplitResult zipClosed(const Topology& parent) {
  const std::int32_t halfEdges = parent.halfEdgeCount();
  const VertexBlocks blocks(parent, 2, parent.faceCount(), halfEdges);
  TopologyArrays child;
  child.threeValent = true;
  child.runs.assign(parent.runs().begin(), parent.runs().end());
  for (FaceRun& run : child.runs) run.parent = FaceParent::face;
  blocks.appendRuns(child.runs);
  resizeArrays(child, 3 * halfEdges, parent.faceCount() + parent.vertexCount(), halfEdges);
  writeFaceFaces(parent, 1, child);
  Array<std::int32_t> bridge(at(halfEdges));  // per half-edge: the id of its B
  Parallel::forEach(
      0, parent.vertexCount(),
      [&](std::int64_t i) {
        const auto v = static_cast<std::int32_t>(i);
        writeVertexFace(parent, v, blocks.face(v), blocks.halfEdge(v), child, bridge);
      },
      1024);
  Parallel::forEach(0, halfEdges, [&](std::int64_t i) {
    const auto h = static_cast<std::int32_t>(i);
    child.vert[at(h)] = h;
    child.face[at(h)] = parent.face(h);
    child.outgoing[at(h)] = h;
    child.twin[at(bridge[at(h)])] = bridge[at(parent.twin(h))];
  });
  return {Topology(std::move(child)), halfEdges, {}};
}

}  // namespace honeycomb::Far
