#include "far/schemes/zip_boundary.h"

#include <utility>

namespace honeycomb::Far {

namespace {

/// The point of a cut next to its end `near`.
Row cutPoint(const Topology& parent, std::int32_t near, std::int32_t far) {
  const bool mid = parent.vertexTag(near) == VertexTag::mid;
  const bool toCorner = parent.vertexTag(far) == VertexTag::fixedCorner;
  double w = mid ? 1.0 / 6 : 1.0 / 4;
  if (toCorner) w = mid ? 1.0 / 3 : 1.0 / 2;
  return {{near, 1 - w}, {far, w}};
}

/// The fixed corner of the face of h: its loop starts with the edge into the corner.
std::int32_t cornerOfFace(const Topology& parent, std::int32_t h) {
  return parent.vert(parent.faceOffsets()[static_cast<std::size_t>(parent.face(h))] + 1);
}

}  // namespace

Row zipBoundaryRow(const Topology& parent, const NewPoint& point, double vertexWeight) {
  const std::int32_t v = parent.vert(point.halfEdge);
  const std::int32_t w = parent.dest(point.halfEdge);
  switch (point.kind) {
    case PointKind::edgeMiddle:
      return {{v, 0.5}, {w, 0.5}};
    case PointKind::cutStart:
      return cutPoint(parent, v, w);
    case PointKind::cutEnd:
      return cutPoint(parent, w, v);
    case PointKind::fixedCorner:
      return {{v, 1.0}};
    case PointKind::cornerFaceCorner:
      return {{cornerOfFace(parent, point.halfEdge), 1.0 / 3}, {v, 1.0 / 3}, {w, 1.0 / 3}};
    case PointKind::boundaryVertex:
      return {
          {v, 1 - vertexWeight}, {w, vertexWeight / 2}, {parent.vert(parent.enteringBoundary(v)), vertexWeight / 2}};
    case PointKind::halfFaceCorner:
      break;
  }
  return {};
}

}  // namespace honeycomb::Far
