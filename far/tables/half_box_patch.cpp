#include "far/tables/half_box_patch.h"

#include <algorithm>
#include <optional>

#include "far/base/index.h"

namespace honeycomb::Far {
namespace {

constexpr std::size_t after(std::size_t i) {
  return (i + 1) % 3;
}
constexpr std::size_t before(std::size_t i) {
  return (i + 2) % 3;
}

/// S1: Barendrecht, Sabin and Kosinka, Figure 5 for hexagons.
template <class Value>
PatchFace<Value> refineHexagon(const PatchFace<Value>& face) {
  PatchFace<Value> child;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto corner = [&](std::size_t i) -> const Value& { return face.slots[(k + i) % 6]; };
    child.slots[k] = 0.5 * corner(0) + 0.125 * (corner(1) + corner(2) + corner(4) + corner(5));
  }
  return child;
}

/// S1 of other polygons, eq 7: alpha_i = [i=0]/4 + (3 + 2 cos(2 pi i/N))/(4 N).
template <class Value>
PatchFace<Value> refinePolygon(const PatchFace<Value>& face) {
  PatchFace<Value> child;
  child.sides = face.sides;
  for (std::int32_t slot = 0; slot < 6; ++slot) {
    const double angle = 2 * std::numbers::pi * slotCorner(slot, face.sides) / face.sides;
    child.slots[at(slot)] = 0.25 * face.slots[at(slot)] + 0.75 * face.mean +
                            (0.5 * std::cos(angle) / face.sides) * face.cosine +
                            (0.5 * std::sin(angle) / face.sides) * face.sine;
  }
  child.mean = face.mean;
  child.cosine = 0.5 * face.cosine;
  child.sine = 0.5 * face.sine;
  return child;
}

template <class Value>
PatchFace<Value> refineFace(const PatchFace<Value>& face) {
  return face.sides == 6 ? refineHexagon(face) : refinePolygon(face);
}

/// The same hexagon taken from another corner.
template <class Value>
PatchFace<Value> startingAt(const PatchFace<Value>& hexagon, std::size_t corner) {
  PatchFace<Value> rotated = hexagon;
  std::rotate(rotated.slots.begin(), rotated.slots.begin() + static_cast<std::ptrdiff_t>(corner), rotated.slots.end());
  return rotated;
}

/// One step of the scheme on the three faces of a vertex: the faces' own, and the hexagons E_i of the edges (v, w_i)
/// taken from the new vertex of v.
template <class Value>
class RefinedFaces {
 public:
  explicit RefinedFaces(const PatchFaces<Value>& faces) {
    for (std::size_t i = 0; i < 3; ++i) own_[i] = refineFace(faces[i]);
    const Value centre = vertexPoint(faces[0].slots[0], faces[0].slots[1], faces[1].slots[1], faces[2].slots[1]);
    for (std::size_t i = 0; i < 3; ++i) {
      const PatchFace<Value>& f = faces[i];
      const Value neighbour = vertexPoint(f.slots[1], f.slots[0], f.slots[2], faces[before(i)].slots[4]);
      edges_[i].slots = {centre,    own_[before(i)].slots[0], own_[before(i)].slots[5],
                         neighbour, own_[i].slots[1],         own_[i].slots[0]};
    }
  }

  /// The faces round the new vertex of v in f_i.
  PatchFaces<Value> atCorner(std::size_t i) const {
    return {own_[i], startingAt(edges_[after(i)], 1), startingAt(edges_[i], 5)};
  }
  /// The faces round the new vertex of v itself.
  PatchFaces<Value> atCentre() const { return {edges_[1], edges_[2], edges_[0]}; }

 private:
  /// S2, Figure 5.
  static Value vertexPoint(const Value& v, const Value& a, const Value& b, const Value& c) {
    return 0.25 * (v + a + b + c);
  }

  PatchFaces<Value> own_, edges_;
};

/// A point of the patch and the directions of its two derivatives in barycentric coordinates; a step into a child patch
/// doubles the directions, since the child's triangle is half as large.
struct Place {
  Barycentric u;
  std::array<Barycentric, 2> directions{{{1, 0, -1}, {0, 1, -1}}};

