#include "far/tables/level_table_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/circulant_form.h"
#include "far/tables/mirrored_polygon.h"
#include "far/tables/row_writer.h"
#include "far/tables/summed_row_writer.h"

namespace honeycomb::Far {

namespace {

/// Weights on the corners of an N-gon that give its sum and its cosine and sine projections.
struct Projections {
  std::vector<double> sum, cosine, sine;
  explicit Projections(std::int32_t sides) : sum(at(sides), 1.0), cosine(at(sides)), sine(at(sides)) {
    for (std::int32_t j = 0; j < sides; ++j) {
      const double angle = 2 * std::numbers::pi * j / sides;
      cosine[at(j)] = std::cos(angle);
      sine[at(j)] = std::sin(angle);
    }
  }
};

class Builder {
 public:
  Builder(const SourceLevel& source, const SplitResult& split, const Scheme& scheme)
      : source_(source),
        parent_(source.topology()),
        split_(split),
        scheme_(scheme),
        rows_(table_),
        summedRows_(table_) {
    table_.sourceCount = source.pointCount();
    table_.targetCount = split.topology.vertexCount() + (scheme.centralPoints ? split.topology.faceCount() : 0);
  }

  LevelTable build() {
    if (readsAllCorners()) {
      table_.indices = SharedArray<std::int32_t>(parent_.sharedVert());
    } else {
      table_.indices.edit().reserve(at(scheme_.entriesPerVertex) * at(split_.topology.vertexCount()));
    }
    for (const FaceRun& run : split_.topology.runs()) {
      // The corner points are the first half-edges of the level: those of its whole face-faces.
      if (run.firstHalfEdge < split_.cornerPoints) addFaces(run);
    }
    if (scheme_.faceSums) addOwnSums();
    addOtherPoints();
    if (scheme_.centralPoints) addCentralPoints();
    if (scheme_.centralPoints || table_.summed.rowCount() > 0) summedRows_.finish();
    rows_.finish();
    table_.weightsSingle.assign(table_.weights.begin(), table_.weights.end());
    return std::move(table_);
  }

 private:
  std::int32_t indexCount() const { return static_cast<std::int32_t>(table_.indices.size()); }
  std::int32_t weightCount() const { return static_cast<std::int32_t>(table_.weights.size()); }
  std::int32_t addWeights(const std::vector<double>& weights) {
    const std::int32_t first = weightCount();
    table_.weights.append(weights.begin(), weights.end());
    return first;
  }

  /// A run of whole face-faces: their outputs are the run's half-edges.
  void addFaces(const FaceRun& run) {
    CirculantRule rule = scheme_.faceRule(run.sides);
    if (rule.central != 0 && source_.hasCentral()) {
      if (run.sides > kLargestCirculant) addSums(run);
      return addCentralRun(run, rule);
    }
    rule.mean += rule.central / run.sides;  // without a point of its own, the central control vertex is the barycentre
    const std::int32_t firstIndex = addCorners(run);
    if (run.sides <= kLargestCirculant) {
      const std::vector<double> row = firstRow(rule, run.sides);
      const std::int32_t firstWeight = addWeights(row);
      const CirculantForm form = circulantForm(row);
      const std::int32_t firstForm = form == CirculantForm::direct ? firstWeight : addWeights(formWeights(form, row));
      table_.circulants.push_back(
          {run.sides, run.faceCount, firstIndex, run.firstHalfEdge, firstWeight, firstForm, form});
    } else {
      addProjectedRun(run, firstIndex, rule);
    }
  }

  /// Is every point a corner point of a whole face? The faces are in the parent's order then, so that what they read is
  /// the parent's vert() as it stands.
  bool readsAllCorners() const {
    return split_.cornerPoints == parent_.halfEdgeCount() && split_.otherPoints.empty() && !scheme_.centralPoints &&
           !source_.hasCentral();
  }

