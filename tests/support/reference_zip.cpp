#include "tests/support/reference_zip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace honeycomb::Test {
namespace {

using Point = ReferenceMesh::Point;
using Edge = ReferenceMesh::Edge;
using EdgeKey = ReferenceMesh::EdgeKey;

Vec3 mix(double wa, const Vec3& a, double wb, const Vec3& b) {
  return wa * a + wb * b;
}

/// New points by the things they belong to: 'n' the point of a half-edge in its face, 'm' the middle of a boundary
/// edge, 'o'/'d' the points of a cut next to its ends, 'c' a fixed corner, 'b' the new point of a boundary vertex.
using PointKey = std::tuple<char, std::size_t, std::size_t>;

class ZipStep {
 public:
  ZipStep(const ReferenceMesh& from, const ReferenceOptions& options) : from_(from), options_(options) {
    const std::vector<Loop>& faces = from.mesh.faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (std::size_t i = 0; i < faces[f].size(); ++i)
        faceOf_[{faces[f][i], faces[f][(i + 1) % faces[f].size()]}] = {f, i};
    }
    for (const auto& [edge, corner] : faceOf_) {
      if (faceOf_.contains({edge.second, edge.first})) continue;
      leaving_[edge.first] = edge;
      entering_[edge.second] = edge;
    }
  }

  ReferenceMesh run() {
    for (std::size_t f = 0; f < from_.mesh.faces.size(); ++f) {
      if (keeps(f)) faceFace(f);
    }
    for (std::size_t v = 0; v < from_.mesh.points.size(); ++v) {
      if (!leaving_.contains(v)) {
        addFace(roundVertex(v), {true, v});
      } else if (options_.boundary == ReferenceBoundary::brick) {
        brickVertex(v);
      } else if (options_.boundary == ReferenceBoundary::eq16) {
        eq16Vertex(v);
      }
    }
    return std::move(to_);
  }

 private:
  const Loop& loop(std::size_t f) const { return from_.mesh.faces[f]; }
  const Vec3& at(std::size_t v) const { return from_.mesh.points[v]; }
  bool isMid(std::size_t v) const { return from_.points[v] == Point::mid; }
  EdgeKey edge(std::size_t f, std::size_t i) const {
    const std::size_t n = loop(f).size();
    return {loop(f)[i % n], loop(f)[(i + 1) % n]};
  }
  /// The mark of a boundary edge; inner edges count as lying on the line, which changes nothing.
  Edge mark(const EdgeKey& e) const {
    const auto it = from_.edges.find(e);
    return it == from_.edges.end() ? Edge::onLine : it->second;
  }

  bool keeps(std::size_t f) const {
    if (options_.boundary != ReferenceBoundary::drop) return true;
    return std::any_of(loop(f).begin(), loop(f).end(), [this](std::size_t v) { return !leaving_.contains(v); });
  }

  std::size_t add(const PointKey& key, const Vec3& position, Point kind) {
    const auto [it, isNew] = ids_.insert({key, to_.mesh.points.size()});
    if (isNew) {
      to_.mesh.points.push_back(position);
      to_.points.push_back(kind);
    }
    return it->second;
  }

  void addFace(const Loop& face, const ReferenceParent& parent) {
    to_.mesh.faces.push_back(face);
    to_.parents.push_back(parent);
  }

  // ---- the boundary's points -------------------------------------------------------------------------------------

  std::size_t middle(const EdgeKey& e) {
    return add({'m', e.first, e.second}, mix(0.5, at(e.first), 0.5, at(e.second)), Point::mid);
  }

  /// The point of a cut or half cut next to its end `x`, `y` being the other.
  std::size_t cutPoint(char which, const EdgeKey& e, std::size_t x, std::size_t y) {
    const bool mid = isMid(x);
    const double toCorner = mid ? 1.0 / 3 : 0.5;
    const double toEnd = mid ? 1.0 / 6 : 0.25;
    const double w = mark(e) == Edge::toCorner ? toCorner : toEnd;
    return add({which, e.first, e.second}, mix(1 - w, at(x), w, at(y)), mid ? Point::real : Point::mid);
  }
  std::size_t cutStart(const EdgeKey& e) { return cutPoint('o', e, e.first, e.second); }
  std::size_t cutEnd(const EdgeKey& e) { return cutPoint('d', e, e.second, e.first); }
  std::size_t fixedCorner(std::size_t v) { return add({'c', v, 0}, at(v), Point::fixedCorner); }

  // ---- the points of the faces -----------------------------------------------------------------------------------

  std::vector<double> row(std::size_t sides) const {
    return closedFormula(options_.tension(sides), options_.edgeParameter, sides);
  }

  Vec3 onPolygon(const std::vector<Vec3>& polygon, std::size_t n) const {
    const std::vector<double> c = row(polygon.size());
    Vec3 sum{};
    for (std::size_t k = 0; k < c.size(); ++k) sum = sum + c[k] * polygon[(n + k) % c.size()];
    return sum;
  }

