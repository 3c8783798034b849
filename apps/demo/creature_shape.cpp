#include "apps/demo/creature_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "apps/demo/creature_cage.h"
#include "apps/demo/creature_rig.h"

namespace honeycomb::Demo {
namespace {

using glm::dvec3;

constexpr int kLip = 5;  // the vertex of a head ring that lies in the mouth line, between the lips

int sidesOf(int ring) {
  return kBodyRings[static_cast<std::size_t>(ring)].sides;
}

/// Degrees from the top of a ring to its vertex on the right side, 0 to sides / 2.
double ringAngle(int sides, int vertex) {
  static constexpr std::array head = {0.0, 20.0, 46.0, 72.0, 91.0, 99.0, 107.0, 143.0, 180.0};
  static constexpr std::array trunk = {0.0, 34.0, 68.0, 96.0, 124.0, 152.0, 180.0};
  const auto v = static_cast<std::size_t>(vertex);
  if (sides == 16) return head[v];
  if (sides == 12) return trunk[v];
  return 360.0 * vertex / sides;
}

/// How much of its radius a vertex of the mouth line keeps: the groove ends behind the eyes.
double mouthDepth(int ring) {
  static constexpr std::array depth = {0.83, 0.85, 0.87, 0.88, 0.90, 0.95};
  return ring < static_cast<int>(depth.size()) ? depth[static_cast<std::size_t>(ring)] : 1.0;
}

/// Degrees by which the mouth line climbs towards its corners: a smile.
double mouthClimb(int ring) {
  static constexpr std::array climb = {0.0, 0.0, 1.0, 2.5, 5.0, 9.0};
  return ring < static_cast<int>(climb.size()) ? climb[static_cast<std::size_t>(ring)] : 6.0;
}

dvec3 ringPoint(int ring, int vertex) {
  const BodyRing& section = kBodyRings[static_cast<std::size_t>(ring)];
  const int onRight = std::min(vertex, section.sides - vertex);
  const bool mouth = section.sides == 16 && std::abs(onRight - kLip) <= 1;
  const double angle = (ringAngle(section.sides, onRight) - (mouth ? mouthClimb(ring) : 0.0)) * kDegree;
  const double up = std::cos(angle) * (std::cos(angle) > 0.0 ? section.top : section.bottom);
  const double out = std::sin(angle) * section.halfWidth * (mouth && onRight == kLip ? mouthDepth(ring) : 1.0);
  return {0.0, up, onRight == vertex ? out : -out};
}

/// Two rows and two columns of the body's faces that something grows out of, on both sides.
struct Opening {
  int ring, vertex;
  bool holdsFace(int row, int column) const {
    const int mirror = sidesOf(row) - 1 - column;
    const auto inside = [&](int c) { return c == vertex || c == vertex + 1; };
    return (row == ring || row == ring + 1) && (inside(column) || inside(mirror));
  }
  bool holdsVertex(int row, int v) const {
    return row == ring + 1 && (v == vertex + 1 || v == sidesOf(row) - vertex - 1);
  }
};
constexpr std::array kOpenings = {Opening{kEyeRing, 1}, Opening{kFrontLegRing, 2}, Opening{kHindLegRing, 2}};

/// The body as rings of vertices from the snout backwards, each from the top over the right side round to the left.
class Body {
 public:
  explicit Body(CageBuilder& cage) {
    for (int ring = 0; ring < kBodyRingCount; ++ring) {
      Loop loop;
      for (int v = 0; v < sidesOf(ring); ++v) {
        const bool gone = std::any_of(kOpenings.begin(), kOpenings.end(),
                                      [&](const Opening& opening) { return opening.holdsVertex(ring, v); });
        loop.push_back(gone ? -1 : cage.addVertex(ring, ringPoint(ring, v)));
      }
      rings_.push_back(loop);
    }
  }

