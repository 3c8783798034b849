#include "far/tables/crease_blend.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "far/base/index.h"
#include "far/tables/face_sums.h"
#include "far/tables/level_rows.h"

namespace honeycomb::Far {

namespace {

/// New points by what they are: corner points by half-edges, points of cuts by label.
class NewPoints {
 public:
  explicit NewPoints(const ShapedStep& step) : parent_(step.parent), cornerPoints_(step.split.cornerPoints) {
    for (std::size_t i = 0; i < step.split.otherPoints.size(); ++i) {
      const NewPoint& point = step.split.otherPoints[i];
      labels_.push_back({point.halfEdge, point.kind, cornerPoints_ + static_cast<std::int32_t>(i)});
    }
    std::sort(labels_.begin(), labels_.end(), [](const Label& a, const Label& b) { return key(a) < key(b); });
  }

  std::int32_t labelled(PointKind kind, std::int32_t h) const {
    const std::tuple wanted(h, kind);
    const auto place = std::lower_bound(labels_.begin(), labels_.end(), wanted,
                                        [](const Label& label, const auto& k) { return key(label) < k; });
    return place == labels_.end() || key(*place) != wanted ? -1 : place->vertex;
  }

  /// The corner point of h. Next to a cut that ends at the middle of an edge it is the point of the cut; a cut itself
  /// has none: -1.
  std::int32_t corner(std::int32_t h) const {
    if (h < cornerPoints_) return h;
    for (const PointKind kind : {PointKind::halfFaceCorner, PointKind::cornerFaceCorner}) {
      if (const std::int32_t v = labelled(kind, h); v >= 0) return v;
    }
    const std::int32_t next = parent_.next(h);
    if (parent_.vertexTag(parent_.vert(next)) == VertexTag::mid) {
      if (const std::int32_t v = labelled(PointKind::cutStart, next); v >= 0) return v;
    }
    if (parent_.vertexTag(parent_.vert(h)) == VertexTag::mid) return labelled(PointKind::cutEnd, parent_.prev(h));
    return -1;
  }

 private:
  struct Label {
    std::int32_t halfEdge;
    PointKind kind;
    std::int32_t vertex;
  };
  static std::tuple<std::int32_t, PointKind> key(const Label& label) { return {label.halfEdge, label.kind}; }

  const Topology& parent_;
  std::int32_t cornerPoints_;
  std::vector<Label> labels_;
};

/// The central control vertices of the faces that the parent's faces and vertices become.
class NewCentrals {
 public:
  explicit NewCentrals(const ShapedStep& step)
      : ofFace_(at(step.parent.faceCount()), -1), ofVertex_(at(step.parent.vertexCount()), -1) {
    const Topology& child = step.split.topology;
    for (const FaceRun& run : child.runs()) {
      for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
        auto& of = run.parent == FaceParent::face ? ofFace_ : ofVertex_;
        of[at(child.parents()[at(f)])] = child.vertexCount() + f;
      }
    }
  }
  std::int32_t ofFace(std::int32_t f) const { return ofFace_[at(f)]; }
  std::int32_t ofVertex(std::int32_t v) const { return ofVertex_[at(v)]; }

 private:
  std::vector<std::int32_t> ofFace_, ofVertex_;
};

class Blend {
 public:
  Blend(const Reshaped& closed, const ShapedStep& smooth, const ShapedStep& sharp)
      : closed_(closed),
        smooth_(smooth),
        sharp_(sharp),
        smoothRows_(smooth.table),
        sharpRows_(sharp.table),
        sums_(smooth.table, [&closed](std::int32_t point) {
          return at(point) < closed.united.size() ? closed.united[at(point)] : point;
        }) {}

  void addPoints() {
    const NewPoints smooth(smooth_);
    const NewPoints sharp(sharp_);
    for (const ClosedCrease& face : closed_.faces) {
      const auto offsets = smooth_.parent.faceOffsets();
      for (std::int32_t h = offsets[at(face.element)]; h < offsets[at(face.element) + 1]; ++h) {
        const std::int32_t first = closed_.firstOf[at(h)];
        const std::int32_t last = closed_.lastOf[at(h)];
        add(smooth.corner(h), sharp.corner(first), face.sharpness);
        add(smooth.labelled(PointKind::cutStart, h), sharp.labelled(PointKind::cutStart, first), face.sharpness);
        add(smooth.labelled(PointKind::cutEnd, h), sharp.labelled(PointKind::cutEnd, last), face.sharpness);
      }
    }
  }

  void addCentrals() {
    const NewCentrals smooth(smooth_);
    const NewCentrals sharp(sharp_);
    for (const ClosedCrease& face : closed_.faces) {
      add(smooth.ofFace(face.element), sharp.ofFace(closed_.faceOf[at(face.element)]), face.sharpness);
    }
    for (const ClosedCrease& vertex : affectedVertices()) {
      add(smooth.ofVertex(vertex.element), sharp.ofVertex(closed_.vertexOf[at(vertex.element)]), vertex.sharpness);
    }
  }

  /// One row an output, ascending.
  RowChanges finish() && {
    std::stable_sort(rows_.begin(), rows_.end(),
                     [](const ReplacedRow& a, const ReplacedRow& b) { return a.output < b.output; });
    const auto same = [](const ReplacedRow& a, const ReplacedRow& b) { return a.output == b.output; };
    rows_.erase(std::unique(rows_.begin(), rows_.end(), same), rows_.end());
    return {std::move(rows_), std::move(sums_).added()};
  }

 private:
  /// Those on the creases that are closed, and those of faces that change, whose neighbours may lie on the cut.
  std::vector<ClosedCrease> affectedVertices() const {
    std::vector<ClosedCrease> vertices = closed_.vertices;
    const auto offsets = smooth_.parent.faceOffsets();
    for (const ClosedCrease& face : closed_.faces) {
      for (std::int32_t h = offsets[at(face.element)]; h < offsets[at(face.element) + 1]; ++h) {
        vertices.push_back({smooth_.parent.vert(h), face.sharpness});
      }
    }
    return sharpestEach(std::move(vertices));
  }

  /// Copies of a vertex that are united count as the first.
  Row rowOf(const LevelRows& rows, std::int32_t output) {
    Row row;
    sums_.append(rows, output, 1, row);
    return row;
  }

  /// Equal rows are left as they are: rounding would part the two sides of a crease of which only one changes.
  void add(std::int32_t smooth, std::int32_t sharp, double sharpness) {
    if (smooth < 0 || sharp < 0) return;
    ReplacedRow blended{smooth, rowOf(smoothRows_, smooth)};
    Row sharpRow = rowOf(sharpRows_, sharp);
    if (blended.row == sharpRow) return;
    if (sharpness == 1) {
      blended.row = std::move(sharpRow);
    } else {
      for (Weight& entry : blended.row) entry.weight *= 1 - sharpness;
      for (const Weight& entry : sharpRow) blended.row.push_back({entry.point, sharpness * entry.weight});
      mergeEntries(blended.row);
    }
    rows_.push_back(std::move(blended));
  }

  const Reshaped& closed_;
  const ShapedStep& smooth_;
  const ShapedStep& sharp_;
  LevelRows smoothRows_;
  LevelRows sharpRows_;
  FaceSums sums_;
  std::vector<ReplacedRow> rows_;
};

}  // namespace

RowChanges blendCreases(const Reshaped& closed, const ShapedStep& smooth, const ShapedStep& sharp, bool centralPoints) {
  Blend blend(closed, smooth, sharp);
  blend.addPoints();
  if (centralPoints) blend.addCentrals();
  return std::move(blend).finish();
}

}  // namespace honeycomb::Far