  /// Into the child patch at corner i: the coordinates that are small near the corner keep all their digits.
  void goToCorner(std::size_t i) {
    const double a = 2 * u[after(i)];
    const double b = 2 * u[before(i)];
    u = {1 - a - b, a, b};
    for (Barycentric& d : directions) d = {2 * d[i], 2 * d[after(i)], 2 * d[before(i)]};
  }
  /// Into the child patch in the middle, whose triangle is turned by half a turn.
  void goToCentre() {
    const double a = 1 - 2 * u[2];
    const double b = 1 - 2 * u[0];
    u = {a, b, 1 - a - b};
    for (Barycentric& d : directions) d = {-2 * d[2], -2 * d[0], -2 * d[1]};
  }
};

Barycentric insideTriangle(Barycentric u) {
  for (double& coordinate : u) coordinate = std::max(coordinate, 0.0);
  const auto largest = static_cast<std::size_t>(std::max_element(u.begin(), u.end()) - u.begin());
  u[largest] = 1 - u[after(largest)] - u[before(largest)];
  return u;
}

/// The corner whose half-sized triangle contains u.
std::optional<std::size_t> cornerTriangle(const Barycentric& u) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (u[i] >= 0.5) return i;
  }
  return std::nullopt;
}

template <class Value>
bool allHexagons(const PatchFaces<Value>& faces) {
  return faces[0].sides == 6 && faces[1].sides == 6 && faces[2].sides == 6;
}

template <class Value>
void shift(PatchFaces<Value>& faces, const Value& origin) {
  for (PatchFace<Value>& face : faces) {
    for (Value& corner : face.slots) corner -= origin;
    face.mean -= origin;
  }
}

template <class Value>
PatchDerivatives<Value> atExtraordinaryCorner(const PatchFace<Value>& face) {
  return {face.mean, face.cosine, face.sine, {}, {}, {}, true};
}

/// One step of de Casteljau's algorithm: points of degree d in rows of 1, 2, .. d+1, as in bezierPoints.
template <std::size_t Less, class Value, std::size_t Count>
std::array<Value, Less> casteljauStep(const std::array<Value, Count>& points, const Barycentric& u) {
  std::array<Value, Less> result;
  std::size_t i = 0;
  for (std::size_t row = 0; i < Less; ++row) {
    for (std::size_t column = 0; column <= row; ++column, ++i) {
      const std::size_t below = i + row + 1;
      result[i] = u[0] * points[i] + u[1] * points[below] + u[2] * points[below + 1];
    }
  }
  return result;
}

/// First derivatives are 3 b(u, u, D), second ones 6 b(u, D, E), b being the cubic's blossom.
template <class Value>
PatchDerivatives<Value> evaluateCubic(const std::array<Value, 10>& points, const Place& place) {
  const auto& [d, e] = place.directions;
  const std::array<Value, 6> quadratic = casteljauStep<6>(points, place.u);
  const std::array<Value, 3> linear = casteljauStep<3>(quadratic, place.u);
  const std::array<Value, 3> alongD = casteljauStep<3>(quadratic, d);
  const std::array<Value, 3> alongE = casteljauStep<3>(quadratic, e);
  return {casteljauStep<1>(linear, place.u)[0],
          3.0 * casteljauStep<1>(linear, d)[0],
          3.0 * casteljauStep<1>(linear, e)[0],
          6.0 * casteljauStep<1>(alongD, d)[0],
          6.0 * casteljauStep<1>(alongD, e)[0],
          6.0 * casteljauStep<1>(alongE, e)[0],
          false};
}

}  // namespace

template <class Value>
PatchDerivatives<Value> evaluatePatch(const PatchFaces<Value>& faces, const Barycentric& u) {
  Place place{insideTriangle(u)};
  const std::optional<std::size_t> nearest = cornerTriangle(place.u);
  if (nearest && faces[*nearest].sides != 6 &&
      std::max(place.u[after(*nearest)], place.u[before(*nearest)]) <= kCornerDistance) {
    return atExtraordinaryCorner(faces[*nearest]);
  }
  PatchFaces<Value> current = faces;
  // All values shrink towards the limit of the corner they approach: differences are exact when taken from there.
  const Value origin = nearest && faces[*nearest].sides != 6 ? faces[*nearest].mean : Value{};
  shift(current, origin);
  while (!allHexagons(current)) {
    const RefinedFaces<Value> refined(current);
    if (const std::optional<std::size_t> corner = cornerTriangle(place.u)) {
      current = refined.atCorner(*corner);
      place.goToCorner(*corner);
    } else {
      current = refined.atCentre();
      place.goToCentre();
    }
  }
  PatchDerivatives<Value> result = evaluateCubic(bezierPoints(current), place);
  result.position += origin;
  return result;
}

