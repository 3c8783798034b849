#include "far/schemes/zhang_wang.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include "far/base/index.h"
#include "far/schemes/zip_boundary.h"

namespace honeycomb::Far {

namespace {

/// The stencils of a step.
class Weights {
 public:
  Weights(const ZhangWangOptions& options, std::vector<std::int32_t> interpolated)
      : o_(options), interpolated_(std::move(interpolated)) {}

  CirculantRule faceRule() const {
    CirculantRule rule;
    rule.here = rule.next = o_.spread / 2;
    rule.central = 1 - o_.spread;
    return rule;
  }

  double limitCentral(std::int32_t sides) const { return (1 - o_.spread) / (1 + o_.pull.at(sides) - o_.spread); }

  void pointRow(const SourceLevel& parent, const NewPoint& point, Row& row) const {
    if (point.kind == PointKind::halfFaceCorner || point.kind == PointKind::cornerFaceCorner) {
      cornerRow(parent, point.halfEdge, 1, row);
    } else {
      addZipBoundaryRow(parent.topology(), point, o_.boundaryWeight, row);
    }
  }

  void centralRow(const SourceLevel& parent, const SplitResult& child, std::int32_t f, Row& row) const {
    const FaceRun& run = child.topology.run(f);
    const std::int32_t element = child.topology.parents()[at(f)];
    if (run.kind == FaceKind::full) {
      run.parent == FaceParent::face ? faceRow(parent, element, row) : vertexRow(parent, child, f, element, row);
      if (!parent.hasCentral()) mergeEntries(row);
    } else {
      cutRow(parent.topology(), run, element, row);
    }
  }

 private:
  /// Corner point v'_h times a weight.
  void cornerRow(const SourceLevel& parent, std::int32_t h, double weight, Row& row) const {
    const Topology& topology = parent.topology();
    row.push_back({topology.vert(h), weight * (o_.spread / 2)});
    row.push_back({topology.dest(h), weight * (o_.spread / 2)});
    addFaceCentral(parent, topology.face(h), weight * (1 - o_.spread), row);
  }

  /// Where the level has no central control vertices: the barycentre of a whole face, the middle of a half face's cut,
  /// the corner of a corner face.
  static void addFaceCentral(const SourceLevel& parent, std::int32_t f, double weight, Row& row) {
    const Topology& topology = parent.topology();
    const FaceKind kind = topology.run(f).kind;
    if (parent.hasCentral() || !isCutByBrick(kind)) return parent.addCentral(f, weight, row);
    const std::int32_t cut = topology.faceOffsets()[at(f)];
    if (kind == FaceKind::corner) {
      row.push_back({topology.vert(cut + 1), weight});
    } else {
      row.insert(row.end(), {{topology.vert(cut), weight / 2}, {topology.vert(cut + 1), weight / 2}});
    }
  }

  void faceRow(const SourceLevel& parent, std::int32_t f, Row& row) const {
    const double a = o_.pull.at(parent.topology().sides(f));
    parent.addCentral(f, 1 - a, row);
    parent.addBarycentre(f, a, row);
  }

  void vertexRow(const SourceLevel& parent, const SplitResult& child, std::int32_t f, std::int32_t v, Row& row) const {
    if (std::binary_search(interpolated_.begin(), interpolated_.end(), v)) {
      return interpolatingRow(parent, child, f, v, row);
    }
    const Topology& topology = parent.topology();
    const std::int32_t faces = topology.facesAt(v);
    const std::int32_t neighbours = faces + (topology.onBoundary(v) ? 1 : 0);
    const double same = 1.0 / (neighbours + faces);
    const double alpha = o_.vertexPull * (o_.alpha ? *o_.alpha / neighbours : same);
    const double beta = o_.vertexPull * (o_.alpha ? (1 - *o_.alpha) / faces : same);
    row.push_back({v, 1 - o_.vertexPull});
    for (const std::int32_t h : topology.halfEdgesFrom(v)) {
      row.push_back({topology.dest(h), alpha});
      addFaceCentral(parent, topology.face(h), beta, row);
      const std::int32_t p = topology.prev(h);
      if (topology.twin(p) < 0) row.push_back({topology.vert(p), alpha});
    }
  }

