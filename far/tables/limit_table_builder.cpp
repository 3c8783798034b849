#include "far/tables/limit_table_builder.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/clamped_limits.h"
#include "far/tables/half_box_patch.h"
#include "far/tables/level_step.h"
#include "far/tables/level_table_builder.h"
#include "far/tables/mirrored_polygon.h"
#include "far/tables/vertex_patch.h"

namespace honeycomb::Far {

namespace {

/// The rows m, a, b of FrameBatch.
struct FrameWeights {
  std::vector<double> position, a, b;
};

/// By the tangents T1 and T2.
FrameWeights tangentFrame(std::int32_t sides) {
  FrameWeights frame{std::vector<double>(at(sides), 1.0 / sides), std::vector<double>(at(sides)),
                     std::vector<double>(at(sides))};
  for (std::int32_t j = 0; j < sides; ++j) {
    const double angle = 2 * std::numbers::pi * j / sides;
    frame.a[at(j)] = std::cos(angle);
    frame.b[at(j)] = std::sin(angle);
  }
  return frame;
}

FrameWeights polygonFrame(std::int32_t sides) {
  FrameWeights frame = tangentFrame(sides);
  const auto setSpan = [&](const auto& rows) {
    frame.a.assign(rows.begin(), rows.begin() + sides);
    frame.b.assign(rows.begin() + sides, rows.end());
  };
  if (sides == 4) setSpan(kQuadSpan);
  if (sides == 6) setSpan(kHexagonSpan);
  return frame;
}

/// The frame of a polygon with a central control vertex behind its corners, which takes `central` of the position.
FrameWeights centralFrame(std::int32_t sides, double central) {
  FrameWeights frame = tangentFrame(sides);
  for (double& w : frame.position) w *= 1 - central;
  frame.position.push_back(central);
  frame.a.push_back(0);
  frame.b.push_back(0);
  return frame;
}

/// The frame of a half face: of the whole polygon, folded onto the path. A triangle's cut leaves no polygon to mirror.
FrameWeights halfFrame(const MirroredPolygon& polygon) {
  if (polygon.sides() == 2) {
    FrameWeights frame = tangentFrame(3);
    frame.position = {0.5, 0, 0.5};
    return frame;
  }
  const FrameWeights whole = tangentFrame(polygon.sides());
  return {polygon.fold(whole.position), polygon.fold(whole.a), polygon.fold(whole.b)};
}

class RowsBuilder {
 public:
  RowsBuilder(std::int32_t sourceCount, std::int32_t elementCount) {
    rows_.sourceCount = sourceCount;
    rows_.elementCount = elementCount;
  }

  /// Starts a batch; elements are then added one by one or reserved at once.
  void startBatch(const FrameWeights& frame) {
    const auto sides = static_cast<std::int32_t>(frame.position.size());
    rows_.batches.push_back({sides, 0, static_cast<std::int32_t>(rows_.indices.size()),
                             static_cast<std::int32_t>(rows_.elements.size()),
                             static_cast<std::int32_t>(rows_.weights.size())});
    for (const auto* row : {&frame.position, &frame.a, &frame.b}) rows_.weights.append(row->begin(), row->end());
  }

  void addElement(std::int32_t element, const std::vector<std::int32_t>& points) {
    ++rows_.batches.back().count;
    rows_.elements.push_back(element);
    rows_.indices.append(points.begin(), points.end());
  }

  /// All faces of a run, element e(f) for face f; points in loop order, then the central control vertex where the
  /// frame has one.
  template <class ElementOf>
  void addRun(const SourceLevel& level, const FaceRun& run, const ElementOf& elementOf) {
    FrameBatch& batch = rows_.batches.back();
    batch.count += run.faceCount;
    const std::size_t firstElement = rows_.elements.size();
    const std::size_t firstIndex = rows_.indices.size();
    const std::int32_t width = batch.sides;
    rows_.elements.resize(firstElement + at(run.faceCount));
    rows_.indices.resize(firstIndex + at(run.faceCount) * at(width));
    Parallel::forEach(0, run.faceCount, [&](std::int64_t g) {
      const std::int32_t f = run.firstFace + static_cast<std::int32_t>(g);
      std::int32_t* points = rows_.indices.data() + firstIndex + at(g) * at(width);
      const auto loop = level.topology().vert().subspan(at(run.firstHalfEdge) + at(g) * at(run.sides), at(run.sides));
      std::copy(loop.begin(), loop.end(), points);
      if (width > run.sides) points[run.sides] = level.central(f);
      rows_.elements[firstElement + at(g)] = elementOf(f);
    });
  }

  LimitRows finish() {
    rows_.weightsSingle.assign(rows_.weights.begin(), rows_.weights.end());
    return std::move(rows_);
  }