  const Loop& ring(int i) const { return rings_[static_cast<std::size_t>(i)]; }
  /// Vertex `v` of a ring, round and round.
  std::int32_t at(int i, int v) const {
    const int sides = sidesOf(i);
    return ring(i)[static_cast<std::size_t>(((v % sides) + sides) % sides)];
  }
  /// Vertex `v` of the right side or its mirror image.
  std::int32_t at(int i, int v, Side side) const { return at(i, side == Side::right ? v : -v); }
  /// The border of an opening, from the middle of its front edge over the top.
  Loop border(const Opening& opening, Side side) const {
    static constexpr std::array<std::array<int, 2>, 8> kWay = {
        {{0, 1}, {0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}}};
    Loop loop;
    for (const auto& [row, column] : kWay) loop.push_back(at(opening.ring + row, opening.vertex + column, side));
    return loop;
  }

 private:
  std::vector<Loop> rings_;
};

bool isOpen(int row, int column) {
  return std::any_of(kOpenings.begin(), kOpenings.end(), [&](const Opening& o) { return o.holdsFace(row, column); });
}

/// A cell between the vertices first and last of a ring and first and last of the next.
Loop cellBetween(const Body& body, int row, std::array<int, 2> front, std::array<int, 2> back) {
  Loop loop;
  for (int v = front[1]; v >= front[0]; --v) loop.push_back(body.at(row, v));
  for (int v = back[0]; v <= back[1]; ++v) loop.push_back(body.at(row + 1, v));
  return loop;
}

/// A vertex of a spot: about half way from a ring's vertex to the middle of the hexagon that the spot fills.
std::int32_t addSpotVertex(CageBuilder& cage, int row, int ring, int vertex, int middleVertex) {
  const auto rest = [](int r, int v) {
    const int sides = sidesOf(r);
    dvec3 point = ringPoint(r, ((v % sides) + sides) % sides);
    point.x = -kBodyRings[static_cast<std::size_t>(r)].station;
    return point;
  };
  const dvec3 middle = 0.5 * (rest(row, middleVertex) + rest(row + 1, middleVertex));
  const dvec3 corner = rest(ring, vertex);
  const dvec3 place = corner + (middle - corner) * 0.48 - dvec3(corner.x, 0.0, 0.0);
  // Half of what the chord lies below the round of the back.
  return cage.addVertex(ring, place * dvec3(1.0, 1.015, 1.015));
}

/// A spot in place of a hexagon: a triangle joined to every second corner, and three pentagons round it.
///     v2 ---- v1 ---- v0
///     |  t1 ------ t0  |
///     |    `. t2 .'    |
///     v3 ---- v4 ---- v5
void addSpot(CageBuilder& cage, const Loop& v, int row, int firstVertex) {
  const int middle = firstVertex + 1;
  const std::int32_t t0 = addSpotVertex(cage, row, row, firstVertex + 2, middle);
  const std::int32_t t1 = addSpotVertex(cage, row, row, firstVertex, middle);
  const std::int32_t t2 = addSpotVertex(cage, row, row + 1, middle, middle);
  cage.addFace({t0, t1, t2});
  cage.addFace({v[0], v[1], v[2], t1, t0});
  cage.addFace({v[2], v[3], v[4], t2, t1});
  cage.addFace({v[4], v[5], v[0], t0, t2});
}

/// How a row between two rings is cut into cells, from vertex `first` round: how many edges of its front ring each cell
/// takes. It takes as many of the back ring, or one where the row narrows (two against one make a pentagon).
struct RowPattern {
  int first;
  std::vector<int> edges;
};

/// Hexagons like bricks along the back and the belly, across the middle line and beside it by turns; quads along the
/// flanks and on the head.
RowPattern rowPattern(int row) {
  const int sides = sidesOf(row);
  if (sides != sidesOf(row + 1)) {
    if (sides == 16) return {0, {1, 1, 2, 2, 1, 1, 1, 1, 2, 2, 1, 1}};
    if (sides == 12) return {0, {1, 2, 2, 1, 1, 2, 2, 1}};
    return {0, {1, 2, 1, 1, 2, 1}};
  }
  const bool across = row % 2 == 1;
  if (sides == 12 && across) return {-1, {2, 1, 1, 1, 1, 2, 1, 1, 1, 1}};
  if (sides == 12) return {0, {2, 1, 1, 2, 2, 1, 1, 2}};
  if (sides == 8 && across) return {-1, {2, 1, 1, 2, 1, 1}};
  if (sides == 6 && across) return {-1, {2, 1, 1, 1, 1}};
  return {0, std::vector<int>(static_cast<std::size_t>(sides), 1)};
}

/// Spots run along both sides of the trunk's back and on top of the tail.
bool hasSpot(int row, int firstVertex) {
  const int sides = sidesOf(row);
  if (sides == 12) return row % 2 == 0 && (firstVertex == 0 || firstVertex == sides - 2);
  return sides == 8 && firstVertex == -1;
}

void addRow(CageBuilder& cage, const Body& body, int row) {
  const bool narrows = sidesOf(row) != sidesOf(row + 1);
  const RowPattern pattern = rowPattern(row);
  int front = pattern.first;
  int back = pattern.first;
  for (const int edges : pattern.edges) {
    const int backEdges = narrows ? 1 : edges;
    if (!isOpen(row, front)) {
      const Loop cell = cellBetween(body, row, {front, front + edges}, {back, back + backEdges});
      if (!narrows && edges == 2 && hasSpot(row, front)) {
        addSpot(cage, cell, row, front);
      } else {
        cage.addFace(cell);
      }
    }
    front += edges;
    back += backEdges;
  }
}

/// The snout: from each vertex of the first ring's right side a line runs across to the left, bulging in its middle,
/// down to the bottom: quads between the lines, triangles at both ends.
void addSnout(CageBuilder& cage, const Body& body) {
  static constexpr std::array kBulge = {0.035, 0.052, 0.060, 0.060, 0.036, 0.056, 0.035};
  std::vector<std::int32_t> middle = {body.at(0, 0)};
  for (std::size_t i = 0; i < kBulge.size(); ++i) {
    middle.push_back(cage.addVertex(0, {kBulge[i], ringPoint(0, static_cast<int>(i) + 1).y, 0.0}));
  }
  cage.addFace({middle[0], body.at(0, 1), middle[1]});
  cage.addFace({middle[0], middle[1], body.at(0, -1)});
  for (std::size_t i = 1; i < kBulge.size(); ++i) {
    const int v = static_cast<int>(i);
    cage.addFace({body.at(0, v), body.at(0, v + 1), middle[i + 1], middle[i]});
    cage.addFace({middle[i], middle[i + 1], body.at(0, -v - 1), body.at(0, -v)});
  }
  cage.addFace({body.at(0, 7), body.at(0, 8), middle[7]});
  cage.addFace({middle[7], body.at(0, 8), body.at(0, -7)});
}

void addTailTip(CageBuilder& cage, const Body& body) {
  const double reach = kBodyLength - kBodyRings.back().station;
  const std::int32_t tip = cage.addVertex(kBodyRingCount - 1, {-reach, 0.0, 0.0});
  Loop ring = body.ring(kBodyRingCount - 1);
  std::reverse(ring.begin(), ring.end());
  cage.close(ring, tip);
}

/// Eight points round a limb: half axes, degrees of the first, and how far along the frame's z.
std::array<dvec3, 8> octagon(double halfX, double halfY, double firstDegrees, double along) {
  std::array<dvec3, 8> points;
  for (std::size_t k = 0; k < 8; ++k) {
    const double angle = (firstDegrees + 45.0 * static_cast<double>(k)) * kDegree;
    points[k] = {halfX * std::cos(angle), halfY * std::sin(angle), along};
  }
  return points;
}

/// A lid, a fold, and a ball that ends in an octagon.
void addEye(CageBuilder& cage, const Body& body, Side side) {
  const int bone = eyeBone(side);
  Loop ring = body.border(kOpenings[0], side);
  const auto grow = [&](double radius, double along) {
    const Loop next = cage.addRing(bone, octagon(radius, radius, 0.0, along));
    cage.bridge(ring, next);
    ring = next;
  };
  grow(0.134, 0.030);
  grow(0.112, 0.022);
  grow(0.118, 0.072);
  grow(0.066, 0.122);
  cage.addFace(ring);
}

/// The four corners of a toe's cross section.
std::array<dvec3, 4> toeSection(const dvec3& centre, double halfWidth, double halfHeight) {
  return {centre + dvec3(halfWidth, halfHeight, 0.0), centre + dvec3(-halfWidth, halfHeight, 0.0),
          centre + dvec3(-halfWidth, -halfHeight, 0.0), centre + dvec3(halfWidth, -halfHeight, 0.0)};
}

/// A thin toe with a round pad and a tip of four triangles; `root` is the quad it grows from, `start` its middle in the
/// toe's frame.
void addToe(CageBuilder& cage, int bone, const Loop& root, const dvec3& start, double length) {
  const auto along = [&](double part) { return start + dvec3(0.0, -0.25 * start.y * part, length * part); };
  const Loop stalk = cage.addRing(bone, toeSection(along(0.42), 0.036, 0.040));
  const Loop pad = cage.addRing(bone, toeSection(along(0.78), 0.066, 0.036));
  cage.bridge(root, stalk);
  cage.bridge(stalk, pad);
  cage.close(pad, cage.addVertex(bone, along(1.0)));
}

/// The toes of a foot: two from the sides of the palm, three from its end.
void addToes(CageBuilder& cage, int leg, const Loop& wristRing, const Loop& palmRing) {
  const auto toe = [&](int number, const Loop& root, const dvec3& start, double length) {
    addToe(cage, legBone(leg, firstToe + number), root, start, length);
  };
  const Loop& w = wristRing;
  const Loop& p = palmRing;
  toe(0, {w[0], p[0], p[7], w[7]}, {0.055, -0.035, 0.100}, 0.24);
  toe(1, {p[0], p[1], p[6], p[7]}, {0.062, -0.030, 0.075}, 0.29);
  toe(2, {p[1], p[2], p[5], p[6]}, {0.000, -0.030, 0.060}, 0.31);
  toe(3, {p[2], p[3], p[4], p[5]}, {-0.062, -0.030, 0.075}, 0.29);
  toe(4, {p[3], w[3], w[4], p[4]}, {-0.055, -0.035, 0.100}, 0.24);
}

void addLeg(CageBuilder& cage, const Body& body, int leg) {
  const Leg& what = kLegs[static_cast<std::size_t>(leg)];
  const double thick = what.front ? 1.0 : 1.15;
  Loop ring = body.border(kOpenings[what.front ? 1 : 2], what.side);
  const auto grow = [&](LegBone bone, double halfX, double halfY, double firstDegrees) {
    const Loop next = cage.addRing(legBone(leg, bone), octagon(halfX, halfY, firstDegrees, 0.0));
    static constexpr std::array<std::size_t, 2> kThumbs = {3, 7};
    cage.bridge(ring, next, bone == palm ? std::span<const std::size_t>(kThumbs) : std::span<const std::size_t>());
    return std::exchange(ring, next);
  };
  grow(shoulder, 0.128 * thick, 0.128 * thick, 0.0);
  grow(upperLimb, 0.112 * thick, 0.112 * thick, 4.0);
  grow(elbow, 0.106 * thick, 0.090 * thick, 9.0);
  grow(lowerLimb, 0.094 * thick, 0.090 * thick, 14.0);
  grow(wrist, 0.100, 0.072, 19.0);
  const Loop wristRing = grow(palm, 0.150, 0.062, 22.5);
  addToes(cage, leg, wristRing, ring);
}

}  // namespace

CreatureShape makeCreatureShape() {
  CageBuilder cage;
  const Body body(cage);
  addSnout(cage, body);
  for (int row = 0; row + 1 < kBodyRingCount; ++row) addRow(cage, body, row);
  addTailTip(cage, body);
  for (const Side side : kSides) {
    cage.setMirrored(side == Side::left);
    addEye(cage, body, side);
    for (int leg = 0; leg < static_cast<int>(kLegs.size()); ++leg) {
      if (kLegs[static_cast<std::size_t>(leg)].side == side) addLeg(cage, body, leg);
    }
  }
  return std::move(cage).take();
}

}  // namespace honeycomb::Demo
