#include "far/conversions/pair_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "far/base/index.h"
#include "far/topology/edge_matching.h"

namespace honeycomb::Far {
namespace {

using Point = std::array<double, 3>;

Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// NaN where one of them has no length.
double cosine(const Point& a, const Point& b) {
  return dot(a, b) / std::sqrt(dot(a, a) * dot(b, b));
}

class Pairing {
 public:
  Pairing(const Polygons& polygons, std::span<const double> positions, std::span<const std::int32_t> cornerKeys,
          const PairingLimits& limits)
      : polygons_(polygons),
        positions_(positions),
        keys_(cornerKeys),
        limits_(limits),
        inspection_(inspect(polygons)),
        partner_(at(polygons.faceCount()), -1) {
    for (const Crease& crease : polygons.creases) creased_.insert(std::minmax(crease.vertex0, crease.vertex1));
  }

  TrianglePairing run() {
    countEdges();
    std::vector<std::pair<double, std::int32_t>> candidates;  // skew, lower corner of the edge
    for (std::int32_t c = 0; c < std::ssize(twin()); ++c)
      if (const auto skew = skewAcross(c)) candidates.emplace_back(*skew, c);
    std::sort(candidates.begin(), candidates.end());
    for (const auto& candidate : candidates) join(candidate.second);
    return write();
  }

 private:
  const std::vector<std::int32_t>& twin() const { return inspection_.edges.twin; }
  std::int32_t face(std::int32_t c) const { return inspection_.cornerFace[at(c)]; }
  bool isTriangle(std::int32_t f) const { return polygons_.faceOffsets[at(f) + 1] - polygons_.faceOffsets[at(f)] == 3; }
  /// The k-th corner behind c in a triangle.
  std::int32_t behind(std::int32_t c, std::int64_t k) const {
    const std::int64_t begin = polygons_.faceOffsets[at(face(c))];
    return static_cast<std::int32_t>(begin + (c - begin + k) % 3);
  }
  std::int32_t vertex(std::int32_t c) const { return polygons_.indices[at(c)]; }
  Point point(std::int32_t c) const {
    const std::size_t v = 3 * at(vertex(c));
    return {positions_[v], positions_[v + 1], positions_[v + 2]};
  }

  /// Edges at each vertex, and how many must stay: inside the mesh three.
  void countEdges() {
    edges_.assign(at(polygons_.vertexCount), 0);
    least_.assign(at(polygons_.vertexCount), 3);
    for (std::int64_t f = 0; f < polygons_.faceCount(); ++f) {
      const std::int64_t begin = polygons_.faceOffsets[at(f)], end = polygons_.faceOffsets[at(f) + 1];
      for (std::int64_t c = begin; c < end; ++c) {
        const std::int32_t across = twin()[at(c)];
        const std::int32_t v = polygons_.indices[at(c)], w = polygons_.indices[at(c + 1 == end ? begin : c + 1)];
        if (across == EdgeMatching::kBroken || (across >= 0 && across < c)) continue;
        for (const std::int32_t end2 : {v, w}) {
          ++edges_[at(end2)];
          if (across == EdgeMatching::kBoundary) least_[at(end2)] = 2;
        }
      }
    }
  }

  /// The greatest |cosine| of the quad across the edge of corner c; none where there may be no quad.
  std::optional<double> skewAcross(std::int32_t c) const {
    const std::int32_t d = twin()[at(c)];
    if (d <= c || !isTriangle(face(c)) || !isTriangle(face(d))) return std::nullopt;
    const std::int32_t c1 = behind(c, 1), d1 = behind(d, 1);
    if (creased_.count(std::minmax(vertex(c), vertex(d))) != 0) return std::nullopt;
    if (!keys_.empty() && (keys_[at(c)] != keys_[at(d1)] || keys_[at(c1)] != keys_[at(d)])) return std::nullopt;
    // The edge runs from c to c1; the quad is c, d's apex, c1, c's apex.
    const std::array<Point, 4> quad{point(c), point(behind(d, 2)), point(c1), point(behind(c, 2))};
    const Point n = cross(minus(quad[2], quad[0]), minus(quad[3], quad[0]));
    const Point m = cross(minus(quad[1], quad[0]), minus(quad[2], quad[0]));
    if (!(cosine(n, m) >= limits_.bend)) return std::nullopt;
    double skew = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point ahead = minus(quad[(k + 1) % 4], quad[k]), back = minus(quad[(k + 3) % 4], quad[k]);
      const Point turn = cross(ahead, back);
      if (!(dot(turn, n) > 0) || !(dot(turn, m) > 0)) return std::nullopt;
      skew = std::max(skew, std::abs(cosine(ahead, back)));
    }
    return skew <= limits_.skew ? std::optional(skew) : std::nullopt;
  }

  void join(std::int32_t c) {
    const std::int32_t d = twin()[at(c)];
    const std::size_t v = at(vertex(c)), w = at(vertex(d));
    if (partner_[at(face(c))] >= 0 || partner_[at(face(d))] >= 0) return;
    if (edges_[v] <= least_[v] || edges_[w] <= least_[w]) return;
    --edges_[v], --edges_[w];
    partner_[at(face(c))] = c;
    partner_[at(face(d))] = d;
  }

  void add(TrianglePairing& result, std::int64_t corner) const {
    result.sourceCorners.push_back(corner);
    result.polygons.indices.push_back(polygons_.indices[at(corner)]);
  }

  TrianglePairing write() const {
    TrianglePairing result;
    result.polygons.vertexCount = polygons_.vertexCount;
    result.polygons.corners = polygons_.corners;
    result.polygons.creases = polygons_.creases;
    for (std::int32_t f = 0; f < polygons_.faceCount(); ++f) {
      const std::int32_t c = partner_[at(f)];
      if (c >= 0 && face(twin()[at(c)]) < f) continue;
      result.sourceFaces.push_back(f);
      if (c >= 0) {
        for (const std::int32_t corner : {c, behind(twin()[at(c)], 2), behind(c, 1), behind(c, 2)}) add(result, corner);
        ++result.quads;
      } else {
        for (std::int64_t k = polygons_.faceOffsets[at(f)]; k < polygons_.faceOffsets[at(f) + 1]; ++k) add(result, k);
      }
      result.polygons.faceOffsets.push_back(std::ssize(result.polygons.indices));
    }
    return result;
  }

  const Polygons& polygons_;
  std::span<const double> positions_;
  std::span<const std::int32_t> keys_;
  PairingLimits limits_;
  Inspection inspection_;
  std::vector<std::int32_t> partner_;  // per face: its corner at the edge that goes; -1: it stays
  std::vector<std::int32_t> edges_;    // per vertex, as they are left
  std::vector<std::int32_t> least_;
  std::set<std::pair<std::int32_t, std::int32_t>> creased_;
};

}  // namespace

TrianglePairing pairTriangles(const Polygons& polygons, std::span<const double> positions,
                              std::span<const std::int32_t> cornerKeys, const PairingLimits& limits) {
  return Pairing(polygons, positions, cornerKeys, limits).run();
}

}  // namespace honeycomb::Far