  /// The source points of the corners of a run's faces; returns where they begin.
  std::int32_t addCorners(const FaceRun& run) {
    if (readsAllCorners()) return run.firstHalfEdge;
    const std::int32_t firstIndex = indexCount();
    Array<std::int32_t>& indices = table_.indices.edit();
    indices.resize(at(firstIndex) + at(run.faceCount) * at(run.sides));
    Parallel::forRange(0, run.faceCount, 1024, [&](std::int64_t begin, std::int64_t end) {
      auto index = indices.begin() + firstIndex + begin * run.sides;
      for (std::int64_t g = begin; g < end; ++g) {
        const std::int32_t face = split_.topology.parents()[at(run.firstFace + g)];
        index = std::copy_n(parent_.vert().begin() + parent_.faceOffsets()[at(face)], run.sides, index);
      }
    });
    return firstIndex;
  }

  /// Corner points by rows: with a central control vertex the stencil has but a few entries that are not zero.
  void addCentralRun(const FaceRun& run, const CirculantRule& rule) {
    std::vector<Weight> entries;  // by place in the loop
    const std::vector<double> weights = firstRow(rule, run.sides);
    for (std::int32_t k = 0; k < run.sides; ++k) {
      if (weights[at(k)] != 0) entries.push_back({k, weights[at(k)]});
    }
    rows_.add(run.firstHalfEdge, std::int64_t{run.faceCount} * run.sides, [&](std::int64_t i, Row& row) {
      const std::int32_t face = split_.topology.parents()[at(run.firstFace + i / run.sides)];
      const std::int32_t from = parent_.faceOffsets()[at(face)];
      const auto corner = static_cast<std::int32_t>(i % run.sides);
      for (const Weight& entry : entries) {
        row.push_back({parent_.vert(from + (corner + entry.point) % run.sides), entry.weight});
      }
      source_.addCentral(face, rule.central, row);
    });
  }

  void addCentralPoints() {
    source_.nameSums(largeFaces());
    const std::vector<Segment> segments = centralSegments();
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const std::int32_t first = segments[i].firstFace;
      const std::int32_t end = i + 1 < segments.size() ? segments[i + 1].firstFace : split_.topology.faceCount();
      const std::int32_t output = split_.topology.vertexCount() + first;
      const auto makeRow = [&](std::int64_t k, Row& row) {
        scheme_.centralRow(source_, split_, first + static_cast<std::int32_t>(k), row);
      };
      segments[i].summed ? summedRows_.add(output, end - first, makeRow) : rows_.add(output, end - first, makeRow);
    }
  }

  /// Per face of the parent its number among the table's projected faces, -1 for others; empty if there are none. Those
  /// of schemes with central control vertices are whole faces.
  std::vector<std::int32_t> largeFaces() const {
    if (table_.projected.empty()) return {};
    std::vector<std::int32_t> numbers(at(parent_.faceCount()), -1);
    for (std::size_t i = 0; i < table_.projected.size(); ++i) {
      const std::int32_t face = split_.topology.face(table_.projected[i].firstOutput);
      numbers[at(split_.topology.parents()[at(face)])] = static_cast<std::int32_t>(i);
    }
    return numbers;
  }

  /// Faces of the child from one on, up to the next segment's, whose central control vertices have summed rows or not.
  struct Segment {
    std::int32_t firstFace;
    bool summed;
  };

  /// Summed are the rows of large faces, and where no central control vertices are given those of the faces that the
  /// vertices of large faces become, in pieces of the faces of a run.
  std::vector<Segment> centralSegments() const {
    constexpr std::int32_t kPiece = 1024;
    std::vector<Segment> segments;
    const std::vector<std::uint8_t> beside = besideLargeFaces();
    for (const FaceRun& run : split_.topology.runs()) {
      const std::int32_t end = run.firstFace + run.faceCount;
      for (std::int32_t first = run.firstFace; first < end; first += kPiece) {
        const auto parents = split_.topology.parents().subspan(at(first), at(std::min(kPiece, end - first)));
        const bool summed = source_.hasSums() && std::ranges::any_of(parents, [&](std::int32_t parent) {
                              if (run.parent == FaceParent::face) return source_.sumPoint(parent) >= 0;
                              return run.parent == FaceParent::vertex && !beside.empty() && beside[at(parent)] != 0;
                            });
        if (segments.empty() || segments.back().summed != summed) segments.push_back({first, summed});
      }
    }
    return segments;
  }

