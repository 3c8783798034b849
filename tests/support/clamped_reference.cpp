#include "tests/support/clamped_reference.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace honeycomb::Test {
namespace {

using std::numbers::pi;

/// Where each directed edge a -> b stands: its face and the place of a in its loop.
struct ClampedEdges {
  struct Place {
    std::size_t face, corner;
  };
  std::map<std::pair<std::size_t, std::size_t>, Place> of;
  std::set<std::size_t> boundary;

  explicit ClampedEdges(const PolyMesh& mesh) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Loop& loop = mesh.faces[f];
      for (std::size_t i = 0; i < loop.size(); ++i) of[{loop[i], loop[(i + 1) % loop.size()]}] = {f, i};
    }
    for (const auto& edge : of) {
      if (of.contains({edge.first.second, edge.first.first})) continue;
      boundary.insert({edge.first.first, edge.first.second});
    }
  }
  bool inside(std::size_t v) const { return !boundary.contains(v); }
};

/// Corner k of S1 of a polygon.
Vec3 s1(const std::vector<Vec3>& polygon, std::size_t k) {
  const auto n = polygon.size();
  const auto size = static_cast<double>(n);
  Vec3 sum{};
  for (std::size_t i = 0; i < n; ++i) {
    double w = (3 + 2 * std::cos(2 * pi * static_cast<double>(i) / size)) / (4 * size);
    if (i == 0) w = 0.25 + 5 / (4 * size);
    if (n == 6) w = std::array<double, 6>{0.5, 0.125, 0.125, 0, 0.125, 0.125}[i];
    sum = sum + w * polygon[(k + i) % n];
  }
  return sum;
}

class Clamp {
 public:
  explicit Clamp(const PolyMesh& mesh) : old_(mesh), edges_(mesh) {}

  ClampedMesh run() {
    for (std::size_t f = 0; f < old_.faces.size(); ++f) addFace(f);
    for (const auto& edge : edges_.of) {
      const std::size_t w = edge.first.first, v = edge.first.second;
      if (edges_.inside(w) || !edges_.inside(v)) continue;
      addFaceOf('T', {beside(w, v), beside(v, w), kept(v)});
    }
    return std::move(result_);
  }

 private:
  void addFaceOf(char tag, Loop loop) {
    result_.mesh.faces.push_back(std::move(loop));
    result_.tags.push_back(tag);
  }
  std::size_t newPoint(const Vec3& p) {
    result_.mesh.points.push_back(p);
    return result_.mesh.points.size() - 1;
  }
  std::size_t kept(std::size_t v) {
    if (!kept_.contains(v)) kept_[v] = newPoint(old_.points[v]);
    return kept_[v];
  }
  /// The point beside edge a -> b in its face: R at the edge into a row of inside vertices, L at the edge out of it.
  std::size_t beside(std::size_t a, std::size_t b) {
    if (beside_.contains({a, b})) return beside_[{a, b}];
    const ClampedEdges::Place place = edges_.of.at({a, b});
    const Loop& loop = old_.faces[place.face];
    const std::size_t n = loop.size();
    const Vec3 sum = 2.0 * (old_.points[a] + old_.points[b]) + old_.points[loop[(place.corner + n - 1) % n]] +
                     old_.points[loop[(place.corner + 2) % n]];
    return beside_[{a, b}] = newPoint(1.0 / 6 * sum);
  }

  void addFace(std::size_t f) {
    const Loop& loop = old_.faces[f];
    const std::size_t n = loop.size();
    bool allInside = true;
    for (const std::size_t v : loop) allInside = allInside && edges_.inside(v);
    if (allInside) {
      Loop same;
      for (const std::size_t v : loop) same.push_back(kept(v));
      return addFaceOf('I', same);
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (edges_.inside(loop[i]) || !edges_.inside(loop[(i + 1) % n])) continue;
      Loop row;
      std::size_t last = i + 1;
      for (; edges_.inside(loop[last % n]); ++last) row.push_back(kept(loop[last % n]));
      const std::size_t left = beside(loop[(last - 1) % n], loop[last % n]);
      Loop face{left, beside(loop[i], loop[(i + 1) % n])};
      const bool side = n == 2 * row.size();
      if (!side) face.insert(face.begin() + 1, newPoint(centroid(corners(old_, f))));
      face.insert(face.end(), row.begin(), row.end());
      addFaceOf(side ? 'B' : 'C', face);
    }
  }

  const PolyMesh& old_;
  ClampedEdges edges_;
  ClampedMesh result_;
  std::map<std::size_t, std::size_t> kept_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> beside_;
};

