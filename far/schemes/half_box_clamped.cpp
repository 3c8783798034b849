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

/// The angle of q_i from the line through J along the boundary, in a side with m inside vertices.
double sideAngle(std::int32_t i, std::int32_t m) {
  return std::numbers::pi * (2 * i + 1) / (2 * m);
}

/// As addMirroredRow, of a large side. With t = sideAngle and the sum S of sin t_j q_j, which is in place `sum`, the
/// weights on q_j are here [i=j] + 2 cosine sin t_i sin t_j, and that on pi_j 2 (mean + cosine cos(t_i + t_j)).
void addLargeMirroredRow(const ClampedFace& face, std::int32_t i, std::int32_t sum, Row& row) {
  const std::int32_t m = face.insideCount();
  const CirculantRule rule = halfBoxRule(2 * m);
  const double c = std::cos(sideAngle(i, m));
  const double s = std::sin(sideAngle(i, m));
  const ClampedMirrorSums mirrored = clampedMirrorSums(m);
  const double sines = 1 / std::sin(std::numbers::pi / (2 * m));
  const auto onBoundary = [&](double plain, double cosine, double sine) {
    return 2 * (rule.mean * plain + rule.cosine * (c * cosine - s * sine));
  };
  const double right = onBoundary(mirrored.plain, mirrored.cosine, mirrored.sine) / 2;
  const double left = onBoundary(mirrored.plain, -mirrored.cosine, mirrored.sine) / 2;
  row.insert(row.end(), {{face.inside(i), rule.here}, {sum, 2 * rule.cosine * s}});
  addJoint(face, onBoundary(m - 2 * mirrored.plain, 0, sines - 2 * mirrored.sine), row);
  row.insert(row.end(),
             {{face.right(), right}, {face.leftAfter(), right}, {face.left(), left}, {face.rightBefore(), left}});
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

/// As addConvexCornerRow, of a large corner: the sum of its inside vertices, and behind it their cosine and sine sums.
void addLargeConvexCornerRow(const ClampedFace& face, std::int32_t i, std::int32_t firstSum, Row& row) {
  const std::int32_t m = face.insideCount();
  const std::int32_t sides = clampedCornerPolygon(m);
  const CirculantRule rule = halfBoxRule(sides);
  const double phi = 2 * std::numbers::pi / sides;
  row.insert(row.end(),
             {{face.inside(i), rule.here},
              {firstSum, rule.mean},
              {firstSum + 1, rule.cosine * std::cos(i * phi)},
              {firstSum + 2, rule.cosine * std::sin(i * phi)},
              {face.joint(), 2 * rule.mean + rule.cosine * (std::cos((m - i) * phi) + std::cos((m + 1 - i) * phi))}});
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

/// The sum over the inside vertices of a face of weightOf(place).
template <class WeightOf>
Row insideSum(const ClampedFace& face, const WeightOf& weightOf) {
  Row sum;
  for (std::int32_t i = 0; i < face.insideCount(); ++i) sum.push_back({face.inside(i), weightOf(i)});
  return sum;
}

std::vector<Row> clampedFaceSums(const Topology& topology, std::int32_t f, HalfBoxCorners corners) {
  if (topology.run(f).kind != FaceKind::clampedSide && topology.run(f).kind != FaceKind::clampedCorner) return {};
  const ClampedFace face(topology, f);
  const std::int32_t m = face.insideCount();
  if (!face.isCorner()) return {insideSum(face, [m](std::int32_t i) { return std::sin(sideAngle(i, m)); })};
  if (corners == HalfBoxCorners::smooth) return {};
  const double phi = 2 * std::numbers::pi / clampedCornerPolygon(m);
  return {insideSum(face, [](std::int32_t) { return 1.0; }),
          insideSum(face, [phi](std::int32_t i) { return std::cos(i * phi); }),
          insideSum(face, [phi](std::int32_t i) { return std::sin(i * phi); })};
}

/// A point of a large face, of which there are sums.
void addLargeFaceRow(const ClampedFace& face, const NewPoint& point, std::int32_t firstSum, Row& row) {
  const std::int32_t i = face.place(point.halfEdge);
  face.isCorner() ? addLargeConvexCornerRow(face, i, firstSum, row) : addLargeMirroredRow(face, i, firstSum, row);
  mergeEntries(row);
}

void addClampedRow(const SourceLevel& parent, const NewPoint& point, const TunedWeights& tuned, HalfBoxCorners corners,
                   Row& row) {
  const Topology& topology = parent.topology();
  const auto face = [&] { return ClampedFace(topology, topology.face(point.halfEdge)); };
  if (point.kind == PointKind::halfFaceCorner || point.kind == PointKind::cornerFaceCorner) {
    const std::int32_t sum = parent.sumPoint(topology.face(point.halfEdge));
    if (sum >= 0) return addLargeFaceRow(face(), point, sum, row);
  }
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
  scheme.faceSums = [corners](const Topology& parent, std::int32_t f) { return clampedFaceSums(parent, f, corners); };
  scheme.pointRow = [tuned, corners](const SourceLevel& parent, const NewPoint& point, Row& row) {
    addClampedRow(parent, point, tuned, corners, row);
  };
  return scheme;
}

}  // namespace honeycomb::Far