  /// Per vertex of the parent: is it one of a large face, whose central control vertex is made up from its corners?
  /// Empty where there are none such.
  std::vector<std::uint8_t> besideLargeFaces() const {
    if (source_.hasCentral() || !source_.hasSums()) return {};
    std::vector<std::uint8_t> beside(at(parent_.vertexCount()), 0);
    for (const ProjectedFace& face : table_.projected) {
      for (std::int32_t j = 0; j < face.corners; ++j) beside[at(table_.indices[at(face.firstIndex + j)])] = 1;
    }
    return beside;
  }

  /// The sums of a run of large faces, for their central control vertices.
  void addSums(const FaceRun& run) {
    const std::int32_t firstIndex = addCorners(run);
    std::vector<double> weights(at(run.sides) + 2, 1.0);
    weights[0] = weights[1] = 0;
    const std::int32_t firstWeight = addWeights(weights);
    for (std::int32_t g = 0; g < run.faceCount; ++g) {
      table_.projected.push_back(
          {run.sides, 0, 0, firstIndex + g * run.sides, run.firstHalfEdge + g * run.sides, firstWeight});
    }
  }

  void addProjectedRun(const FaceRun& run, std::int32_t firstIndex, const CirculantRule& rule) {
    const Projections p(run.sides);
    const std::int32_t firstWeight = addProjectionWeights(rule, p.sum, p.cosine, p.sine, 0, run.sides, run.sides);
    for (std::int32_t g = 0; g < run.faceCount; ++g) {
      table_.projected.push_back(
          {run.sides, run.sides, 0, firstIndex + g * run.sides, run.firstHalfEdge + g * run.sides, firstWeight});
    }
  }

  /// out_i for polygon corners first .. first+outputs-1 of an N-gon:
  ///     sum_j (mean + cosine cos(theta (j-i)) + sine sin(theta (j-i))) P_j + here P_i + next P_{i+1}
  /// with the sums split by the addition theorems.
  std::int32_t addProjectionWeights(const CirculantRule& rule, const std::vector<double>& sum,
                                    const std::vector<double>& cosine, const std::vector<double>& sine,
                                    std::int32_t first, std::int32_t outputs, std::int32_t sides) {
    const std::int32_t firstWeight = addWeights({rule.here, rule.next});
    addWeights(sum);
    addWeights(cosine);
    addWeights(sine);
    std::vector<double> y(at(outputs));
    std::vector<double> z(at(outputs));
    for (std::int32_t i = 0; i < outputs; ++i) {
      const double angle = 2 * std::numbers::pi * (first + i) / sides;
      y[at(i)] = rule.cosine * std::cos(angle) - rule.sine * std::sin(angle);
      z[at(i)] = rule.cosine * std::sin(angle) + rule.sine * std::cos(angle);
    }
    addWeights(std::vector<double>(at(outputs), rule.mean));
    addWeights(y);
    addWeights(z);
    return firstWeight;
  }

  /// The sums that the scheme's own rows read of large faces of the parent.
  void addOwnSums() {
    std::vector<std::int32_t> numbers;
    for (const FaceRun& run : parent_.runs()) {
      if (run.sides <= kLargestCirculant) continue;
      for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
        const std::vector<Row> sums = scheme_.faceSums(parent_, f);
        if (sums.empty()) continue;
        numbers.resize(at(parent_.faceCount()), -1);
        numbers[at(f)] = static_cast<std::int32_t>(table_.projected.size());
        for (const Row& sum : sums) addSum(sum);
      }
    }
    source_.nameSums(std::move(numbers));
  }

  void addSum(const Row& sum) {
    table_.projected.push_back({static_cast<std::int32_t>(sum.size()), 0, 0, indexCount(), 0, addWeights({0, 0})});
    for (const Weight& entry : sum) {
      table_.indices.edit().push_back(entry.point);
      table_.weights.push_back(entry.weight);
    }
  }

