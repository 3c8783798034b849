#include "far/schemes/half_box_clamped.h"

#include <cmath>
#include <numbers>

#include "far/base/index.h"
#include "far/topology/clamped_face.h"
#include "far/topology/splits/chamfer_clamped.h"
#include "far/topology/splits/clamp.h"

namespace honeycomb::Far {

namespace {

void addBesideEdge(const Topology& topology, std::int32_t h, Row& row) {
  const std::int32_t n = topology.next(h);
  row.insert(row.end(), {{topology.vert(h), 1.0 / 3},
                         {topology.vert(n), 1.0 / 3},
                         {topology.vert(topology.prev(h)), 1.0 / 6},
                         {topology.dest(n), 1.0 / 6}});
}

void addClampRow(const SourceLevel& parent, const NewPoint& point, Row& row) {
  const Topology& topology = parent.topology();
  switch (point.kind) {
    case PointKind::besideEdge:
      addBesideEdge(topology, point.halfEdge, row);
      return mergeEntries(row);
    case PointKind::faceCentre:
      return parent.addBarycentre(topology.face(point.halfEdge), 1, row);
    default:
      row.push_back({topology.vert(point.halfEdge), 1});
  }
}

/// Appends weight times J.
void addJoint(const ClampedFace& face, double weight, Row& row) {
  if (face.isCorner()) {
    row.push_back({face.joint(), weight});
  } else {
    row.insert(row.end(), {{face.left(), weight / 2}, {face.right(), weight / 2}});
  }
}

/// L' and R' of a face, Lm and Rm of a gap: half of the point on that side, and the two beside it.
void addCurveRow(const Topology& topology, const NewPoint& point, Row& row) {
  const std::int32_t h = point.halfEdge;
  const std::int32_t f = topology.face(h);
  const bool atStart = point.kind == PointKind::cutStart;
  const std::int32_t near = atStart ? topology.vert(h) : topology.dest(h);
  if (topology.run(f).kind != FaceKind::clampedGap) {
    row.push_back({near, 0.5});
    return addJoint(ClampedFace(topology, f), 0.5, row);
  }
  row.insert(row.end(), {{near, 0.5}, {atStart ? topology.dest(h) : topology.vert(h), 0.25}});
  addJoint(ClampedFace(topology, atStart ? faceBeforeGap(topology, h) : faceAfterGap(topology, h)), 0.25, row);
}

/// Appends weight times pi_i.
void addMirrorPoint(const ClampedFace& face, std::int32_t i, double weight, Row& row) {
  const double c = clampedMirrorCosine(i, face.insideCount());
  const double beside = weight * std::abs(c) / 2;
  addJoint(face, weight * (1 - std::abs(c)), row);
  if (c > 0) row.insert(row.end(), {{face.right(), beside}, {face.leftAfter(), beside}});
  if (c < 0) row.insert(row.end(), {{face.left(), beside}, {face.rightBefore(), beside}});
}

void addMirroredRow(const ClampedFace& face, std::int32_t i, Row& row) {
  const std::int32_t m = face.insideCount();
  const std::vector<double> weights = firstRow(halfBoxRule(2 * m), 2 * m);
  for (std::int32_t j = 0; j < m; ++j) {
    const double there = weights[at((j - i + 2 * m) % (2 * m))];
    const double image = weights[at(2 * m - 1 - j - i)];
    row.push_back({face.inside(j), there - image});
    addMirrorPoint(face, j, 2 * image, row);
  }
}

/// S1 of the polygon that the inside vertices and, opposite some of them, images or J itself make.
void addConvexCornerRow(const ClampedFace& face, std::int32_t i, Row& row) {
  const std::int32_t m = face.insideCount();
  const std::int32_t sides = clampedCornerPolygon(m);
  const std::vector<double> weights = firstRow(halfBoxRule(sides), sides);
  std::vector<double> inside(at(m));
  double joint = 0;
  for (std::int32_t j = 0; j < sides; ++j) {
    const double w = weights[at((j - i + sides) % sides)];
    if (j < m) {
      inside[at(j)] += w;
    } else if (sides == 6) {
      inside[at(j - 3)] -= w;
      joint += 2 * w;
    } else {
      joint += w;
    }
  }
  for (std::int32_t j = 0; j < m; ++j) row.push_back({face.inside(j), inside[at(j)]});
  row.push_back({face.joint(), joint});
}

/// In the plane, with R at the angle 0 and L at m phi from J, q_i lies at (i + 1/2) phi, at 3/(2 cos(phi/2)) times
/// their distance: that is alpha_i (R-J) + beta_i (L-J).
void addSmoothCornerRow(const ClampedFace& face, std::int32_t i, Row& row) {
  const std::int32_t m = face.insideCount();
  const double phi = 2 * std::numbers::pi / clampedCornerPolygon(m);
  const double distance = 3 / (2 * std::cos(phi / 2));
  const double beta = distance * std::sin((i + 0.5) * phi) / std::sin(m * phi);
  const double alpha = distance * std::cos((i + 0.5) * phi) - beta * std::cos(m * phi);
  row.insert(row.end(), {{face.inside(i), 0.25},
                         {face.joint(), (3 - alpha - beta) / 4},
                         {face.right(), alpha / 4},
                         {face.left(), beta / 4}});
}

void addCornerRow(const ClampedFace& face, std::int32_t i, HalfBoxCorners corners, Row& row) {
  switch (face.insideCount()) {
    case 1:
      row.insert(row.end(), {{face.inside(0), 0.25}, {face.joint(), 0.25}, {face.left(), 0.25}, {face.right(), 0.25}});
      return;
    case 2:
      row.insert(row.end(),
                 {{face.inside(i), 0.25}, {face.right(), i == 0 ? 0.5 : 0.25}, {face.left(), i == 0 ? 0.25 : 0.5}});
      return;
    case 3:
      return addMirroredRow(face, i, row);
    default:
      return corners == HalfBoxCorners::smooth ? addSmoothCornerRow(face, i, row) : addConvexCornerRow(face, i, row);
  }
}

/// S2 of the inside vertex that h leaves. Beside an edge to L of a gap follows, counter-clockwise, that to its R.
void addInsideVertexRow(const Topology& topology, std::int32_t first, const TunedWeights& tuned, Row& row) {
  const Topology::OutgoingHalfEdges around(topology, first);
  std::int32_t gaps = 0;
  for (const std::int32_t h : around) {
    if (topology.run(topology.face(h)).kind == FaceKind::clampedGap) ++gaps;
  }
  if (gaps == 0) return addHalfBoxVertexRow(topology, first, tuned, row);
  for (const std::int32_t h : around) row.push_back({topology.dest(h), 1.0 / (3 + gaps)});
}

void addClampedRow(const SourceLevel& parent, const NewPoint& point, const TunedWeights& tuned, HalfBoxCorners corners,
                   Row& row) {
  const Topology& topology = parent.topology();
  const auto face = [&] { return ClampedFace(topology, topology.face(point.halfEdge)); };
  switch (point.kind) {
    case PointKind::cutStart:
    case PointKind::cutEnd:
      addCurveRow(topology, point, row);
      break;
    case PointKind::fixedCorner:
      row.push_back({topology.vert(point.halfEdge), 1});
      break;
    case PointKind::halfFaceCorner:
      addMirroredRow(face(), face().place(point.halfEdge), row);
      break;
    case PointKind::cornerFaceCorner:
      addCornerRow(face(), face().place(point.halfEdge), corners, row);
      break;
    default:
      return addInsideVertexRow(topology, point.halfEdge, tuned, row);
  }
  mergeEntries(row);
}

}  // namespace

Scheme clampStep() {
  Scheme scheme;
  scheme.name = "clamp";
  scheme.split = clamp();
  scheme.pointRow = addClampRow;
  return scheme;
}

Scheme clampedHalfBoxStep(const TunedWeights& tuned, HalfBoxCorners corners) {
  Scheme scheme;
  scheme.name = "half-box";
  scheme.split = chamferClamped();
  scheme.creases = {CreaseRule::Reach::infinite, true, scheme.split};
  scheme.faceRule = halfBoxRule;
  scheme.halfFaces = HalfFaces::ownRows;
  scheme.vertexLimits = VertexLimits::patchCentre;
  scheme.entriesPerVertex = 2;
  scheme.smoothCorners = corners == HalfBoxCorners::smooth;
  scheme.pointRow = [tuned, corners](const SourceLevel& parent, const NewPoint& point, Row& row) {
    addClampedRow(parent, point, tuned, corners, row);
  };
  return scheme;
}

}  // namespace honeycomb::Far