  /// The polygon that a cut face and its mirror image make; `cut` is the place of the long edge, and the polygon starts
  /// with the first point of the face that isn't a mid-point, counted from the cut's end.
  std::vector<Vec3> mirrored(std::size_t f, std::size_t cut) const {
    const std::size_t n = loop(f).size();
    std::vector<Vec3> p;
    for (std::size_t i = 0; i < n; ++i) p.push_back(at(loop(f)[(cut + 1 + i) % n]));
    const Vec3 start = p.front();
    const Vec3 end = p.back();
    const bool mid = isMid(loop(f)[cut]);
    if (mid) p = std::vector<Vec3>(p.begin() + 1, p.end() - 1);
    const std::size_t m = mid ? n - 2 : n - 1;
    const double step = std::numbers::pi / static_cast<double>(m);
    std::vector<Vec3> polygon = p;
    for (std::size_t i = p.size() - (mid ? 0 : 1); i-- > (mid ? 0 : 1);) {
      const double angle = step * (static_cast<double>(i) + (mid ? 0.5 : 0));
      const double c = std::cos(angle) / (mid ? std::cos(step / 2) : 1);
      polygon.push_back((1 + c) * start + (1 - c) * end - p[i]);
    }
    return polygon;
  }

  Vec3 facePoint(std::size_t f, std::size_t i) const {
    const std::size_t n = loop(f).size();
    for (std::size_t j = 0; j < n; ++j) {
      if (mark(edge(f, j)) == Edge::toCorner) {
        const std::size_t c = mark(edge(f, j + 1)) == Edge::toCorner ? loop(f)[(j + 1) % n] : loop(f)[j];
        return (1.0 / 3) * (at(c) + at(edge(f, i).first) + at(edge(f, i).second));
      }
      if (mark(edge(f, j)) == Edge::cut) {
        const std::size_t first = isMid(loop(f)[j]) ? j + 2 : j + 1;
        return onPolygon(mirrored(f, j), (i + 2 * n - first) % n);
      }
    }
    std::vector<Vec3> polygon;
    for (const std::size_t v : loop(f)) polygon.push_back(at(v));
    return onPolygon(polygon, i);
  }

  /// The new vertex of half-edge i of face f: its own, or the point of the cut next to a mid-point.
  std::size_t halfEdgePoint(std::size_t f, std::size_t i) {
    const std::size_t n = loop(f).size();
    const EdgeKey after = edge(f, i + 1);
    const EdgeKey before = edge(f, i + n - 1);
    if (mark(after) != Edge::onLine && isMid(after.first)) return cutStart(after);
    if (mark(before) != Edge::onLine && isMid(before.second)) return cutEnd(before);
    const EdgeKey self = edge(f, i);
    const auto known = ids_.find({'n', self.first, self.second});
    if (known != ids_.end()) return known->second;
    return add({'n', self.first, self.second}, facePoint(f, i), Point::real);
  }
  std::size_t halfEdgePoint(const EdgeKey& e) {
    const auto& [f, i] = faceOf_.at(e);
    return halfEdgePoint(f, i);
  }

  // ---- faces -----------------------------------------------------------------------------------------------------

  void faceFace(std::size_t f) {
    Loop face;
    for (std::size_t i = 0; i < loop(f).size(); ++i) {
      const EdgeKey e = edge(f, i);
      const Edge kind = mark(e);
      if (kind == Edge::onLine) {
        face.push_back(halfEdgePoint(f, i));
        continue;
      }
      const bool fromCorner = from_.points[e.first] == Point::fixedCorner;
      const bool toCorner = from_.points[e.second] == Point::fixedCorner;
      if (!fromCorner && !isMid(e.first)) face.push_back(cutStart(e));
      if (toCorner) face.push_back(fixedCorner(e.second));
      if (!toCorner && !isMid(e.second)) face.push_back(cutEnd(e));
      markFaceEdge(e, fromCorner, toCorner);
    }
    addFace(face, {false, f});
  }

  void markFaceEdge(const EdgeKey& e, bool fromCorner, bool toCorner) {
    if (options_.boundary != ReferenceBoundary::brick) return;
    if (fromCorner) {
      to_.edges[{fixedCorner(e.first), cutEnd(e)}] = Edge::toCorner;
    } else if (toCorner) {
      to_.edges[{cutStart(e), fixedCorner(e.second)}] = Edge::toCorner;
    } else {
      to_.edges[{cutStart(e), cutEnd(e)}] = Edge::cut;
    }
  }