template <class Value>
std::array<Value, 10> bezierPoints(const PatchFaces<Value>& faces) {
  // Places in the triangle of the corner in f_i, and of the two points of the edge from f_i to f_{i+1}.
  constexpr std::array<std::size_t, 3> kCorner{0, 6, 9};
  constexpr std::array<std::size_t, 3> kNearFirst{1, 7, 5};
  constexpr std::array<std::size_t, 3> kNearSecond{3, 8, 2};
  constexpr double kSixth = 1.0 / 6;
  const Value& v = faces[0].slots[0];
  std::array<Value, 10> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& f = faces[i].slots;
    const auto& g = faces[after(i)].slots;
    const Value edge = 2.0 * (v + g[1]);
    points[kCorner[i]] = kSixth * (f[0] + f[1] + f[2] + f[3] + f[4] + f[5]);
    points[kNearFirst[i]] = kSixth * (edge + f[1] + f[4]);
    points[kNearSecond[i]] = kSixth * (edge + g[5] + g[2]);
  }
  points[4] = kSixth * (3.0 * v + faces[0].slots[1] + faces[1].slots[1] + faces[2].slots[1]);
  return points;
}

template <class Value>
PatchDerivatives<Value> evaluateBezier(const std::array<Value, 10>& points, const Barycentric& u) {
  return evaluateCubic(points, Place{insideTriangle(u)});
}

template PatchDerivatives<PatchValue<3>> evaluatePatch(const PatchFaces<PatchValue<3>>&, const Barycentric&);
template PatchDerivatives<PatchRow> evaluatePatch(const PatchFaces<PatchRow>&, const Barycentric&);
template std::array<PatchValue<3>, 10> bezierPoints(const PatchFaces<PatchValue<3>>&);
template std::array<PatchRow, 10> bezierPoints(const PatchFaces<PatchRow>&);
template PatchDerivatives<PatchValue<3>> evaluateBezier(const std::array<PatchValue<3>, 10>&, const Barycentric&);

PatchFaces<PatchRow> unitFaces(const std::array<std::int32_t, 3>& sides) {
  PatchFaces<PatchRow> faces;
  for (std::size_t i = 0; i < 3; ++i) {
    PatchFace<PatchRow>& face = faces[i];
    face.sides = sides[i];
    for (std::size_t slot = 0; slot < 6; ++slot) face.slots[slot][9 * i + slot] = 1;
    face.mean[9 * i + 6] = 1;
    face.cosine[9 * i + 7] = 1;
    face.sine[9 * i + 8] = 1;
  }
  return faces;
}

std::vector<double> pointWeights(const std::array<std::int32_t, 3>& sides, const PatchRow& row) {
  std::vector<double> weights(at(patchPointCount(sides)), 0.0);
  std::int32_t firstInside = 4;
  for (std::int32_t i = 0; i < 3; ++i) {
    const std::int32_t n = sides[at(i)];
    const auto number = [&](std::int32_t k) { return row[at(9 * i + k)]; };
    const auto weight = [&](std::int32_t j) -> double& {
      if (j == 0) return weights[0];
      if (j == 1) return weights[at(1 + i)];
      if (j == n - 1) return weights[at(1 + (i + 1) % 3)];
      return weights[at(firstInside + j - 2)];
    };
    for (std::int32_t slot = 0; slot < 6; ++slot) weight(slotCorner(slot, n)) += number(slot);
    for (std::int32_t j = 0; j < n && n != 6; ++j) {
      const double angle = 2 * std::numbers::pi * j / n;
      weight(j) += number(6) / n + std::cos(angle) * number(7) + std::sin(angle) * number(8);
    }
    firstInside += n - 3;
  }
  return weights;
}

PatchFrameWeights patchCentreWeights(const std::array<std::int32_t, 3>& sides) {
  const PatchDerivatives<PatchRow> row = evaluatePatch(unitFaces(sides), {1.0 / 3, 1.0 / 3, 1.0 / 3});
  return {pointWeights(sides, row.position), pointWeights(sides, row.du), pointWeights(sides, row.dv)};
}

}  // namespace honeycomb::Far
