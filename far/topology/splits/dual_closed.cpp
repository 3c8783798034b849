#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/splits/closed_forms.h"
#include "far/topology/splits/closed_split.h"

/// The dual of a closed mesh, with the slots of dual.cpp: the loops of the vertices, h_0 h_1 .. with h_0 = outgoing(v).
namespace honeycomb::Far {

SplitResult dualClosed(const Topology& parent) {
  const VertexBlocks blocks(parent, 1, 0, 0);
  TopologyArrays child;
  blocks.appendRuns(child.runs);
  resizeArrays(child, parent.halfEdgeCount(), parent.vertexCount(), parent.faceCount());
  Array<std::int32_t> id(at(parent.halfEdgeCount()));  // per half-edge of the parent
  Parallel::forEach(
      0, parent.vertexCount(),
      [&](std::int64_t i) {
        const auto v = static_cast<std::int32_t>(i);
        const std::int32_t face = blocks.face(v);
        std::int32_t slot = blocks.halfEdge(v);
        child.parents[at(face)] = v;
        child.faceOffsets[at(face)] = slot;
        for (const std::int32_t h : parent.halfEdgesFrom(v)) {
          child.vert[at(slot)] = parent.face(h);
          child.face[at(slot)] = face;
          id[at(h)] = slot++;
        }
      },
      1024);
  Parallel::forEach(0, parent.halfEdgeCount(), [&](std::int64_t i) {
    const auto h = static_cast<std::int32_t>(i);
    child.twin[at(id[at(h)])] = id[at(parent.next(parent.twin(parent.prev(h))))];
  });
  Array<NewPoint> points(at(parent.faceCount()));
  Parallel::forEach(
      0, parent.faceCount(),
      [&](std::int64_t f) {
        const auto first = id.begin() + parent.faceOffsets()[at(f)];
        child.outgoing[at(f)] = *std::min_element(first, id.begin() + parent.faceOffsets()[at(f) + 1]);
        points[at(f)] = {PointKind::faceCentre, parent.faceOffsets()[at(f)]};
      },
      1024);
  return {Topology(std::move(child)), 0, std::move(points)};
}

}  // namespace honeycomb::Far
