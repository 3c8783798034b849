#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/splits/closed_forms.h"
#include "far/topology/splits/closed_split.h"

/// Expand on a closed mesh, with the slots of expand.cpp. A of h keeps the id h; behind them stand the loops of the
/// vertices, D(h_0) D(h_1) .. with h_0 = outgoing(v), from H on, and from 2H on the quads of the edges, each in two
/// halves, the lower half-edge's first:   B(h) C(h)
namespace honeycomb::Far {

namespace {

class ExpandClosed {
 public:
  explicit ExpandClosed(const Topology& parent)
      : parent_(parent),
        edges_(parent),
        firstQuad_(parent.faceCount() + parent.vertexCount()),
        blocks_(parent, 1, parent.faceCount(), parent.halfEdgeCount()) {}

  SplitResult split() {
    const std::int32_t halfEdges = parent_.halfEdgeCount();
    appendFaceRuns(parent_, 1, child_.runs);
    blocks_.appendRuns(child_.runs);
    appendRun(child_.runs, {FaceKind::full, FaceParent::edge, 4, firstQuad_, 2 * halfEdges, halfEdges / 2});
    resizeArrays(child_, 4 * halfEdges, firstQuad_ + halfEdges / 2, halfEdges);
    writeFaceFaces(parent_, 1, child_);
    Parallel::forEach(0, halfEdges, [&](std::int64_t h) { writeHalf(static_cast<std::int32_t>(h)); });
    Parallel::forEach(
        0, parent_.vertexCount(), [&](std::int64_t v) { writeVertex(static_cast<std::int32_t>(v)); }, 1024);
    return {Topology(std::move(child_)), halfEdges, {}};
  }

 private:
  /// Where B of h goes, with C behind it.
  std::int32_t block(std::int32_t h) const { return 2 * parent_.halfEdgeCount() + 2 * (edges_.half(h) ^ 1); }

  /// All of A, B, C but C's twin.
  void writeHalf(std::int32_t h) {
    const std::int32_t b = block(h);
    const std::int32_t quad = firstQuad_ + edges_.edge(h);
    child_.vert[at(h)] = h;
    child_.twin[at(h)] = b;
    child_.face[at(h)] = parent_.face(h);
    child_.outgoing[at(h)] = h;
    child_.vert[at(b)] = parent_.next(h);
    child_.twin[at(b)] = h;
    child_.face[at(b)] = quad;
    child_.vert[at(b + 1)] = h;
    child_.face[at(b + 1)] = quad;
    if (!edges_.leads(h)) return;
    child_.parents[at(quad)] = h;
    child_.faceOffsets[at(quad)] = b;
  }

  void writeVertex(std::int32_t v) {
    const std::int32_t face = blocks_.face(v);
    std::int32_t d = blocks_.halfEdge(v);
    child_.parents[at(face)] = v;
    child_.faceOffsets[at(face)] = d;
    for (const std::int32_t h : parent_.halfEdgesFrom(v)) {
      const std::int32_t c = block(h) + 1;
      child_.vert[at(d)] = parent_.next(parent_.twin(h));
      child_.twin[at(d)] = c;
      child_.face[at(d)] = face;
      child_.twin[at(c)] = d++;
    }
  }

  const Topology& parent_;
  EdgeRanks edges_;
  std::int32_t firstQuad_;
  VertexBlocks blocks_;
  TopologyArrays child_;
};

}  // namespace

SplitResult expandClosed(const Topology& parent) {
  return ExpandClosed(parent).split();
}

}  // namespace honeycomb::Far
