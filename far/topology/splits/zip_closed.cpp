#include <algorithm>
#include <numeric>

#include "far/base/index.h"
#include "far/base/parallel.h"
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

/// Where the loop of each vertex goes.
struct VertexBlocks {
  std::vector<std::int32_t> place;  ///< per vertex: its vertex-face, counted from the first
  std::vector<std::int32_t> base;   ///< per vertex: first half-edge of its loop
};

std::vector<std::int32_t> valences(const Topology& parent) {
  std::vector<std::int32_t> valence(at(parent.vertexCount()));
  Parallel::forEach(0, parent.vertexCount(),
                    [&](std::int64_t v) { valence[at(v)] = parent.facesAt(static_cast<std::int32_t>(v)); });
  return valence;
}

/// Sorts the vertices by valence and appends the runs of their faces.
VertexBlocks sortByValence(const Topology& parent, TopologyArrays& child) {
  const std::vector<std::int32_t> valence = valences(parent);
  const std::int32_t largest = *std::max_element(valence.begin(), valence.end());
  const Array<std::int32_t> order = Parallel::stableOrder(valence, largest + 1);
  VertexBlocks blocks{std::vector<std::int32_t>(order.size()), std::vector<std::int32_t>(order.size())};
  std::int32_t base = parent.halfEdgeCount();
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::int32_t sides = 2 * valence[at(order[i])];
    const auto face = parent.faceCount() + static_cast<std::int32_t>(i);
    if (i == 0 || child.runs.back().sides != sides) {
      child.runs.push_back({FaceKind::full, FaceParent::vertex, sides, face, base, 0});
    }
    ++child.runs.back().faceCount;
    blocks.place[at(order[i])] = static_cast<std::int32_t>(i);
    blocks.base[at(order[i])] = base;
    base += sides;
  }
  return blocks;
}

VertexBlocks hexagonBlocks(const Topology& parent, TopologyArrays& child) {
  const std::int32_t count = parent.vertexCount();
  child.runs.push_back({FaceKind::full, FaceParent::vertex, 6, parent.faceCount(), parent.halfEdgeCount(), count});
  VertexBlocks blocks{std::vector<std::int32_t>(at(count)), std::vector<std::int32_t>(at(count))};
  Parallel::forEach(0, count, [&](std::int64_t v) {
    blocks.place[at(v)] = static_cast<std::int32_t>(v);
    blocks.base[at(v)] = parent.halfEdgeCount() + 6 * static_cast<std::int32_t>(v);
  });
  return blocks;
}

void writeFaceFaces(const Topology& parent, TopologyArrays& child) {
  Parallel::forEach(0, parent.halfEdgeCount(), [&](std::int64_t h) {
    child.vert[at(h)] = static_cast<std::int32_t>(h);
    child.face[at(h)] = parent.face()[at(h)];
  });
  Parallel::forEach(0, parent.faceCount(), [&](std::int64_t f) {
    child.faceOffsets[at(f)] = parent.faceOffsets()[at(f)];
    child.parents[at(f)] = static_cast<std::int32_t>(f);
  });
}

/// The loop of v, and for each of its edges where its B half went.
void writeVertexFace(const Topology& parent, std::int32_t v, std::int32_t face, std::int32_t base,
                     TopologyArrays& child, std::vector<std::int32_t>& bridge) {
  child.faceOffsets[at(face)] = base;
  child.parents[at(face)] = v;
  std::int32_t slot = base;
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
  TopologyArrays child;
  child.vertexCount = halfEdges;
  child.threeValent = true;
  child.runs.assign(parent.runs().begin(), parent.runs().end());
  for (FaceRun& run : child.runs) run.parent = FaceParent::face;
  const VertexBlocks blocks = parent.threeValent() ? hexagonBlocks(parent, child) : sortByValence(parent, child);

  const std::int32_t faces = parent.faceCount() + parent.vertexCount();
  for (auto* perHalfEdge : {&child.vert, &child.twin, &child.face}) perHalfEdge->resize(3 * at(halfEdges));
  child.faceOffsets.resize(at(faces) + 1);
  child.faceOffsets.back() = 3 * halfEdges;
  child.parents.resize(at(faces));
  child.outgoing.resize(at(halfEdges));
  std::iota(child.outgoing.begin(), child.outgoing.end(), 0);

  writeFaceFaces(parent, child);
  std::vector<std::int32_t> bridge(at(halfEdges));  // per half-edge: the id of its B
  Parallel::forEach(
      0, parent.vertexCount(),
      [&](std::int64_t v) {
        writeVertexFace(parent, static_cast<std::int32_t>(v), parent.faceCount() + blocks.place[at(v)],
                        blocks.base[at(v)], child, bridge);
      },
      1024);
  Parallel::forEach(0, halfEdges,
                    [&](std::int64_t h) { child.twin[at(bridge[at(h)])] = bridge[at(parent.twin()[at(h)])]; });
  return {Topology(std::move(child)), halfEdges, {}};
}

}  // namespace honeycomb::Far
