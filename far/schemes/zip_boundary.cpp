#include "far/schemes/zip_boundary.h"

#include <utility>

namespace honeycomb::Far {

namespace {

/// The point of a cut next to its end `near`.
void addCutPoint(const Topology& parent, std::int32_t near, std::int32_t far, Row& row) {
  const bool mid = parent.vertexTag(near) == VertexTag::mid;
  const bool toCorner = parent.vertexTag(far) == VertexTag::fixedCorner;
  double w = mid ? 1.0 / 6 : 1.0 / 4;
  if (toCorner) w = mid ? 1.0 / 3 : 1.0 / 2;
  row.insert(row.end(), {{near, 1 - w}, {far, w}});
}

/// The fixed corner of the face of h: its loop starts with the edge into the corner.
std::int32_t cornerOfFace(const Topology& parent, std::int32_t h) {
  return parent.vert(parent.faceOffsets()[static_cast<std::size_t>(parent.face(h))] + 1);
}

}  // namespace

void addZipBoundaryRow(const Topology& parent, const NewPoint& point, double vertexWeight, Row& row) {
  const std::int32_t v = parent.vert(point.halfEdge);
  const std::int32_t w = parent.dest(point.halfEdge);
  switch (point.kind) {
    case PointKind::edgeMiddle:
      row.insert(row.end(), {{v, 0.5}, {w, 0.5}});
      return;
    case PointKind::cutStart:
      return addCutPoint(parent, v, w, row);
    case PointKind::cutEnd:
      return addCutPoint(parent, w, v, row);
    case PointKind::fixedCorner:
      row.push_back({v, 1.0});
      return;
    case PointKind::cornerFaceCorner:
      row.insert(row.end(), {{cornerOfFace(parent, point.halfEdge), 1.0 / 3}, {v, 1.0 / 3}, {w, 1.0 / 3}});
      return;
    case PointKind::boundaryVertex:
      row.insert(
          row.end(),
          {{v, 1 - vertexWeight}, {w, vertexWeight / 2}, {parent.vert(parent.enteringBoundary(v)), vertexWeight / 2}});
      return;
    default:
      return;
  }
}

CreaseRule zipCreases(BoundaryRule boundary) {
  return {CreaseRule::Reach::any, boundary == BoundaryRule::brick, zip(BoundaryRule::brick)};
}

}  // namespace honeycomb::Far
