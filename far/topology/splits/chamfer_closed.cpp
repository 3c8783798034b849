#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/splits/closed_forms.h"
#include "far/topology/splits/closed_split.h"

/// Chamfer on a closed mesh, with the slots of chamfer_slots.h. A of h keeps the id h; behind them stand the hexagons
/// of the edges, each in two halves, the higher half-edge's first, at
///     H + 6 edge(h) [+ 3 for the lower half-edge]:   D(next h)  B(h)  C(h)
namespace honeycomb::Far {

namespace {

class ChamferClosed {
 public:
  explicit ChamferClosed(const Topology& parent) : parent_(parent), edges_(parent) {}

  SplitResult split() {
    const std::int32_t halfEdges = parent_.halfEdgeCount();
    const std::int32_t faces = parent_.faceCount();
    child_.threeValent = parent_.threeValent();
    appendFaceRuns(parent_, 1, child_.runs);
    appendRun(child_.runs, {FaceKind::full, FaceParent::edge, 6, faces, halfEdges, halfEdges / 2});
    resizeArrays(child_, 4 * halfEdges, faces + halfEdges / 2, halfEdges + parent_.vertexCount());
    writeFaceFaces(parent_, 1, child_);
    Parallel::forEach(
        0, faces, [&](std::int64_t f) { writeFace(static_cast<std::int32_t>(f)); }, 1024);
    Array<NewPoint> points(at(parent_.vertexCount()));
    Parallel::forEach(
        0, parent_.vertexCount(), [&](std::int64_t v) { points[at(v)] = writeVertex(static_cast<std::int32_t>(v)); },
        1024);
    return {Topology(std::move(child_)), halfEdges, std::move(points)};
  }

 private:
  /// Where D of the next half-edge goes, with B and C of h behind it.
  std::int32_t block(std::int32_t h) const { return parent_.halfEdgeCount() + 3 * edges_.half(h); }

  void write(std::int32_t id, std::int32_t vert, std::int32_t twin, std::int32_t face) {
    child_.vert[at(id)] = vert;
    child_.twin[at(id)] = twin;
    child_.face[at(id)] = face;
  }

  void writeFace(std::int32_t f) {
    const std::int32_t first = parent_.faceOffsets()[at(f)];
    const std::int32_t last = parent_.faceOffsets()[at(f) + 1] - 1;
    for (std::int32_t h = first; h <= last; ++h) {
      writeHalf(h, h == last ? first : h + 1, h == first ? last : h - 1, f);
    }
  }

  void writeHalf(std::int32_t h, std::int32_t next, std::int32_t prev, std::int32_t f) {
    const std::int32_t id = block(h);
    const std::int32_t hexagon = parent_.faceCount() + edges_.edge(h);
    write(h, h, id + 1, f);
    write(id, parent_.halfEdgeCount() + parent_.vert(next), block(next) + 2, hexagon);
    write(id + 1, next, h, hexagon);
    write(id + 2, h, block(prev), hexagon);
    child_.outgoing[at(h)] = h;
    if (!edges_.leads(h)) return;
    child_.parents[at(hexagon)] = h;
    child_.faceOffsets[at(hexagon)] = id - 3;
  }

  NewPoint writeVertex(std::int32_t v) {
    std::int32_t lowest = 4 * parent_.halfEdgeCount();
    for (const std::int32_t h : parent_.halfEdgesFrom(v)) lowest = std::min(lowest, block(parent_.prev(h)));
    child_.outgoing[at(parent_.halfEdgeCount() + v)] = lowest;
    return {PointKind::vertexPoint, parent_.outgoing(v)};
  }

  const Topology& parent_;
  EdgeRanks edges_;
  TopologyArrays child_;
};

}  // namespace

SplitResult chamferClosed(const Topology& parent) {
  return ChamferClosed(parent).split();
}

}  // namespace honeycomb::Far
