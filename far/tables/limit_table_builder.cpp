#include "far/tables/limit_table_builder.h"

#include <cmath>
#include <map>
#include <numbers>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/mirrored_polygon.h"

namespace honeycomb::Far {

namespace {

/// Three weight rows over the points of an element: limit position and two tangents.
struct FrameWeights {
  std::vector<double> position, tangent1, tangent2;
};

FrameWeights polygonFrame(std::int32_t sides) {
  FrameWeights frame{std::vector<double>(at(sides), 1.0 / sides), std::vector<double>(at(sides)),
                     std::vector<double>(at(sides))};
  for (std::int32_t j = 0; j < sides; ++j) {
    const double angle = 2 * std::numbers::pi * j / sides;
    frame.tangent1[at(j)] = std::cos(angle);
    frame.tangent2[at(j)] = std::sin(angle);
  }
  return frame;
}

/// The frame of a half face: of the whole polygon, folded onto the path. A triangle's cut leaves no polygon to mirror.
FrameWeights halfFrame(const MirroredPolygon& polygon) {
  if (polygon.sides() == 2) {
    FrameWeights frame = polygonFrame(3);
    frame.position = {0.5, 0, 0.5};
    return frame;
  }
  const FrameWeights whole = polygonFrame(polygon.sides());
  return {polygon.fold(whole.position), polygon.fold(whole.tangent1), polygon.fold(whole.tangent2)};
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
    for (const auto* row : {&frame.position, &frame.tangent1, &frame.tangent2}) {
      rows_.weights.insert(rows_.weights.end(), row->begin(), row->end());
    }
  }

  void addElement(std::int32_t element, const std::vector<std::int32_t>& points) {
    ++rows_.batches.back().count;
    rows_.elements.push_back(element);
    rows_.indices.insert(rows_.indices.end(), points.begin(), points.end());
  }

  /// All faces of a run, element e(f) for face f, points in loop order.
  template <class ElementOf>
  void addRun(const Topology& topology, const FaceRun& run, const ElementOf& elementOf) {
    FrameBatch& batch = rows_.batches.back();
    batch.count += run.faceCount;
    const std::size_t firstElement = rows_.elements.size();
    const std::size_t firstIndex = rows_.indices.size();
    rows_.elements.resize(firstElement + at(run.faceCount));
    const auto loops = topology.vert().subspan(at(run.firstHalfEdge), at(run.faceCount) * at(run.sides));
    rows_.indices.resize(firstIndex + loops.size());
    Parallel::forEach(0, static_cast<std::int64_t>(loops.size()),
                      [&](std::int64_t i) { rows_.indices[firstIndex + at(i)] = loops[at(i)]; });
    Parallel::forEach(0, run.faceCount, [&](std::int64_t g) {
      rows_.elements[firstElement + at(g)] = elementOf(run.firstFace + static_cast<std::int32_t>(g));
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

/// The faces of one run of a topology, whatever their kind. Corner faces have their limit at the corner, the second
/// vertex of their loop.
template <class ElementOf>
void addFaceRun(RowsBuilder& rows, const Topology& topology, const FaceRun& run, const ElementOf& elementOf) {
  if (run.kind == FaceKind::half) {
    rows.startBatch(halfFrame(MirroredPolygon(topology, run.firstFace)));
    for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
      rows.addElement(elementOf(f), pathVertices(MirroredPolygon(topology, f)));
    }
    return;
  }
  FrameWeights frame = polygonFrame(run.sides);
  if (run.kind == FaceKind::corner) {
    frame.position.assign(at(run.sides), 0.0);
    frame.position[1] = 1;
  }
  rows.startBatch(frame);
  rows.addRun(topology, run, elementOf);
}

/// Vertices without a child face, from the points of their own level.
class VerticesHere {
 public:
  explicit VerticesHere(const Topology& level) : level_(level), rows_(level.vertexCount(), level.vertexCount()) {}

  LimitRows build(const std::vector<std::int32_t>& vertices) {
    // Grouped by shape, so that each shape's weights stand once: mid-points by the weights of their two neighbours.
    std::map<std::int32_t, std::vector<std::int32_t>> mids;
    std::map<std::int32_t, std::vector<std::int32_t>> others;
    for (const std::int32_t v : vertices) {
      if (level_.vertexTag(v) == VertexTag::mid) {
        mids[10 * neighbourWeight(before(v)) + neighbourWeight(after(v))].push_back(v);
      } else {
        others[level_.sides(level_.face(level_.outgoing(v)))].push_back(v);
      }
    }
    for (const auto& group : mids) addMids(group.second);
    for (const auto& group : others) addLeftBehind(group.first, group.second);
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
  RowsBuilder rows_;
};

LimitRows faceRows(const Topology& level) {
  RowsBuilder rows(level.vertexCount(), level.faceCount());
  for (const FaceRun& run : level.runs()) addFaceRun(rows, level, run, [](std::int32_t f) { return f; });
  return rows.finish();
}

LimitRows vertexRows(const Topology& level, const Topology& child) {
  RowsBuilder rows(child.vertexCount(), level.vertexCount());
  const auto vertexOf = [&child](std::int32_t f) { return child.parents()[at(f)]; };
  for (const FaceRun& run : child.runs()) {
    if (run.parent == FaceParent::vertex) addFaceRun(rows, child, run, vertexOf);
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

LimitTable buildLimitTable(const Topology& level, const SplitResult& child, LevelTable childTable) {
  LimitTable limits;
  limits.faces = faceRows(level);
  limits.vertices = vertexRows(level, child.topology);
  limits.verticesHere = VerticesHere(level).build(childless(level, limits.vertices));
  limits.child = std::move(childTable);
  return limits;
}

}  // namespace honeycomb::Far