class ClampedStep {
 public:
  ClampedStep(const ClampedMesh& mesh, bool smooth)
      : old_(mesh),
        smooth_(smooth),
        edges_(mesh.mesh),
        neighbours_(mesh.mesh.points.size()),
        gaps_(neighbours_.size()) {
    for (const auto& edge : edges_.of) {
      const auto& [a, b] = edge.first;
      neighbours_[a].push_back(b);
      if (edges_.of.contains({b, a})) continue;
      after_[a] = b;
      before_[b] = a;
    }
    for (std::size_t f = 0; f < mesh.tags.size(); ++f) gaps_[loop(f)[2]] += mesh.tags[f] == 'T' ? 1 : 0;
  }

  ClampedMesh run() {
    for (std::size_t f = 0; f < old_.tags.size(); ++f) {
      corner_.emplace_back();
      if (old_.tags[f] == 'T') continue;
      for (std::size_t i = 0; i < loop(f).size(); ++i) corner_[f].push_back(newPoint(newCorner(f, i)));
      addFaceOf(old_.tags[f], corner_[f]);
    }
    for (std::size_t v = 0; v < old_.mesh.points.size(); ++v) {
      vertex_.push_back(edges_.inside(v) ? newPoint(s2(v)) : 0);
    }
    for (const auto& edge : edges_.of) addHexagon(edge.first.first, edge.first.second);
    for (std::size_t f = 0; f < old_.tags.size(); ++f) {
      if (old_.tags[f] == 'T') splitGap(f);
    }
    return std::move(result_);
  }

 private:
  const Loop& loop(std::size_t f) const { return old_.mesh.faces[f]; }
  const Vec3& point(std::size_t v) const { return old_.mesh.points[v]; }
  void addFaceOf(char tag, const Loop& face) {
    result_.mesh.faces.push_back(face);
    result_.tags.push_back(tag);
  }
  std::size_t newPoint(const Vec3& p) {
    result_.mesh.points.push_back(p);
    return result_.mesh.points.size() - 1;
  }
  /// The new corner of the face of edge a -> b at a.
  std::size_t cornerAt(std::size_t a, std::size_t b) const {
    const ClampedEdges::Place place = edges_.of.at({a, b});
    return corner_[place.face][place.corner];
  }

  /// What the formulas call L, J, R, q_i, and the nearest boundary points of the faces before and after.
  struct Named {
    Vec3 left, joint, right, rightBefore, leftAfter;
    std::vector<Vec3> q;
  };
  Named named(std::size_t f) const {
    const Loop& l = loop(f);
    const std::size_t rightAt = old_.tags[f] == 'C' ? 2 : 1;
    Named n;
    n.left = point(l[0]);
    n.right = point(l[rightAt]);
    n.joint = rightAt == 2 ? point(l[1]) : 0.5 * (n.left + n.right);
    for (std::size_t i = rightAt + 1; i < l.size(); ++i) n.q.push_back(point(l[i]));
    n.leftAfter = point(after_.at(l[rightAt]));
    n.rightBefore = point(before_.at(l[0]));
    return n;
  }

  Vec3 newCorner(std::size_t f, std::size_t i) const {
    if (old_.tags[f] == 'I') return s1(corners(old_.mesh, f), i);
    const Named n = named(f);
    const std::size_t rightAt = old_.tags[f] == 'C' ? 2 : 1;
    if (i == 0) return 0.5 * (n.left + n.joint);
    if (i == rightAt) return 0.5 * (n.right + n.joint);
    if (i < rightAt) return n.joint;
    const std::size_t q = i - rightAt - 1;
    return old_.tags[f] == 'B' || n.q.size() == 3 ? sideCorner(n, q) : cornerCorner(n, q);
  }

  static Vec3 sideCorner(const Named& n, std::size_t i) {
    const std::size_t m = n.q.size();
    if (m == 1) return 0.5 * (n.q[0] + n.joint);
    std::vector<Vec3> polygon = n.q;
    for (std::size_t k = m; k-- > 0;) {
      const double angle = pi * (static_cast<double>(k) + 0.5) / static_cast<double>(m);
      const double c = std::cos(angle) / std::cos(pi / (2 * static_cast<double>(m)));
      const Vec3 h = c >= 0 ? 0.5 * (n.right + n.leftAfter) : 0.5 * (n.left + n.rightBefore);
      const Vec3 onBoundary = (1 - std::abs(c)) * n.joint + std::abs(c) * h;
      polygon.push_back(2.0 * onBoundary - n.q[k]);
    }
    return s1(polygon, i);
  }

