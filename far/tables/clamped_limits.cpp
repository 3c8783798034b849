#include "far/tables/clamped_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "far/base/index.h"
#include "far/schemes/half_box_rows.h"
#include "far/tables/half_box_patch.h"
#include "far/tables/level_table.h"
#include "far/topology/clamped_face.h"

namespace honeycomb::Far {

namespace {

/// Weights of one point in a frame.
struct PointWeights {
  double position = 0, tangent1 = 0, tangent2 = 0;
};

PointWeights operator*(double factor, const PointWeights& w) {
  return {factor * w.position, factor * w.tangent1, factor * w.tangent2};
}

void add(LimitFrame& frame, std::int32_t point, const PointWeights& w) {
  frame.points.push_back(point);
  frame.position.push_back(w.position);
  frame.tangent1.push_back(w.tangent1);
  frame.tangent2.push_back(w.tangent2);
}

void addTo(LimitFrame& frame, std::size_t i, const PointWeights& more) {
  frame.position[i] += more.position;
  frame.tangent1[i] += more.tangent1;
  frame.tangent2[i] += more.tangent2;
}

/// Adds to J of a frame whose first points are L, R of a side or L, J, R of a corner.
void addToJoint(LimitFrame& frame, bool corner, const PointWeights& w) {
  if (corner) return addTo(frame, 1, w);
  addTo(frame, 0, 0.5 * w);
  addTo(frame, 1, 0.5 * w);
}

double insideAngle(std::int32_t i, std::int32_t m) {
  return std::numbers::pi * (2 * i + 1) / (2 * m);
}

/// curveWeight() of a large side, its two sums in closed form: those of sin(theta_i) (row[j-i] + row[2m-1-j-i]) over i
/// are here sin(theta_j) + 2 mean sum_i sin(theta_i), since the cosines cancel.
double largeCurveWeight(std::int32_t m) {
  const CirculantRule rule = halfBoxRule(2 * m);
  const ClampedMirrorSums mirrored = clampedMirrorSums(m);
  const double sines = 1 / std::sin(std::numbers::pi / (2 * m));
  return 2 * ((rule.here - 0.5) * mirrored.sine + 2 * rule.mean * sines * mirrored.plain);
}

/// x of a side with m inside vertices. S1 takes T2 without its x term to half of itself and kappa (h_R - J + h_L - J)
/// more, where kappa collects what the points of the boundary pi_i put in, h_R being the middle of R and L_g; as R - J
/// and L - J cancel and the step makes L_g - J a quarter, x = 2 kappa makes the whole a half.
double curveWeight(std::int32_t m) {
  if (2 * m > kLargestCirculant) return largeCurveWeight(m);
  const std::vector<double> row = firstRow(halfBoxRule(2 * m), 2 * m);
  double kappa = 0;
  for (std::int32_t j = 0; j < m; ++j) {
    const double pi = std::max(0.0, clampedMirrorCosine(j, m));
    kappa -= std::sin(insideAngle(j, m)) * pi / 2;
    for (std::int32_t i = 0; pi > 0 && i < m; ++i) {
      kappa += std::sin(insideAngle(i, m)) * pi * (row[at((j - i + 2 * m) % (2 * m))] + row[at(2 * m - 1 - j - i)]);
    }
  }
  return 2 * kappa;
}

/// L, R or L, J, R with the tangents they have as such.
LimitFrame startFrame(const ClampedFace& face, const PointWeights& left, const PointWeights& right) {
  LimitFrame frame;
  add(frame, face.left(), left);
  if (face.isCorner()) add(frame, face.joint(), {});
  add(frame, face.right(), right);
  addToJoint(frame, face.isCorner(), {1, -left.tangent1 - right.tangent1, -left.tangent2 - right.tangent2});
  return frame;
}

LimitFrame sideFrame(const ClampedFace& face) {
  LimitFrame frame = startFrame(face, {0, -1, 0}, {0, 1, 0});
  const std::int32_t m = face.insideCount();
  double sum = 0;
  for (std::int32_t i = 0; i < m; ++i) {
    const double sine = std::sin(insideAngle(i, m));
    add(frame, face.inside(i), {0, 0, sine});
    sum += sine;
  }
  const double x = curveWeight(m);
  add(frame, face.leftAfter(), {0, 0, x});
  add(frame, face.rightBefore(), {0, 0, x});
  addToJoint(frame, face.isCorner(), {0, 0, -sum - 2 * x});
  return frame;
}

LimitFrame insideFrame(const ClampedFace& face) {
  LimitFrame frame = startFrame(face, {}, {});
  const double phi = 2 * std::numbers::pi / clampedCornerPolygon(face.insideCount());
  for (std::int32_t i = 0; i < face.insideCount(); ++i) {
    const PointWeights w{0, std::cos(i * phi), std::sin(i * phi)};
    add(frame, face.inside(i), w);
    addToJoint(frame, true, -1.0 * w);
  }
  return frame;
}

LimitFrame cornerFrame(const ClampedFace& face, bool smoothCorners) {
  const std::int32_t m = face.insideCount();
  if (m < 3) return startFrame(face, {0, 0, 1}, {0, 1, 0});
  if (m == 3) return sideFrame(face);
  return smoothCorners ? startFrame(face, {0, 1, 0}, {0, 0, 1}) : insideFrame(face);
}

/// A point of the cubic J_f, R_f, L_g, J_g with the Bernstein values b at it and the derivative's weights d, and the
/// direction from there to q. Points: the boundary vertex before R_f (L_f or J_f), R_f, L_g, the one behind, q.
LimitFrame gapFrame(const Topology& topology, std::int32_t h, const std::array<double, 4>& b,
                    const std::array<double, 4>& d) {
  const auto weights = [&](std::size_t i) { return PointWeights{b[i], d[i], -b[i]}; };
  const bool cornerBefore = topology.run(faceBeforeGap(topology, h)).kind == FaceKind::clampedCorner;
  const bool cornerAfter = topology.run(faceAfterGap(topology, h)).kind == FaceKind::clampedCorner;
  const PointWeights before = (cornerBefore ? 1 : 0.5) * weights(0);
  const PointWeights after = (cornerAfter ? 1 : 0.5) * weights(3);
  LimitFrame frame;
  add(frame, topology.vert(topology.twin(h + 2) - 1), before);
  add(frame, topology.vert(h), weights(1));
  add(frame, topology.dest(h), weights(2));
  const std::int32_t intoAfter = topology.twin(h + 1);  // from q to L_g, the last of its face
  add(frame, topology.vert(topology.next(topology.next(intoAfter))), after);
  add(frame, topology.vert(h + 2), {0, 0, 1});
  if (!cornerBefore) addTo(frame, 1, before);
  if (!cornerAfter) addTo(frame, 2, after);
  return frame;
}

/// Bernstein values and derivative weights, up to a factor, of a cubic at 1/3, 2/3 and 1/2.
constexpr std::array<double, 4> kOneThird{8.0 / 27, 12.0 / 27, 6.0 / 27, 1.0 / 27};
constexpr std::array<double, 4> kOneThirdTangent{-4, 0, 3, 1};
constexpr std::array<double, 4> kTwoThirds{1.0 / 27, 6.0 / 27, 12.0 / 27, 8.0 / 27};
constexpr std::array<double, 4> kTwoThirdsTangent{-1, -3, 0, 4};
constexpr std::array<double, 4> kHalf{1.0 / 8, 3.0 / 8, 3.0 / 8, 1.0 / 8};
constexpr std::array<double, 4> kHalfTangent{-1, -1, 1, 1};

/// Where the points of a patch of three hexagons stand: see VertexPatch.
std::size_t cornerPlace(std::size_t face, std::size_t corner) {
  return 4 + 3 * face + corner - 2;
}

/// The corners 2 .. 4 of a face from half-edge h on; those of a side are images, 2 pi_i - q_i.
void addFace(LimitFrame& frame, const Topology& topology, std::int32_t h, const std::array<PointWeights, 3>& w) {
  const std::int32_t f = topology.face(h);
  if (topology.run(f).kind == FaceKind::full) {
    std::int32_t corner = topology.next(topology.next(h));
    for (std::size_t j = 0; j < 3; ++j, corner = topology.next(corner)) add(frame, topology.vert(corner), w[j]);
    return;
  }
  const ClampedFace side(topology, f);
  const std::array<std::array<std::int32_t, 2>, 3> boundary{
      {{side.left(), side.rightBefore()}, {side.left(), side.right()}, {side.right(), side.leftAfter()}}};
  for (std::size_t j = 0; j < 3; ++j) {
    add(frame, boundary[j][0], w[j]);
    add(frame, boundary[j][1], w[j]);
    add(frame, side.inside(2 - static_cast<std::int32_t>(j)), -1.0 * w[j]);
  }
}

/// A neighbour w at two gaps has (v + sum (R + L))/5 as its S2; the images would make it (v + sum (R + L) - w)/4.
void addTwoGapCorrection(LimitFrame& frame, const Topology& topology, std::int32_t v, std::int32_t w,
                         const PointWeights& weights) {
  std::vector<std::int32_t> boundary;
  for (const std::int32_t h : topology.halfEdgesFrom(w)) {
    if (topology.onBoundary(topology.dest(h))) boundary.push_back(topology.dest(h));
  }
  if (boundary.size() < 4) return;
  for (const std::int32_t point : boundary) add(frame, point, -1.0 / 20 * weights);
  add(frame, v, -1.0 / 20 * weights);
  add(frame, w, 0.25 * weights);
}

}  // namespace

LimitFrame clampedFaceFrame(const Topology& topology, std::int32_t f, bool smoothCorners) {
  if (topology.run(f).kind == FaceKind::clampedGap) {
    return gapFrame(topology, topology.faceOffsets()[at(f)], kHalf, kHalfTangent);
  }
  const ClampedFace face(topology, f);
  return face.isCorner() ? cornerFrame(face, smoothCorners) : sideFrame(face);
}

bool onClampedBoundary(const Topology& topology, std::int32_t v) {
  return topology.onBoundary(v) && isClamped(topology.run(topology.face(topology.outgoing(v))).kind);
}

bool besideClampedBoundary(const Topology& topology, std::int32_t v) {
  if (topology.onBoundary(v)) return false;
  for (const std::int32_t h : topology.halfEdgesFrom(v)) {
    if (isClamped(topology.run(topology.face(h)).kind)) return true;
  }
  return false;
}

LimitFrame clampedBoundaryFrame(const Topology& topology, std::int32_t v, bool smoothCorners) {
  const std::int32_t h = topology.outgoing(v);
  const std::int32_t f = topology.face(h);
  if (topology.run(f).kind == FaceKind::clampedGap) return gapFrame(topology, h, kOneThird, kOneThirdTangent);
  const std::int32_t first = topology.faceOffsets()[at(f)];
  if (h != first) return clampedFaceFrame(topology, f, smoothCorners);
  const std::int32_t gap = topology.twin(topology.prev(h)) - 1;
  return gapFrame(topology, gap, kTwoThirds, kTwoThirdsTangent);
}

LimitFrame clampedPatchCentre(const Topology& topology, std::int32_t v) {
  const PatchFrameWeights regular = patchCentreWeights({6, 6, 6});
  const auto weights = [&regular](std::size_t i) {
    return PointWeights{regular.position[i], regular.tangent1[i], regular.tangent2[i]};
  };
  LimitFrame frame;
  add(frame, v, weights(0));
  std::int32_t h = topology.outgoing(v);
  for (std::size_t i = 0; i < 3; ++i, h = topology.nextOutgoing(h)) {
    add(frame, topology.dest(h), weights(1 + i));
    addFace(frame, topology, h, {weights(cornerPlace(i, 2)), weights(cornerPlace(i, 3)), weights(cornerPlace(i, 4))});
    // One step on, S2 of w_i stands where corner 3 of the face opposite it stands here, in a patch turned round.
    const PointWeights opposite = weights(cornerPlace((i + 1) % 3, 3));
    addTwoGapCorrection(frame, topology, v, topology.dest(h),
                        {opposite.position, -2 * opposite.tangent1, -2 * opposite.tangent2});
  }
  return frame;
}

}  // namespace honeycomb::Far