 private:
  LimitRows rows_;
};

std::vector<std::int32_t> pathVertices(const MirroredPolygon& polygon) {
  std::vector<std::int32_t> path;
  path.reserve(at(polygon.count()));
  for (std::int32_t q = 0; q < polygon.count(); ++q) path.push_back(polygon.vertex(q));
  return path;
}

/// Elements with frames of their own, put together by equal weights.
class FrameGroups {
 public:
  void add(std::int32_t element, LimitFrame frame) {
    Group& group = groups_[{frame.position, frame.tangent1, frame.tangent2}];
    group.emplace_back(element, std::move(frame.points));
  }
  void addTo(RowsBuilder& rows) const {
    for (const auto& group : groups_) {
      rows.startBatch({group.first[0], group.first[1], group.first[2]});
      for (const auto& element : group.second) rows.addElement(element.first, element.second);
    }
  }

 private:
  using Group = std::vector<std::pair<std::int32_t, std::vector<std::int32_t>>>;
  std::map<std::array<std::vector<double>, 3>, Group> groups_;
};

/// The faces of one run of a level, whatever their kind. Corner faces have their limit at the corner, the second
/// vertex of their loop.
template <class ElementOf>
void addFaceRun(RowsBuilder& rows, const SourceLevel& level, const Scheme& scheme, const FaceRun& run,
                const ElementOf& elementOf) {
  const Topology& topology = level.topology();
  if (run.kind == FaceKind::half) {
    rows.startBatch(halfFrame(MirroredPolygon(topology, run.firstFace)));
    for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
      rows.addElement(elementOf(f), pathVertices(MirroredPolygon(topology, f)));
    }
    return;
  }
  if (isClamped(run.kind)) {
    FrameGroups frames;
    for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
      frames.add(elementOf(f), clampedFaceFrame(topology, f, scheme.smoothCorners));
    }
    return frames.addTo(rows);
  }
  FrameWeights frame = polygonFrame(run.sides);
  if (run.kind == FaceKind::corner) {
    frame.position.assign(at(run.sides), 0.0);
    frame.position[1] = 1;
  } else if (scheme.limitCentral && level.hasCentral()) {
    frame = centralFrame(run.sides, scheme.limitCentral(run.sides));
  }
  rows.startBatch(frame);
  rows.addRun(level, run, elementOf);
}

/// Vertices without a child face, from the points of their own level.
class VerticesHere {
 public:
  VerticesHere(const SourceLevel& level, const Scheme& scheme)
      : level_(level.topology()), scheme_(scheme), rows_(level.pointCount(), level.topology().vertexCount()) {}

  LimitRows build(const std::vector<std::int32_t>& vertices) {
    // Grouped by shape, so that each shape's weights stand once: mid-points by the weights of their two neighbours.
    std::map<std::int32_t, std::vector<std::int32_t>> mids;
    std::map<std::int32_t, std::vector<std::int32_t>> others;
    FrameGroups clamped;
    for (const std::int32_t v : vertices) {
      if (onClampedBoundary(level_, v)) {
        clamped.add(v, clampedBoundaryFrame(level_, v, scheme_.smoothCorners));
      } else if (level_.vertexTag(v) == VertexTag::mid) {
        mids[10 * neighbourWeight(before(v)) + neighbourWeight(after(v))].push_back(v);
      } else {
        others[level_.sides(level_.face(level_.outgoing(v)))].push_back(v);
      }
    }
    for (const auto& group : mids) addMids(group.second);
    for (const auto& group : others) addLeftBehind(group.first, group.second);
    clamped.addTo(rows_);
    return rows_.finish();
  }

 private:
  std::int32_t before(std::int32_t v) const { return level_.vert(level_.enteringBoundary(v)); }
  std::int32_t after(std::int32_t v) const { return level_.dest(level_.outgoing(v)); }
  /// In the limit (1,8,1)/10 of a boundary mid-point; a fixed corner counts double.
  std::int32_t neighbourWeight(std::int32_t v) const { return level_.vertexTag(v) == VertexTag::fixedCorner ? 2 : 1; }

  /// Points: the mid-points before and after on the boundary, the vertex itself, its neighbour inside.
  void addMids(const std::vector<std::int32_t>& vertices) {
    const double b = neighbourWeight(before(vertices.front()));
    const double a = neighbourWeight(after(vertices.front()));
    rows_.startBatch({{b / 10, a / 10, (10 - a - b) / 10, 0}, {-1, 1, 0, 0}, {0, 0, -1, 1}});
    for (const std::int32_t v : vertices) {
      rows_.addElement(v, {before(v), after(v), v, level_.dest(level_.nextOutgoing(level_.outgoing(v)))});
    }
  }