  /// The central control vertex for which the face's limit, ((1-b) q + a p)/(1 + a - b), is v (eq 15).
  void interpolatingRow(const SourceLevel& parent, const SplitResult& child, std::int32_t f, std::int32_t v,
                        Row& row) const {
    const std::int32_t sides = child.topology.sides(f);
    const double a = o_.pull.at(sides);
    const double b = o_.spread;
    row.push_back({v, (1 + a - b) / (1 - b)});
    const std::int32_t first = child.topology.faceOffsets()[at(f)];
    for (std::int32_t h = first; h < first + sides; ++h) {
      // Round a vertex inside all points are corner points, numbered by their half-edges in the face-faces.
      const std::int32_t corner = child.topology.vert(h);
      const std::int32_t faceFace = child.topology.face(corner);
      const std::int32_t place = corner - child.topology.faceOffsets()[at(faceFace)];
      const std::int32_t source = child.topology.parents()[at(faceFace)];
      cornerRow(parent, parent.topology().faceOffsets()[at(source)] + place, -a / (1 - b) / sides, row);
    }
    mergeEntries(row);
  }

  /// Half faces: the middle of the new cut. Corner faces: the corner.
  void cutRow(const Topology& parent, const FaceRun& run, std::int32_t element, Row& row) const {
    const bool fromFace = run.parent == FaceParent::face;
    if (run.kind == FaceKind::corner) {
      row.push_back({fromFace ? parent.vert(parent.faceOffsets()[at(element)] + 1) : element, 1});
      return;
    }
    const std::int32_t leaving = fromFace ? parent.faceOffsets()[at(element)] : parent.outgoing(element);
    const std::int32_t entering = fromFace ? leaving : parent.enteringBoundary(element);
    const auto kind = [&](std::int32_t b, PointKind cut) {
      const auto boundary = parent.boundary();
      const auto rank = std::lower_bound(boundary.begin(), boundary.end(), b) - boundary.begin();
      return parent.boundaryTags()[at(rank)] == EdgeTag::onLine ? PointKind::edgeMiddle : cut;
    };
    addZipBoundaryRow(parent, {kind(leaving, PointKind::cutStart), leaving}, 0, row);
    addZipBoundaryRow(parent, {kind(entering, PointKind::cutEnd), entering}, 0, row);
    for (Weight& entry : row) entry.weight /= 2;
    mergeEntries(row);
  }

