#include "far/conversions/split_non_manifold.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "far/base/index.h"
#include "far/topology/defects.h"
#include "far/topology/edge_matching.h"

namespace honeycomb::Far {
namespace {

bool isFaceDefect(const Defect& defect) {
  return defect.kind == DefectKind::indexOutOfRange || defect.kind == DefectKind::tooFewSides ||
         defect.kind == DefectKind::repeatedVertex;
}
bool isEdgeDefect(const Defect& defect) {
  return defect.kind == DefectKind::edgeOverused || defect.kind == DefectKind::opposedFaces;
}

class Splitter {
 public:
  explicit Splitter(const Polygons& source) : source_(source) {}

  ManifoldSplit run() {
    takeSoundFaces();
    countDefects();
    // A vertex can be left on a wrong edge with both its ends in one fan; then its corners part one by one.
    for (bool everyCorner = false; cut(everyCorner);) everyCorner = true;
    carryTags();
    return std::move(result_);
  }

 private:
  Polygons& polygons() { return result_.polygons; }

  void takeSoundFaces() {
    std::vector<bool> sound(at(source_.faceCount()), true);
    Polygons faces = source_;
    faces.corners.clear();
    faces.creases.clear();
    for (const Defect& defect : inspect(faces).defects)
      if (isFaceDefect(defect)) sound[at(defect.face)] = false;
    polygons().vertexCount = source_.vertexCount;
    for (std::int64_t f = 0; f < source_.faceCount(); ++f) {
      result_.facesLeftOut += sound[at(f)] ? 0 : 1;
      if (!sound[at(f)]) continue;
      const auto first = source_.indices.begin();
      polygons().addFace({first + source_.faceOffsets[at(f)], first + source_.faceOffsets[at(f) + 1]});
      result_.sourceFaces.push_back(f);
    }
    result_.sourceVertices.resize(at(source_.vertexCount));
    std::iota(result_.sourceVertices.begin(), result_.sourceVertices.end(), 0);
  }

  void countDefects() {
    std::set<std::pair<std::int64_t, std::int64_t>> edges;
    for (const Defect& defect : inspect(polygons()).defects) {
      if (isEdgeDefect(defect)) edges.emplace(std::minmax(defect.vertex, defect.vertex2));
      result_.bowTies += defect.kind == DefectKind::bowTie ? 1 : 0;
    }
    result_.edgesCut = std::ssize(edges);
  }

  std::int32_t previous(std::int32_t c, const std::vector<std::int32_t>& faces) const {
    const std::size_t f = at(faces[at(c)]);
    const std::vector<std::int64_t>& offsets = result_.polygons.faceOffsets;
    return c == offsets[f] ? static_cast<std::int32_t>(offsets[f + 1] - 1) : c - 1;
  }

  /// Gives each fan its own vertex. `everyCorner`: a corner at a wrong edge is a fan of its own. Returns whether there
  /// was anything to cut.
  bool cut(bool everyCorner) {
    const Inspection inspection = inspect(polygons());
    const auto toCut = [](const Defect& d) { return isEdgeDefect(d) || d.kind == DefectKind::bowTie; };
    if (std::none_of(inspection.defects.begin(), inspection.defects.end(), toCut)) return false;
    const std::vector<std::int32_t> fans = findFans(inspection, everyCorner);
    std::vector<std::int32_t> firstFan(at(polygons().vertexCount), -1);
    std::vector<std::int32_t> vertexOfFan(fans.size(), -1);  // by the fan's lowest corner
    for (std::size_t c = 0; c < fans.size(); ++c) {
      const std::int32_t v = polygons().indices[c];
      std::int32_t& vertex = vertexOfFan[at(fans[c])];
      if (vertex < 0 && firstFan[at(v)] < 0) {
        firstFan[at(v)] = fans[c];
        vertex = v;
      } else if (vertex < 0) {
        vertex = polygons().vertexCount++;
        result_.sourceVertices.push_back(result_.sourceVertices[at(v)]);
      }
      polygons().indices[c] = vertex;
    }
    return true;
  }

  /// The lowest corner of each corner's fan: corners at one vertex that edges with two faces join.
  std::vector<std::int32_t> findFans(const Inspection& inspection, bool everyCorner) const {
    const std::vector<std::int32_t>& twin = inspection.edges.twin;
    std::vector<std::int32_t> fans(twin.size());
    std::iota(fans.begin(), fans.end(), 0);
    const auto root = [&fans](std::int32_t c) {
      while (fans[at(c)] != c) c = fans[at(c)] = fans[at(fans[at(c)])];
      return c;
    };
    const auto isWrong = [&](std::int32_t c) {
      return twin[at(c)] == EdgeMatching::kBroken ||
             twin[at(previous(c, inspection.cornerFace))] == EdgeMatching::kBroken;
    };
    for (std::int32_t c = 0; c < std::ssize(twin); ++c) {
      const std::int32_t beside = twin[at(previous(c, inspection.cornerFace))];
      if (beside < 0 || (everyCorner && (isWrong(c) || isWrong(beside)))) continue;
      const std::int32_t a = root(c), b = root(beside);
      fans[at(std::max(a, b))] = std::min(a, b);
    }
    for (std::int32_t c = 0; c < std::ssize(twin); ++c) fans[at(c)] = root(c);
    return fans;
  }

  void carryTags() {
    std::set<std::int32_t> corners(source_.corners.begin(), source_.corners.end());
    for (std::int32_t v = 0; v < polygons().vertexCount; ++v)
      if (corners.count(result_.sourceVertices[at(v)]) != 0) polygons().corners.push_back(v);
    if (source_.creases.empty()) return;
    std::map<std::pair<std::int32_t, std::int32_t>, double> sharpness;
    for (const Crease& crease : source_.creases)
      sharpness.try_emplace(std::minmax(crease.vertex0, crease.vertex1), crease.sharpness);
    std::set<std::pair<std::int32_t, std::int32_t>> done;
    for (std::int64_t f = 0; f < polygons().faceCount(); ++f) {
      const std::int64_t begin = polygons().faceOffsets[at(f)], end = polygons().faceOffsets[at(f) + 1];
      for (std::int64_t c = begin; c < end; ++c) {
        const std::int32_t v = polygons().indices[at(c)], w = polygons().indices[at(c + 1 == end ? begin : c + 1)];
        const auto found = sharpness.find(std::minmax(result_.sourceVertices[at(v)], result_.sourceVertices[at(w)]));
        if (found != sharpness.end() && done.insert(std::minmax(v, w)).second)
          polygons().creases.push_back({v, w, found->second});
      }
    }
  }

  const Polygons& source_;
  ManifoldSplit result_;
};

}  // namespace

ManifoldSplit splitNonManifold(const Polygons& polygons) {
  return Splitter(polygons).run();
}

}  // namespace honeycomb::Far
