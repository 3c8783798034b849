#include "far/topology/defects.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/crease_edges.h"
#include "far/topology/edge_matching.h"

namespace honeycomb::Far {

namespace {

/// The first vertex that stands twice in a loop, if any. Quadratic for short loops, sorted for long ones.
std::optional<std::int32_t> repeatedVertex(std::span<const std::int32_t> loop) {
  constexpr std::size_t kShort = 16;
  if (loop.size() <= kShort) {
    for (std::size_t i = 1; i < loop.size(); ++i) {
      if (std::find(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i), loop[i]) !=
          loop.begin() + static_cast<std::ptrdiff_t>(i)) {
        return loop[i];
      }
    }
    return std::nullopt;
  }
  std::vector<std::int32_t> sorted(loop.begin(), loop.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  return twice == sorted.end() ? std::nullopt : std::optional(*twice);
}

std::optional<Defect> faceDefect(const Polygons& polygons, std::int64_t f) {
  const auto begin = at(polygons.faceOffsets[at(f)]);
  const auto end = at(polygons.faceOffsets[at(f) + 1]);
  const auto loop = std::span<const std::int32_t>(polygons.indices).subspan(begin, end - begin);
  for (const std::int32_t v : loop) {
    if (v < 0 || v >= polygons.vertexCount) return Defect{DefectKind::indexOutOfRange, f, v, -1, -1};
  }
  if (loop.size() < 3) return Defect{DefectKind::tooFewSides, f, -1, -1, -1};
  if (const auto v = repeatedVertex(loop)) return Defect{DefectKind::repeatedVertex, f, *v, -1, -1};
  return std::nullopt;
}

/// Fills sound[f] and returns the defects of single faces.
std::vector<Defect> inspectFaces(const Polygons& polygons, std::vector<std::uint8_t>& sound) {
  sound.assign(at(polygons.faceCount()), 1);
  Parallel::forEach(
      0, polygons.faceCount(), [&](std::int64_t f) { sound[at(f)] = !faceDefect(polygons, f); }, 1024);
  std::vector<Defect> defects;
  for (std::int64_t f = 0; f < polygons.faceCount(); ++f) {
    if (!sound[at(f)]) defects.push_back(*faceDefect(polygons, f));
  }
  return defects;
}

/// Corners next to a corner within its face.
class CornerWalk {
 public:
  CornerWalk(const Polygons& polygons, const Inspection& inspection) : polygons_(polygons), inspection_(inspection) {}

  /// The next corner counter-clockwise round the vertex of c: the twin of the corner before it in its face.
  std::int32_t nextOutgoing(std::int32_t c) const {
    const std::size_t f = at(inspection_.cornerFace[at(c)]);
    const std::int64_t prev = c == polygons_.faceOffsets[f] ? polygons_.faceOffsets[f + 1] - 1 : c - 1;
    return inspection_.edges.twin[at(prev)];
  }

  /// How many corners the fan that starts at c has; -1 when it meets an edge with a defect.
  std::int32_t fanSize(std::int32_t c) const {
    std::int32_t size = 0;
    std::int32_t h = c;
    do {
      ++size;
      h = nextOutgoing(h);
    } while (h >= 0 && h != c);
    return h == EdgeMatching::kBroken ? -1 : size;
  }

