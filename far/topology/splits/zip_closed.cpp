#include <algorithm>
#include <array>
#include <span>
#include <vector>

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
///
/// The links are left for when they are asked for. A step from a level made here does not ask: where the C half-edges
/// stand says all that the walk round a vertex needs.
namespace honeycomb::Far {

namespace {

/// Faces that a task takes at least.
constexpr std::int64_t kFaceGrain = 1024;

/// Calls visit(f) for the faces made from vertices, concurrently.
template <class Visit>
void forVertexFaces(std::span<const FaceRun> runs, const Visit& visit) {
  for (const FaceRun& run : runs) {
    if (run.parent != FaceParent::vertex) continue;
    Parallel::forEach(
        run.firstFace, std::int64_t{run.firstFace} + run.faceCount,
        [&](std::int64_t f) { visit(static_cast<std::int32_t>(f)); }, kFaceGrain);
  }
}

/// From the loops alone. C(n) stands before B(h): what is known of A's twins gives those of B.
HalfEdgeLinks zipLinks(const TopologyArrays& level) {
  HalfEdgeLinks links;
  links.twin.resize(level.vert.size());
  links.face.resize(level.vert.size());
  links.outgoing.resize(at(level.vertexCount));
  const Array<std::int32_t>& vert = level.vert;
  forVertexFaces(level.runs, [&](std::int32_t f) {
    for (std::int32_t c = level.faceOffsets[at(f)]; c < level.faceOffsets[at(f) + 1]; c += 2) {
      links.twin[at(c)] = vert[at(c + 1)];
      links.twin[at(vert[at(c + 1)])] = c;
    }
  });
  forVertexFaces(level.runs, [&](std::int32_t f) {
    const std::int32_t first = level.faceOffsets[at(f)];
    const std::int32_t end = level.faceOffsets[at(f) + 1];
    for (std::int32_t b = first + 1; b < end; b += 2) {
      const std::int32_t across = vert[at(b + 1 == end ? first : b + 1)];
      links.twin[at(b)] = links.twin[at(across)] + 1;
    }
  });
  Parallel::forEach(
      0, static_cast<std::int64_t>(level.parents.size()),
      [&](std::int64_t f) {
        std::fill(links.face.begin() + level.faceOffsets[at(f)], links.face.begin() + level.faceOffsets[at(f) + 1],
                  static_cast<std::int32_t>(f));
      },
      kFaceGrain);
  Parallel::forEach(0, level.vertexCount,
                    [&](std::int64_t h) { links.outgoing[at(h)] = static_cast<std::int32_t>(h); });
  return links;
}

/// The half-edge C(v) of a level that zipClosed made, and the one before it in its loop.
struct CornerHalfEdges {
  std::int32_t c = 0, before = 0;
};

/// Per vertex, from the loops alone.
Array<CornerHalfEdges> cornerHalfEdges(const Topology& level) {
  Array<CornerHalfEdges> corners(at(level.vertexCount()));
  const std::span<const std::int32_t> vert = level.vert();
  const std::span<const std::int32_t> offsets = level.faceOffsets();
  forVertexFaces(level.runs(), [&](std::int32_t f) {
    std::int32_t before = offsets[at(f) + 1] - 1;
    for (std::int32_t c = offsets[at(f)]; c < offsets[at(f) + 1]; c += 2) {
      corners[at(vert[at(c)])] = {c, before};
      before = c + 1;
    }
  });
  return corners;
}

void writeVertexFace(const Topology& parent, std::int32_t v, std::int32_t slot, TopologyArrays& child) {
  for (const std::int32_t h : parent.halfEdgesFrom(v)) {
    child.vert[at(slot++)] = h;
    child.vert[at(slot++)] = parent.prev(h);
  }
}

void writeVertexFaces(const Topology& parent, const VertexBlocks& blocks, TopologyArrays& child) {
  const auto write = [&](std::int64_t i) {
    const auto v = static_cast<std::int32_t>(i);
    const std::size_t face = at(blocks.face(v));
    child.faceOffsets[face] = blocks.halfEdge(v);
    child.parents[face] = v;
    writeVertexFace(parent, v, blocks.halfEdge(v), child);
  };
  Parallel::forEach(0, parent.vertexCount(), write, kFaceGrain);
}

/// The same behind a step of zipClosed. A(v) of the parent leaves its vertex v, A(p) before it. C(v) = s is A(p)'s
/// twin, C(next v) = t that of A(v): the three half-edges from v are v, s and B(v) = t + 1, those before them p, s's
/// and t.
void writeZippedFaces(const Topology& parent, TopologyArrays& child) {
  const Array<CornerHalfEdges> corners = cornerHalfEdges(parent);
  const std::int32_t firstFace = parent.faceCount();
  const std::int32_t firstSlot = parent.halfEdgeCount();
  const auto writeFace = [&](std::int32_t v, std::int32_t p, std::int32_t next) {
    const auto [s, beforeS] = corners[at(v)];
    const std::int32_t t = corners[at(next)].c;
    const std::int32_t slot = firstSlot + 6 * v;
    child.faceOffsets[at(firstFace + v)] = slot;
    child.parents[at(firstFace + v)] = v;
    const std::array<std::int32_t, 6> loop{v, p, s, beforeS, t + 1, t};
    std::copy(loop.begin(), loop.end(), &child.vert[at(slot)]);
  };
  const auto writeFaces = [&](std::int64_t f) {
    const std::int32_t first = parent.faceOffsets()[at(f)];
    const std::int32_t last = parent.faceOffsets()[at(f) + 1] - 1;
    writeFace(first, last, first + 1);
    for (std::int32_t v = first + 1; v < last; ++v) writeFace(v, v - 1, v + 1);
    writeFace(last, last - 1, first);
  };
  for (const FaceRun& run : parent.runs()) {
    if (run.parent != FaceParent::face) continue;
    Parallel::forEach(run.firstFace, std::int64_t{run.firstFace} + run.faceCount, writeFaces, kFaceGrain);
  }
}

}  // namespace

SplitResult zipClosed(const Topology& parent) {
  const std::int32_t halfEdges = parent.halfEdgeCount();
  const VertexBlocks blocks(parent, 2, parent.faceCount(), halfEdges);
  TopologyArrays child;
  child.linkRule = zipLinks;
  child.threeValent = true;
  child.vertexCount = halfEdges;
  appendFaceRuns(parent, 1, child.runs);
  blocks.appendRuns(child.runs);
  resizeLoops(child, 3 * halfEdges, parent.faceCount() + parent.vertexCount());
  writeFaceFaces(parent, 1, child);
  Parallel::forEach(0, halfEdges, [&](std::int64_t h) { child.vert[at(h)] = static_cast<std::int32_t>(h); });
  if (parent.linkRule() == zipLinks) {
    writeZippedFaces(parent, child);
  } else {
    writeVertexFaces(parent, blocks, child);
  }
  return {Topology(std::move(child)), halfEdges, {}};
}

}  // namespace honeycomb::Far