  /// Does the scheme's own row of a point read sums?
  bool readsOwnSums(const NewPoint& point) const {
    const bool ofFace = point.kind == PointKind::halfFaceCorner || point.kind == PointKind::cornerFaceCorner;
    return ofFace && scheme_.faceSums && source_.sumPoint(parent_.face(point.halfEdge)) >= 0;
  }

  /// Points that are not corner points of whole faces: mirrored half faces one by one, the rest row by row.
  void addOtherPoints() {
    const Array<NewPoint>& points = split_.otherPoints;
    const auto mirrored = [&](std::size_t i) {
      return points[i].kind == PointKind::halfFaceCorner && scheme_.halfFaces == HalfFaces::mirrored;
    };
    for (std::size_t i = 0; i < points.size();) {
      const std::int32_t output = split_.cornerPoints + static_cast<std::int32_t>(i);
      if (mirrored(i)) {
        i += at(addHalfFace(parent_.face(points[i].halfEdge), output));
        continue;
      }
      const bool summed = readsOwnSums(points[i]);
      std::size_t end = i + 1;
      while (end < points.size() && !mirrored(end) && readsOwnSums(points[end]) == summed) ++end;
      const auto makeRow = [&](std::int64_t k, Row& row) { scheme_.pointRow(source_, points[i + at(k)], row); };
      const auto count = static_cast<std::int64_t>(end - i);
      summed ? summedRows_.add(output, count, makeRow) : rows_.add(output, count, makeRow);
      i = end;
    }
  }

  /// Returns how many points the half face has.
  std::int32_t addHalfFace(std::int32_t face, std::int32_t output) {
    const MirroredPolygon polygon(parent_, face);
    const CirculantRule rule = scheme_.faceRule(polygon.sides());
    if (polygon.sides() > kLargestCirculant) {
      addProjectedHalfFace(polygon, rule, output);
    } else {
      const std::vector<double> weights = firstRow(rule, polygon.sides());
      rows_.add(output, polygon.edgeCount(), [&](std::int64_t e, Row& row) {
        row = halfFaceRow(polygon, weights, polygon.cornerAt(polygon.firstEdge() + static_cast<std::int32_t>(e)));
      });
    }
    return polygon.edgeCount();
  }

  void addProjectedHalfFace(const MirroredPolygon& polygon, const CirculantRule& rule, std::int32_t output) {
    const Projections p(polygon.sides());
    const std::int32_t firstIndex = indexCount();
    for (std::int32_t q = 0; q < polygon.count(); ++q) table_.indices.edit().push_back(polygon.vertex(q));
    const std::int32_t firstWeight =
        addProjectionWeights(rule, polygon.fold(p.sum), polygon.fold(p.cosine), polygon.fold(p.sine),
                             polygon.cornerAt(polygon.firstEdge()), polygon.edgeCount(), polygon.sides());
    table_.projected.push_back(
        {polygon.count(), polygon.edgeCount(), polygon.firstEdge(), firstIndex, output, firstWeight});
  }

  static Row halfFaceRow(const MirroredPolygon& polygon, const std::vector<double>& firstRow, std::int32_t corner) {
    std::vector<double> weights(firstRow.size());
    for (std::size_t k = 0; k < weights.size(); ++k) weights[(at(corner) + k) % weights.size()] = firstRow[k];
    const std::vector<double> folded = polygon.fold(weights);
    Row row;
    for (std::int32_t q = 0; q < polygon.count(); ++q) row.push_back({polygon.vertex(q), folded[at(q)]});
    return row;
  }

  SourceLevel source_;
  const Topology& parent_;
  const SplitResult& split_;
  const Scheme& scheme_;
  LevelTable table_;
  RowWriter rows_;
  SummedRowWriter summedRows_;
};

}  // namespace

LevelTable buildLevelTable(const SourceLevel& source, const SplitResult& split, const Scheme& scheme) {
  if (split.table) {
    LevelTable table = *split.table;
    table.sourceCount = source.pointCount();
    return table;
  }
  return Builder(source, split, scheme).build();
}

}  // namespace honeycomb::Far