 private:
  const Polygons& polygons_;
  const Inspection& inspection_;
};

/// Bow-ties and isolated vertices. A vertex at which a face or an edge is wrong has been reported already.
void inspectVertices(const Polygons& polygons, Inspection& inspection) {
  std::vector<std::int32_t> cornersAt(at(polygons.vertexCount), 0);
  std::vector<std::uint8_t> broken(at(polygons.vertexCount), 0);
  for (std::size_t c = 0; c < polygons.indices.size(); ++c) {
    const std::int32_t v = polygons.indices[c];
    if (v < 0 || v >= polygons.vertexCount) continue;
    ++cornersAt[at(v)];
    if (inspection.edges.twin[c] == EdgeMatching::kBroken) broken[at(v)] = 1;
  }
  // Out-of-range corners carry no vertex to start from.
  std::vector<std::int32_t> vert = polygons.indices;
  for (std::int32_t& v : vert) v = v < 0 || v >= polygons.vertexCount ? polygons.vertexCount : v;
  const Array<std::int32_t> outgoing = outgoingCorners(vert, inspection.edges.twin, polygons.vertexCount + 1);

  const CornerWalk walk(polygons, inspection);
  std::vector<std::int8_t> verdict(at(polygons.vertexCount), 0);
  Parallel::forEach(
      0, polygons.vertexCount,
      [&](std::int64_t v) {
        if (outgoing[at(v)] < 0) {
          verdict[at(v)] = 2;
        } else if (!broken[at(v)]) {
          const std::int32_t size = walk.fanSize(outgoing[at(v)]);
          verdict[at(v)] = size >= 0 && size != cornersAt[at(v)] ? 1 : 0;
        }
      },
      1024);
  for (const DefectKind kind : {DefectKind::bowTie, DefectKind::isolatedVertex}) {
    for (std::int64_t v = 0; v < polygons.vertexCount; ++v) {
      if (verdict[at(v)] == (kind == DefectKind::bowTie ? 1 : 2)) inspection.defects.push_back({kind, -1, v, -1, -1});
    }
  }
  const std::vector<std::uint8_t> onCrease = creaseVertices(polygons);
  for (const std::int32_t v : polygons.corners) {
    const bool inRange = v >= 0 && v < polygons.vertexCount;
    const std::int32_t out = inRange ? outgoing[at(v)] : -1;
    if (out < 0 || (inspection.edges.twin[at(out)] >= 0 && onCrease[at(v)] == 0)) {
      inspection.defects.push_back({DefectKind::cornerNotOnBoundary, -1, v, -1, -1});
    }
  }
}

}  // namespace

Inspection inspect(const Polygons& polygons) {
  Inspection inspection;
  std::vector<std::uint8_t> sound;
  inspection.defects = inspectFaces(polygons, sound);
  inspection.cornerFace = cornerFaces(polygons);
  inspection.edges = matchEdges(polygons, inspection.cornerFace, sound);
  const auto overused = std::stable_partition(inspection.edges.defects.begin(), inspection.edges.defects.end(),
                                              [](const Defect& d) { return d.kind == DefectKind::edgeOverused; });
  const auto byFace = [](const Defect& a, const Defect& b) { return a.face < b.face; };
  std::stable_sort(inspection.edges.defects.begin(), overused, byFace);
  std::stable_sort(overused, inspection.edges.defects.end(), byFace);
  inspection.defects.insert(inspection.defects.end(), inspection.edges.defects.begin(), inspection.edges.defects.end());
  inspectVertices(polygons, inspection);
  const std::vector<Defect> creases = CreaseEdges(polygons).defects(polygons, inspection.cornerFace, sound);
  inspection.defects.insert(inspection.defects.end(), creases.begin(), creases.end());
  std::stable_sort(inspection.defects.begin(), inspection.defects.end(),
                   [](const Defect& a, const Defect& b) { return a.kind < b.kind; });
  return inspection;
}

std::vector<Defect> findDefects(const Polygons& polygons) {
  return inspect(polygons).defects;
}

std::string describe(const Defect& d) {
  switch (d.kind) {
    case DefectKind::indexOutOfRange:
      return fmt::format("face {} names vertex {}, which doesn't exist", d.face, d.vertex);
    case DefectKind::tooFewSides:
      return fmt::format("face {} has fewer than three sides", d.face);
    case DefectKind::repeatedVertex:
      return fmt::format("face {} has vertex {} twice", d.face, d.vertex);
    case DefectKind::edgeOverused:
      return fmt::format("face {} is the third on the edge between vertices {} and {}, after face {}", d.face, d.vertex,
                         d.vertex2, d.otherFace);
    case DefectKind::opposedFaces:
      return fmt::format("face {} runs along the edge between vertices {} and {} in the same direction as face {}",
                         d.face, d.vertex, d.vertex2, d.otherFace);
    case DefectKind::bowTie:
      return fmt::format("the faces at vertex {} form more than one fan", d.vertex);
    case DefectKind::isolatedVertex:
      return fmt::format("vertex {} is in no face", d.vertex);
    case DefectKind::cornerNotOnBoundary:
      return fmt::format("vertex {} is tagged a corner but is neither on a boundary nor on a crease", d.vertex);
    case DefectKind::creaseSharpness:
      return fmt::format("the crease between vertices {} and {} has a sharpness that is negative or not finite",
                         d.vertex, d.vertex2);
    case DefectKind::creaseConflict:
      return fmt::format("the edge between vertices {} and {} has two creases of different sharpness", d.vertex,
                         d.vertex2);
    case DefectKind::creaseWithoutEdge:
      return fmt::format("there is a crease between vertices {} and {}, but no edge", d.vertex, d.vertex2);
  }
  return {};
}

std::string_view remedy(DefectKind kind) {
  switch (kind) {
    case DefectKind::indexOutOfRange:
      return "correct the index or add the vertex";
    case DefectKind::tooFewSides:
      return "remove the face";
    case DefectKind::repeatedVertex:
      return "remove the duplicate corner or split the face there";
    case DefectKind::edgeOverused:
      return "remove the extra faces or duplicate the edge's vertices";
    case DefectKind::opposedFaces:
      return "reverse one of the two faces";
    case DefectKind::bowTie:
      return "duplicate the vertex, one for each fan";
    case DefectKind::isolatedVertex:
      return "remove the vertex";
    case DefectKind::cornerNotOnBoundary:
      return "remove the tag";
    case DefectKind::creaseSharpness:
      return "give it a sharpness from 0 to 10, which is infinite";
    case DefectKind::creaseConflict:
      return "leave one of them";
    case DefectKind::creaseWithoutEdge:
      return "remove the crease or name two neighbours";
  }
  return {};
}

std::vector<std::int32_t> cornersPerVertex(const Polygons& polygons) {
  std::vector<std::int32_t> count(at(polygons.vertexCount), 0);
  for (const std::int32_t v : polygons.indices)
    if (v >= 0 && v < polygons.vertexCount) ++count[at(v)];
  return count;
}

}  // namespace honeycomb::Far
