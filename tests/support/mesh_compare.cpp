#include "tests/support/mesh_compare.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <unordered_map>

namespace honeycomb::Test {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

struct Corner {
  std::size_t face = 0;
  std::size_t place = 0;
};

/// Directed edge a -> b, as one number, to the corner it leaves.
class Edges {
 public:
  explicit Edges(const PolyMesh& mesh) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Loop& loop = mesh.faces[f];
      for (std::size_t i = 0; i < loop.size(); ++i) {
        simple_ = corners_.insert({key(loop[i], loop[(i + 1) % loop.size()]), {f, i}}).second && simple_;
      }
    }
  }
  bool simple() const { return simple_; }
  const Corner* find(std::size_t from, std::size_t to) const {
    const auto it = corners_.find(key(from, to));
    return it == corners_.end() ? nullptr : &it->second;
  }

 private:
  static std::uint64_t key(std::size_t from, std::size_t to) { return std::uint64_t{from} << 32 | to; }
  std::unordered_map<std::uint64_t, Corner> corners_;
  bool simple_ = true;
};

/// Points in cells, to find those within a tolerance.
class Cells {
 public:
  Cells(const std::vector<Vec3>& points, double tolerance)
      : points_(points), tolerance_(tolerance), cell_(std::max(4 * tolerance, 1e-6)) {
    for (std::size_t i = 0; i < points.size(); ++i) cells_[keyOf(points[i])].push_back(i);
  }
  std::vector<std::size_t> near(const Vec3& p) const {
    const Vec3 reach{tolerance_, tolerance_, tolerance_};
    const Key low = keyOf(p - reach);
    const Key high = keyOf(p + reach);
    std::vector<std::size_t> result;
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) collect({x, y, z}, p, result);
      }
    }
    return result;
  }

 private:
  using Key = std::array<std::int64_t, 3>;
  Key keyOf(const Vec3& p) const {
    Key key{};
    for (std::size_t k = 0; k < 3; ++k) key[k] = static_cast<std::int64_t>(std::floor(p[k] / cell_));
    return key;
  }
  void collect(const Key& key, const Vec3& p, std::vector<std::size_t>& result) const {
    const auto it = cells_.find(key);
    if (it == cells_.end()) return;
    for (const std::size_t i : it->second) {
      if (distance(points_[i], p) <= tolerance_) result.push_back(i);
    }
  }
  const std::vector<Vec3>& points_;
  double tolerance_;
  double cell_;
  std::map<Key, std::vector<std::size_t>> cells_;
};

class Matcher {
 public:
  Matcher(const PolyMesh& a, const PolyMesh& b, double tolerance)
      : a_(a), b_(b), edgesA_(a), edgesB_(b), cells_(b.points, tolerance) {
    match_.vertexMap.assign(a.points.size(), kNone);
    match_.faceMap.assign(a.faces.size(), kNone);
    inverseVertex_.assign(b.points.size(), kNone);
    inverseFace_.assign(b.faces.size(), kNone);
  }

  MeshMatch run() {
    if (!checkCounts() || !findCandidates()) return match_;
    for (std::size_t v = 0; v < b_.faces.size(); ++v) {
      for (std::size_t i = 0; i < b_.faces[v].size(); ++i) cornersAtB_[b_.faces[v][i]].push_back({v, i});
    }
    for (std::size_t f = 0; f < a_.faces.size(); ++f) {
      if (match_.faceMap[f] == kNone && !placePart(f)) return fail("no place for the part with face", f);
    }
    for (std::size_t v = 0; v < a_.points.size(); ++v) {
      if (match_.vertexMap[v] == kNone) return fail("no face uses vertex", v);
      match_.maxDistance = std::max(match_.maxDistance, distance(a_.points[v], b_.points[match_.vertexMap[v]]));
    }
    match_.same = true;
    return match_;
  }

 private:
  MeshMatch fail(const char* what, std::size_t number) {
    match_.why = std::string(what) + " " + std::to_string(number);
    return match_;
  }

  bool checkCounts() {
    std::ostringstream why;
    if (a_.points.size() != b_.points.size()) why << a_.points.size() << " vertices, not " << b_.points.size() << "; ";
    if (a_.faces.size() != b_.faces.size()) why << a_.faces.size() << " faces, not " << b_.faces.size() << "; ";
    if (!edgesA_.simple() || !edgesB_.simple()) why << "an edge with two faces on one side; ";
    match_.why = why.str();
    return match_.why.empty();
  }