  /// v'_h, v'_{prev h}, .. counter-clockwise round v, from the boundary edge that leaves v where there is one.
  Loop roundVertex(std::size_t v) {
    EdgeKey h = leaving_.contains(v) ? leaving_.at(v) : firstLeaving(v);
    const EdgeKey start = h;
    Loop ring;
    while (true) {
      const auto [f, i] = faceOf_.at(h);
      const EdgeKey before = edge(f, i + loop(f).size() - 1);
      ring.push_back(halfEdgePoint(h));
      ring.push_back(halfEdgePoint(before));
      h = {before.second, before.first};
      if (h == start || !faceOf_.contains(h)) return ring;
    }
  }

  EdgeKey firstLeaving(std::size_t v) const { return faceOf_.lower_bound({v, 0})->first; }

  void brickVertex(std::size_t v) {
    const EdgeKey out = leaving_.at(v);
    const EdgeKey in = entering_.at(v);
    if (from_.points[v] == Point::fixedCorner) return;
    if (isMid(v)) {
      to_.edges[{cutEnd(in), cutStart(out)}] = Edge::onLine;
      return;
    }
    const bool outOnLine = mark(out) == Edge::onLine;
    const bool inOnLine = mark(in) == Edge::onLine;
    const std::size_t first = outOnLine ? middle(out) : cutStart(out);
    const std::size_t last = inOnLine ? middle(in) : cutEnd(in);
    const Loop ring = realRing(v, outOnLine, inOnLine);
    Loop face{first};
    face.insert(face.end(), ring.begin(), ring.end());
    face.push_back(last);
    if (from_.points[v] == Point::corner) {
      face.push_back(fixedCorner(v));
      to_.edges[{last, face.back()}] = Edge::toCorner;
      to_.edges[{face.back(), first}] = Edge::toCorner;
    } else {
      to_.edges[{last, first}] = Edge::cut;
    }
    addFace(face, {true, v});
  }

  /// roundVertex without the points that the boundary's cut edges don't have.
  Loop realRing(std::size_t v, bool outOnLine, bool inOnLine) {
    Loop ring;
    EdgeKey h = leaving_.at(v);
    bool first = true;
    while (true) {
      const auto [f, i] = faceOf_.at(h);
      const EdgeKey before = edge(f, i + loop(f).size() - 1);
      const bool last = before == entering_.at(v);
      if (!first || outOnLine) ring.push_back(halfEdgePoint(h));
      if (!last || inOnLine) ring.push_back(halfEdgePoint(before));
      if (last) return ring;
      h = {before.second, before.first};
      first = false;
    }
  }

  void eq16Vertex(std::size_t v) {
    const EdgeKey out = leaving_.at(v);
    const EdgeKey in = entering_.at(v);
    const auto [f, i] = faceOf_.at(out);
    if (edge(f, i + loop(f).size() - 1) == in) return;  // two edges only
    const double s = options_.boundaryWeight;
    const Vec3 position = (1 - s) * at(v) + (s / 2) * (at(out.second) + at(in.first));
    Loop face = roundVertex(v);
    face.push_back(add({'b', v, 0}, position, Point::real));
    addFace(face, {true, v});
  }

  const ReferenceMesh& from_;
  const ReferenceOptions& options_;
  std::map<EdgeKey, std::pair<std::size_t, std::size_t>> faceOf_;
  std::map<std::size_t, EdgeKey> leaving_;
  std::map<std::size_t, EdgeKey> entering_;
  std::map<PointKey, std::size_t> ids_;
  ReferenceMesh to_;
};

}  // namespace

double paperTension(std::size_t sides) {
  return 0.45 + 1.25 / static_cast<double>(sides);
}

double sqrt3Tension(std::size_t sides) {
  const auto n = static_cast<double>(sides);
  const double r = 1 / (std::numbers::sqrt3 * std::cos(std::numbers::pi / n));
  return std::min(1.0, ((3 * n - 5) * r - (n - 5)) / (2 * n));
}

std::vector<double> closedFormula(double tension, double edgeParameter, std::size_t sides) {
  const auto n = static_cast<double>(sides);
  std::vector<double> a(sides, tension);
  for (std::size_t d = 1; d < sides; ++d) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(d) / n;
    a[d] = (3 + 2 * std::cos(angle)) * (1 - tension) / (3 * n - 5);
  }
  std::vector<double> c(sides);
  for (std::size_t k = 0; k < sides; ++k) {
    c[k] = (1 - edgeParameter) * a[k] + edgeParameter * a[(k + sides - 1) % sides];
  }
  return c;
}

ReferenceMesh referenceStart(const PolyMesh& mesh, const std::vector<std::size_t>& cornerTags) {
  ReferenceMesh result;
  result.mesh = mesh;
  result.points.assign(mesh.points.size(), Point::real);
  for (const std::size_t v : cornerTags) result.points[v] = Point::corner;
  return result;
}

ReferenceMesh referenceZip(const ReferenceMesh& from, const ReferenceOptions& options) {
  return ZipStep(from, options).run();
}

}  // namespace honeycomb::Test