  /// Fixed corners, and vertices that the boundary rule leaves behind: they stay, with the normal of the face that the
  /// boundary half-edge leaving them lies in (of the corner alone where that face is too large to walk for each).
  void addLeftBehind(std::int32_t sides, const std::vector<std::int32_t>& vertices) {
    if (sides > kLargestCirculant) {
      rows_.startBatch({{0, 1, 0}, {-1, 1, 0}, {0, -1, 1}});
      for (const std::int32_t v : vertices) {
        const std::int32_t h = level_.outgoing(v);
        rows_.addElement(v, {level_.vert(level_.prev(h)), v, level_.dest(h)});
      }
      return;
    }
    FrameWeights frame = polygonFrame(sides);
    frame.position.assign(at(sides), 0.0);
    frame.position[0] = 1;
    rows_.startBatch(frame);
    for (const std::int32_t v : vertices) {
      std::vector<std::int32_t> loop;
      std::int32_t h = level_.outgoing(v);
      for (std::int32_t i = 0; i < sides; ++i, h = level_.next(h)) loop.push_back(level_.vert(h));
      rows_.addElement(v, loop);
    }
  }

  const Topology& level_;
  const Scheme& scheme_;
  RowsBuilder rows_;
};

LimitRows faceRows(const SourceLevel& level, const Scheme& scheme) {
  RowsBuilder rows(level.pointCount(), level.topology().faceCount());
  for (const FaceRun& run : level.topology().runs()) {
    addFaceRun(rows, level, scheme, run, [](std::int32_t f) { return f; });
  }
  return rows.finish();
}

/// Vertices by the faces they become.
void addChildFaces(RowsBuilder& rows, const SourceLevel& child, const Scheme& scheme) {
  const Topology& topology = child.topology();
  const auto vertexOf = [&topology](std::int32_t f) { return topology.parents()[at(f)]; };
  for (const FaceRun& run : topology.runs()) {
    if (run.parent == FaceParent::vertex) addFaceRun(rows, child, scheme, run, vertexOf);
  }
}

/// Vertices by the patches of their new places, whose faces are the hexagons of their edges; beside a clamped boundary
/// some are sides.
void addPatchCentres(RowsBuilder& rows, const Topology& level, const SplitResult& child) {
  const PatchFrameWeights weights = patchCentreWeights({6, 6, 6});
  rows.startBatch({weights.position, weights.tangent1, weights.tangent2});
  FrameGroups clamped;
  for (std::size_t i = 0; i < child.otherPoints.size(); ++i) {
    const NewPoint& point = child.otherPoints[i];
    const std::int32_t place = child.cornerPoints + static_cast<std::int32_t>(i);
    if (point.kind != PointKind::vertexPoint || child.topology.onBoundary(place)) continue;
    const VertexPatch patch(child.topology, place);
    const std::int32_t v = level.vert(point.halfEdge);
    if (patch.regular()) {
      rows.addElement(v, patch.points());
    } else if (besideClampedBoundary(child.topology, place)) {
      clamped.add(v, clampedPatchCentre(child.topology, place));
    }
  }
  clamped.addTo(rows);
}

LimitRows vertexRows(const Topology& level, const SplitResult& child, const SourceLevel& childLevel,
                     const Scheme& scheme) {
  RowsBuilder rows(childLevel.pointCount(), level.vertexCount());
  if (scheme.vertexLimits == VertexLimits::patchCentre) {
    addPatchCentres(rows, level, child);
  } else {
    addChildFaces(rows, childLevel, scheme);
  }
  return rows.finish();
}

std::vector<std::int32_t> childless(const Topology& level, const LimitRows& withChild) {
  std::vector<std::uint8_t> has(at(level.vertexCount()), 0);
  for (const std::int32_t v : withChild.elements) has[at(v)] = 1;
  std::vector<std::int32_t> without;
  for (std::int32_t v = 0; v < level.vertexCount(); ++v) {
    if (!has[at(v)]) without.push_back(v);
  }
  return without;
}

}  // namespace

LimitRows buildFaceFrames(const SourceLevel& level, std::span<const FaceRun> runs) {
  RowsBuilder rows(level.pointCount(), level.topology().faceCount());
  for (const FaceRun& run : runs) addFaceRun(rows, level, Scheme{}, run, [](std::int32_t f) { return f; });
  return rows.finish();
}

Result<LimitTable> buildLimitTable(const Level& level, const Scheme& lastStep) {
  const Scheme& scheme = lastStep.after ? *lastStep.after : lastStep;
  const SourceLevel here = level.points();
  const Result<SplitResult> child = splitFor(level.topology, scheme).apply(level.topology);
  if (!child) return tl::unexpected(child.error());
  if (child->table) {
    return fail(ErrorCode::unsupported,
                "limits of " + scheme.name + " are not known; end with a level of another scheme, or without limits");
  }
  const SourceLevel there(child->topology, centralPointsOf(scheme));
  LimitTable limits;
  limits.faces = faceRows(here, scheme);
  limits.vertices = vertexRows(level.topology, *child, there, scheme);
  limits.verticesHere = VerticesHere(here, scheme).build(childless(level.topology, limits.vertices));
  limits.child = buildLevelTable(here, *child, scheme);
  return limits;
}

}  // namespace honeycomb::Far