  Vec3 cornerCorner(const Named& n, std::size_t i) const {
    const std::size_t m = n.q.size();
    if (m == 1) return 0.25 * (n.joint + n.q[0] + n.left + n.right);
    if (m == 2) return 0.25 * (n.q[i] + (i == 0 ? 2.0 : 1.0) * n.right + (i == 0 ? 1.0 : 2.0) * n.left);
    if (smooth_) return smoothCorner(n, i);
    std::vector<Vec3> polygon = n.q;
    if (m == 4) polygon.insert(polygon.end(), {2.0 * n.joint - n.q[1], 2.0 * n.joint - n.q[2]});
    if (m == 5) polygon.push_back(2.0 * n.joint - n.q[2]);
    if (m > 5) polygon.insert(polygon.end(), {n.joint, n.joint});
    return s1(polygon, i);
  }

  static Vec3 smoothCorner(const Named& n, std::size_t i) {
    const std::size_t m = n.q.size();
    double alpha = 0, beta = 0;
    if (m < 6) {
      const std::vector<std::array<int, 2>> four{{1, -1}, {-1, -2}, {-2, -1}, {-1, 1}};
      const std::vector<std::array<int, 2>> five{{2, -1}, {1, -2}, {-1, -1}, {-2, 1}, {-1, 2}};
      alpha = (m == 4 ? four : five)[i][0];
      beta = (m == 4 ? four : five)[i][1];
    } else {
      // In a plane: R at (1, 0), L at the same distance m sectors further, q_i in the middle of its sector.
      const double sector = 2 * pi / static_cast<double>(m + 2);
      const double angle = (static_cast<double>(i) + 0.5) * sector, whole = static_cast<double>(m) * sector;
      const double away = 1.5 / std::cos(sector / 2);
      beta = away * std::sin(angle) / std::sin(whole);
      alpha = away * std::sin(whole - angle) / std::sin(whole);
    }
    return n.joint + 0.25 * (n.q[i] - n.joint) + 0.25 * (alpha * (n.right - n.joint) + beta * (n.left - n.joint));
  }

  Vec3 s2(std::size_t v) const {
    Vec3 sum{};
    for (const std::size_t x : neighbours_[v]) sum = sum + point(x);
    if (gaps_[v] == 0) return 0.25 * (point(v) + sum);
    return 1.0 / (3 + static_cast<double>(gaps_[v])) * sum;
  }

  void addHexagon(std::size_t a, std::size_t b) {
    if (a > b || !edges_.inside(a) || !edges_.inside(b)) return;
    const ClampedEdges::Place here = edges_.of.at({a, b}), there = edges_.of.at({b, a});
    const auto corner = [&](const ClampedEdges::Place& place, std::size_t next) {
      return corner_[place.face][(place.corner + next) % corner_[place.face].size()];
    };
    addFaceOf('I', {vertex_[a], corner(there, 1), corner(there, 0), vertex_[b], corner(here, 1), corner(here, 0)});
  }

  void splitGap(std::size_t t) {
    const std::size_t right = loop(t)[0], left = loop(t)[1], v = loop(t)[2];
    const std::size_t f = edges_.of.at({right, v}).face, g = edges_.of.at({v, left}).face;
    const Vec3 jointF = named(f).joint, jointG = named(g).joint;
    const std::size_t lm = newPoint(0.25 * (jointF + 2.0 * point(right) + point(left)));
    const std::size_t rm = newPoint(0.25 * (point(right) + 2.0 * point(left) + jointG));
    const ClampedEdges::Place intoF = edges_.of.at({right, v});
    const std::size_t qf = corner_[f][(intoF.corner + 1) % corner_[f].size()];
    const std::size_t qg = cornerAt(v, left);
    addFaceOf('B', {lm, rm, qg, vertex_[v], qf});
    addFaceOf('T', {cornerAt(right, v), lm, qf});
    addFaceOf('T', {rm, corner_[g][0], qg});
  }

  const ClampedMesh& old_;
  bool smooth_;
  ClampedEdges edges_;
  std::vector<Loop> neighbours_;
  std::vector<std::size_t> gaps_;                      ///< at each vertex
  std::map<std::size_t, std::size_t> after_, before_;  ///< along the boundary
  ClampedMesh result_;
  std::vector<Loop> corner_;         ///< new points of the corners of each face but gaps
  std::vector<std::size_t> vertex_;  ///< new points of the vertices inside
};

}  // namespace

ClampedMesh referenceClamp(const PolyMesh& mesh) {
  return Clamp(mesh).run();
}

ClampedMesh referenceClampedStep(const ClampedMesh& mesh, bool smooth) {
  return ClampedStep(mesh, smooth).run();
}

}  // namespace honeycomb::Test
