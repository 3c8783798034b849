#include <algorithm>
#include <cstddef>
#include <numeric>
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

/// Calls visit(first, end) for the loops of the faces made from vertices, concurrently.
template <class Visit>
void forVertexFaces(std::span<const FaceRun> runs, const Visit& visit) {
  for (const FaceRun& run : runs) {
    if (run.parent != FaceParent::vertex) continue;
    Parallel::forRange(0, run.faceCount, kFaceGrain, [&run, visit](std::int64_t begin, std::int64_t end) {
      auto h = run.firstHalfEdge + static_cast<std::int32_t>(begin) * run.sides;
      for (std::int64_t g = begin; g < end; ++g, h += run.sides) visit(h, h + run.sides);
    });
  }
}

void writeIdentity(std::int32_t* numbers, std::int32_t count) {
  Parallel::forRange(0, count, Parallel::kGrain, [numbers](std::int64_t begin, std::int64_t end) {
    std::iota(numbers + begin, numbers + end, static_cast<std::int32_t>(begin));
  });
}

/// From the loops alone. C(n) stands before B(h): what is known of A's twins gives those of B.
HalfEdgeLinks zipLinks(const TopologyArrays& level) {
  HalfEdgeLinks links;
  links.twin.resize(level.vert.size());
  links.face.resize(level.vert.size());
  links.outgoing.resize(at(level.vertexCount));
  const std::int32_t* vert = level.vert.data();
  std::int32_t* twin = links.twin.data();
  forVertexFaces(level.runs, [vert, twin](std::int32_t first, std::int32_t end) {
    for (std::int32_t c = first; c < end; c += 2) {
      twin[c] = vert[c + 1];
      twin[vert[c + 1]] = c;
    }
  });
  forVertexFaces(level.runs, [vert, twin](std::int32_t first, std::int32_t end) {
    for (std::int32_t b = first + 1; b < end; b += 2) twin[b] = twin[vert[b + 1 == end ? first : b + 1]] + 1;
  });
  Parallel::forEach(
      0, static_cast<std::int64_t>(level.parents.size()),
      [&](std::int64_t f) {
        std::fill(links.face.begin() + level.faceOffsets[at(f)], links.face.begin() + level.faceOffsets[at(f) + 1],
                  static_cast<std::int32_t>(f));
      },
      kFaceGrain);
  writeIdentity(links.outgoing.data(), level.vertexCount);
  return links;
}

/// The half-edge C(v) of a level made by zipClosed, and the one before it in its loop.
struct CornerHalfEdges {
  std::int32_t c = 0, before = 0;
};

/// Per vertex, from the loops alone.
Array<CornerHalfEdges> cornerHalfEdges(const Topology& level) {
  Array<CornerHalfEdges> corners(at(level.vertexCount()));
  const std::int32_t* vert = level.vert().data();
  CornerHalfEdges* out = corners.data();
  forVertexFaces(level.runs(), [vert, out](std::int32_t first, std::int32_t end) {
    std::int32_t before = end - 1;
    for (std::int32_t c = first; c < end; c += 2) {
      out[vert[c]] = {c, before};
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

/// The loops of the faces that the vertices of a level made by zipClosed become. A(v) of the level leaves its vertex v,
/// A(p) stands before it. C(v) = s is A(p)'s twin, C(next v) = t that of A(v): the three half-edges from v are v, s and
/// B(v) = t + 1, those before them p, s's and t. Plain pointers: a number that is written could not change them.
class ZippedFaces {
 public:
  ZippedFaces(const Topology& parent, const Array<CornerHalfEdges>& corners, TopologyArrays& child)
      : corners_(corners.data()),
        firstSlot_(parent.halfEdgeCount()),
        vert_(child.vert.data() + firstSlot_),
        offsets_(child.faceOffsets.data() + parent.faceCount()),
        parents_(child.parents.data() + parent.faceCount()) {}

  /// The faces of the vertices first .. end - 1, which are a loop.
  void write(std::int32_t first, std::int32_t end) const {
    std::int32_t p = end - 1;
    CornerHalfEdges here = corners_[first];
    const std::int32_t around = here.c;
    for (std::int32_t v = first; v < end; p = v++) {
      const CornerHalfEdges next = v + 1 < end ? corners_[v + 1] : CornerHalfEdges{around, 0};
      const std::ptrdiff_t place = std::ptrdiff_t{6} * v;
      offsets_[v] = firstSlot_ + static_cast<std::int32_t>(place);
      parents_[v] = v;
      std::int32_t* loop = vert_ + place;
      loop[0] = v;
      loop[1] = p;
      loop[2] = here.c;
      loop[3] = here.before;
      loop[4] = next.c + 1;
      loop[5] = next.c;
      here = next;
    }
  }

 private:
  const CornerHalfEdges* corners_;
  std::int32_t firstSlot_;
  std::int32_t* vert_;
  std::int32_t* offsets_;
  std::int32_t* parents_;
};

void writeZippedFaces(const Topology& parent, TopologyArrays& child) {
  const Array<CornerHalfEdges> corners = cornerHalfEdges(parent);
  const ZippedFaces faces(parent, corners, child);
  for (const FaceRun& run : parent.runs()) {
    if (run.parent != FaceParent::face) continue;
    Parallel::forRange(0, run.faceCount, kFaceGrain, [&run, faces](std::int64_t begin, std::int64_t end) {
      auto v = run.firstHalfEdge + static_cast<std::int32_t>(begin) * run.sides;
      for (std::int64_t g = begin; g < end; ++g, v += run.sides) faces.write(v, v + run.sides);
    });
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
  writeIdentity(child.vert.data(), halfEdges);
  if (parent.linkRule() == zipLinks) {
    writeZippedFaces(parent, child);
  } else {
    writeVertexFaces(parent, blocks, child);
  }
  return {Topology(std::move(child)), halfEdges, {}};
}

}  // namespace honeycomb::Far