  ZhangWangOptions o_;
  std::vector<std::int32_t> interpolated_;  // ascending
};

Scheme step(const ZhangWangOptions& options, std::vector<std::int32_t> interpolated) {
  const Weights weights(options, std::move(interpolated));
  Scheme scheme;
  scheme.name = "zhang-wang";
  scheme.split = zip(options.boundary);
  scheme.creases = zipCreases(options.boundary);
  scheme.centralPoints = true;
  // Three a corner point; seven or more, some with weights, a central control vertex, of which there are half as many.
  scheme.entriesPerVertex = 9;
  scheme.halfFaces = HalfFaces::ownRows;
  scheme.faceRule = [weights](std::int32_t) { return weights.faceRule(); };
  scheme.pointRow = [weights](const SourceLevel& parent, const NewPoint& point, Row& row) {
    weights.pointRow(parent, point, row);
  };
  scheme.centralRow = [weights](const SourceLevel& parent, const SplitResult& child, std::int32_t f, Row& row) {
    weights.centralRow(parent, child, f, row);
  };
  scheme.limitCentral = [weights](std::int32_t sides) { return weights.limitCentral(sides); };
  return scheme;
}

Result<void> checkRange(std::string_view name, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return fail(ErrorCode::invalidOption,
              fmt::format("{} {} is out of range; it must lie in [{}, {}]", name, value, low, high));
}

Result<void> checkRanges(const ZhangWangOptions& o) {
  if (!(o.spread > 0 && o.spread < 1)) {
    return fail(ErrorCode::invalidOption, fmt::format("b {} is out of range; it must lie in (0, 1)", o.spread));
  }
  if (o.pull.rule == CentralPull::Rule::constant) {
    if (auto ok = checkRange("a", o.pull.value, 0, 1); !ok) return ok;
  }
  if (auto ok = checkRange("c", o.vertexPull, 0, 1); !ok) return ok;
  if (auto ok = checkRange("alpha", o.alpha.value_or(0), 0, 1); !ok) return ok;
  return checkRange("boundary weight", o.boundaryWeight, 0, 1);
}

/// The side counts that whole faces of any level have. Under eq16 a boundary vertex with k > 1 faces gets a face of
/// 2k + 1 sides, whose boundary points have two faces each.
std::set<std::int32_t> sideCounts(const Topology& control, BoundaryRule boundary) {
  std::set<std::int32_t> sides{6};
  for (const FaceRun& run : control.runs()) sides.insert(run.sides);
  for (std::int32_t v = 0; v < control.vertexCount(); ++v) {
    const std::int32_t faces = control.facesAt(v);
    if (!control.onBoundary(v)) sides.insert(2 * faces);
    if (control.onBoundary(v) && boundary == BoundaryRule::eq16 && faces > 1) sides.insert({5, 2 * faces + 1});
  }
  return sides;
}

Result<void> checkTangentPlanes(const Topology& control, const ZhangWangOptions& o) {
  if (o.unchecked) return {};
  for (const std::int32_t n : sideCounts(control, o.boundary)) {
    const double a = o.pull.at(n);
    const double low = o.spread * (1 - std::cos(std::numbers::pi / n));
    const double high = o.spread * (1 + std::cos(std::numbers::pi / n));
    if (a > low && a < high) continue;
    return fail(ErrorCode::invalidOption,
                fmt::format("a = {:.6g} with b = {:.6g}: faces of {} sides would have no tangent plane, a must lie "
                            "between b (1 - cos(pi/{})) = {:.6g} and b (1 + cos(pi/{})) = {:.6g}; change a or b, or "
                            "force them",
                            a, o.spread, n, n, low, n, high));
  }
  return {};
}

bool onCrease(const Topology& control, std::int32_t v) {
  const auto creases = control.creases();
  return std::any_of(creases.begin(), creases.end(), [&](const CreaseEdge& crease) {
    return control.vert(crease.halfEdge) == v || control.vert(crease.mate) == v;
  });
}

Result<std::vector<std::int32_t>> checkInterpolated(const Topology& control, std::vector<std::int32_t> vertices) {
  for (const std::int32_t v : vertices) {
    if (v < 0 || v >= control.vertexCount()) {
      return fail(ErrorCode::invalidOption,
                  fmt::format("interpolated {} is not one of the mesh's {}; leave it out",
                              elementName(ElementKind::vertex, v), control.vertexCount()),
                  v);
    }
    if (control.onBoundary(v)) {
      return fail(ErrorCode::invalidOption,
                  fmt::format("interpolated {} is on the boundary, whose curve depends on the boundary alone; leave it "
                              "out",
                              elementName(ElementKind::vertex, v)),
                  v, ElementKind::vertex);
    }
    if (onCrease(control, v)) {
      return fail(ErrorCode::invalidOption,
                  fmt::format("interpolated {} is on a crease, whose curve depends on the crease alone; leave it out",
                              elementName(ElementKind::vertex, v)),
                  v, ElementKind::vertex);
    }
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

}  // namespace

double CentralPull::at(std::int32_t sides) const {
  const double c = std::cos(2 * std::numbers::pi / sides);
  switch (rule) {
    case Rule::paper:
      return (4 - c) / 9;
    case Rule::kobbelt:
      return (4 - 2 * c) / 9;
    default:
      return value;
  }
}

Result<std::vector<Scheme>> zhangWang(const Topology& control, std::int32_t levels, const ZhangWangOptions& options) {
  if (const auto ok = checkRanges(options); !ok) return tl::unexpected(ok.error());
  if (const auto ok = checkTangentPlanes(control, options); !ok) return tl::unexpected(ok.error());
  Result<std::vector<std::int32_t>> interpolated = checkInterpolated(control, options.interpolatedVertices);
  if (!interpolated) return tl::unexpected(interpolated.error());
  std::vector<Scheme> chain;
  const Scheme plain = step(options, {});
  for (std::int32_t level = 0; level < levels; ++level) chain.push_back(plain);
  if (!chain.empty() && !interpolated->empty()) {
    chain.front() = step(options, *interpolated);
    chain.front().after = std::make_shared<const Scheme>(plain);
  }
  return chain;
}

}  // namespace honeycomb::Far