  bool findCandidates() {
    for (std::size_t v = 0; v < a_.points.size(); ++v) {
      candidates_.push_back(cells_.near(a_.points[v]));
      if (!candidates_.back().empty()) continue;
      double nearest = HUGE_VAL;
      for (const Vec3& p : b_.points) nearest = std::min(nearest, distance(p, a_.points[v]));
      fail("no partner for vertex", v);
      match_.why += ", the nearest at " + std::to_string(nearest);
      return false;
    }
    return true;
  }

  /// Lays the connected part with face f somewhere on b.
  bool placePart(std::size_t f) {
    for (const std::size_t image : candidates_[a_.faces[f][0]]) {
      const auto corners = cornersAtB_.find(image);
      if (corners == cornersAtB_.end()) continue;
      for (const Corner& corner : corners->second) {
        if (walk({f, 0}, corner)) return true;
      }
    }
    return false;
  }

  bool walk(const Corner& from, const Corner& onto) {
    std::vector<std::pair<Corner, Corner>> open{{from, onto}};
    trail_.clear();
    trailFaces_.clear();
    while (!open.empty()) {
      const auto [ca, cb] = open.back();
      open.pop_back();
      if (!layFace(ca, cb, open)) {
        undo();
        return false;
      }
    }
    return true;
  }

  bool layFace(const Corner& ca, const Corner& cb, std::vector<std::pair<Corner, Corner>>& open) {
    const Loop& la = a_.faces[ca.face];
    const Loop& lb = b_.faces[cb.face];
    const std::size_t n = la.size();
    const bool done = match_.faceMap[ca.face] != kNone;
    if (n != lb.size() || (done && match_.faceMap[ca.face] != cb.face)) return false;
    if (!done && inverseFace_[cb.face] != kNone) return false;
    for (std::size_t k = 0; k < n; ++k) {
      if (!layVertex(la[(ca.place + k) % n], lb[(cb.place + k) % n])) return false;
    }
    if (done) return true;
    match_.faceMap[ca.face] = cb.face;
    inverseFace_[cb.face] = ca.face;
    trailFaces_.push_back(ca.face);
    for (std::size_t k = 0; k < n; ++k) {
      const Corner* na = edgesA_.find(la[(ca.place + k + 1) % n], la[(ca.place + k) % n]);
      const Corner* nb = edgesB_.find(lb[(cb.place + k + 1) % n], lb[(cb.place + k) % n]);
      if ((na == nullptr) != (nb == nullptr)) return false;
      if (na != nullptr) open.emplace_back(*na, *nb);
    }
    return true;
  }

  bool layVertex(std::size_t v, std::size_t w) {
    if (match_.vertexMap[v] != kNone || inverseVertex_[w] != kNone) {
      return match_.vertexMap[v] == w && inverseVertex_[w] == v;
    }
    if (std::find(candidates_[v].begin(), candidates_[v].end(), w) == candidates_[v].end()) return false;
    match_.vertexMap[v] = w;
    inverseVertex_[w] = v;
    trail_.push_back(v);
    return true;
  }

  void undo() {
    for (const std::size_t v : trail_) {
      inverseVertex_[match_.vertexMap[v]] = kNone;
      match_.vertexMap[v] = kNone;
    }
    for (const std::size_t f : trailFaces_) {
      inverseFace_[match_.faceMap[f]] = kNone;
      match_.faceMap[f] = kNone;
    }
  }

  const PolyMesh& a_;
  const PolyMesh& b_;
  Edges edgesA_;
  Edges edgesB_;
  Cells cells_;
  MeshMatch match_;
  std::vector<std::vector<std::size_t>> candidates_;
  std::map<std::size_t, std::vector<Corner>> cornersAtB_;
  std::vector<std::size_t> inverseVertex_;
  std::vector<std::size_t> inverseFace_;
  std::vector<std::size_t> trail_;
  std::vector<std::size_t> trailFaces_;
};

}  // namespace

MeshMatch matchMeshes(const PolyMesh& a, const PolyMesh& b, double tolerance) {
  return Matcher(a, b, tolerance).run();
}

}  // namespace honeycomb::Test
