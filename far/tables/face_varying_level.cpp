#include "far/tables/face_varying_level.h"

#include <algorithm>
#include <optional>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/level_rows.h"
#include "far/tables/level_values.h"
#include "far/tables/row_writer.h"

namespace honeycomb::Far {

namespace {

bool sameRow(const Row& a, const Row& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Weight& x, const Weight& y) { return x.point == y.point && x.weight == y.weight; });
}

/// A face of the child: the parent face in whose chart its corners are, and the parent's vertices round which other
/// faces are looked for, by the half-edges that leave them in that face.
struct Cell {
  std::int32_t chart = 0;
  FaceParent made = FaceParent::face;
  std::array<std::int32_t, 2> pivots{-1, -1};
  std::size_t pivotCount = 0;
  std::span<const std::int32_t> known() const { return std::span(pivots).first(pivotCount); }
};

class LevelBuilder {
 public:
  LevelBuilder(const Level& parent, const Level& child, const Charts& charts, std::int32_t sourceCount)
      : child_(child),
        old_(parent.topology),
        new_(child.topology),
        charts_(charts),
        rows_(child.table),
        faceOfInput_(inputFaces(parent)) {
    findPrimaries();
    level_.table.sourceCount = sourceCount;
  }

  FaceVaryingLevel build(std::int32_t length, std::vector<double>& values) {
    addPrimaries();
    level_.valueCount = child_.pointCount();
    level_.corners.assign(new_.vert().begin(), new_.vert().end());
    if (charts_.hasSeams()) {
      if (charts_.planar()) values_ = applyTable(level_.table, values, 2);
      addExtras();
    }
    level_.table.targetCount = level_.valueCount;
    level_.table.weightsSingle.assign(level_.table.weights.begin(), level_.table.weights.end());
    if (charts_.hasSeams()) values = applyTable(level_.table, values, length);
    return std::move(level_);
  }

 private:
  static std::vector<std::int32_t> inputFaces(const Level& parent) {
    std::vector<std::int32_t> faces;
    if (parent.central != CentralPoints::byInputFace) return faces;
    faces.resize(at(parent.topology.faceCount()));
    for (std::int32_t f = 0; f < parent.topology.faceCount(); ++f) faces[at(parent.topology.inputFace(f))] = f;
    return faces;
  }

  Cell cellOf(std::int32_t f) const {
    Cell cell;
    const std::int32_t element = new_.parents()[at(f)];
    cell.made = new_.parentKind(f);
    cell.chart = element;
    if (cell.made == FaceParent::face) return cell;
    const std::int32_t h = cell.made == FaceParent::vertex ? old_.outgoing(element) : element;
    cell.chart = old_.face(h);
    cell.pivots = {h, old_.next(h)};
    cell.pivotCount = cell.made == FaceParent::vertex ? 1 : 2;
    return cell;
  }

  /// The corner whose chart a vertex's own value is in: the lowest in a face made from a face, else the lowest. For a
  /// corner point that is the half-edge with its number.
  void findPrimaries() {
    primary_.resize(at(new_.vertexCount()));
    Parallel::forEach(0, new_.vertexCount(), [&](std::int64_t v) {
      const std::int32_t first = new_.outgoing(static_cast<std::int32_t>(v));
      std::int32_t best = first;
      bool bestMade = new_.parentKind(new_.face(first)) == FaceParent::face;
      for (std::int32_t h = new_.nextOutgoing(first); h >= 0 && h != first; h = new_.nextOutgoing(h)) {
        const bool made = new_.parentKind(new_.face(h)) == FaceParent::face;
        if ((made && !bestMade) || (made == bestMade && h < best)) {
          best = h;
          bestMade = made;
        }
      }
      primary_[at(v)] = best;
    });
  }

  bool hasFaceRow(std::int32_t point) const {
    const LevelRows::Kind kind = rows_.place(point).kind;
    return kind == LevelRows::Kind::circulant || kind == LevelRows::Kind::projected;
  }

  /// The parent's face that vertex v lies in and in whose chart its own value is; -1 if it lies in none.
  std::int32_t home(std::int32_t v) const {
    const std::int32_t f = new_.face(primary_[at(v)]);
    return new_.parentKind(f) == FaceParent::face ? new_.parents()[at(f)] : -1;
  }

  /// Is point `point` of the child made of corners of a face of the parent, and its central control vertex, alone?
  bool liesIn(std::int32_t point, std::int32_t face) const {
    bool inside = true;
    rows_.visit(point, [&](std::int32_t p, double) {
      inside = inside && (p < old_.vertexCount() ? charts_.cornerOf(p, face) >= 0 : centralFace(p) == face);
    });
    return inside;
  }

  std::int32_t centralFace(std::int32_t point) const {
    const std::int32_t f = point - old_.vertexCount();
    return faceOfInput_.empty() ? f : faceOfInput_[at(f)];
  }

  // Rows
  // ---------------------------------------------------------------------------------------------------------------

  /// Batches of whole faces keep their weights and read the corners of their face; all other points have rows.
  void addPrimaries() {
    const LevelTable& old = child_.table;
    LevelTable& table = level_.table;
    table.weights.assign(old.weights.begin(), old.weights.begin() + batchWeights(old));
    std::vector<std::int32_t> covered;  // first and end of each range of outputs that a batch of faces has
    for (CirculantBatch batch : old.circulants) {
      batch.firstIndex = addCorners(batch.firstIndex, batch.firstOutput, batch.faceCount, batch.sides, batch.sides);
      if (batch.firstIndex < 0) continue;
      table.circulants.push_back(batch);
      covered.insert(covered.end(), {batch.firstOutput, batch.firstOutput + batch.faceCount * batch.sides});
    }
    for (ProjectedFace face : old.projected) {
      if (face.outputs == 0) continue;
      face.firstIndex = addCorners(face.firstIndex, face.firstOutput, 1, face.corners, face.outputs);
      if (face.firstIndex < 0) continue;
      table.projected.push_back(face);
      covered.insert(covered.end(), {face.firstOutput, face.firstOutput + face.outputs});
    }
    table.targetCount = child_.pointCount();
    covered.insert(covered.end(), {0, child_.pointCount()});
    std::sort(covered.begin(), covered.end());  // ranges don't overlap: now the gaps between them, in pairs
    RowWriter writer(table);
    for (std::size_t i = 0; i < covered.size(); i += 2) {
      writer.add(covered[i], covered[i + 1] - covered[i],
                 [&](std::int64_t j, Row& row) { row = primaryRow(covered[i] + static_cast<std::int32_t>(j)); });
    }
    writer.finish();
  }

  /// Where the weights of the batches of faces end.
  static std::int32_t batchWeights(const LevelTable& table) {
    std::int32_t end = 0;
    for (const CirculantBatch& b : table.circulants) {
      end = std::max({end, b.firstRow + b.sides, b.firstForm + b.formWeights()});
    }
    for (const ProjectedFace& f : table.projected) {
      if (f.outputs > 0) end = std::max(end, f.firstWeight + 2 + 3 * f.corners + 3 * f.outputs);
    }
    return end;
  }

  /// The values that faces of a batch read. Returns where they begin; -1 where seams are about and a face reads beyond
  /// its own corners (two halves of a face that grew together), so that its points need rows.
  std::int32_t addCorners(std::int32_t oldIndex, std::int32_t firstOutput, std::int32_t faces, std::int32_t corners,
                          std::int32_t outputs) {
    Array<std::int32_t>& indices = level_.table.indices.edit();
    const std::size_t firstIndex = indices.size();
    indices.resize(firstIndex + at(faces) * at(corners));
    Parallel::forEach(
        0, faces,
        [&](std::int64_t g) {
          const auto i = static_cast<std::int32_t>(g);
          const std::int32_t face = cellOf(new_.face(primary_[at(firstOutput + i * outputs)])).chart;
          for (std::int32_t j = i * corners; j < (i + 1) * corners; ++j) {
            const std::int32_t c = cornerIn(child_.table.indices[at(oldIndex + j)], face, j % corners);
            indices[firstIndex + at(j)] = c < 0 ? -1 : charts_.corner(c);
          }
        },
        64);
    const bool whole =
        std::find(indices.begin() + static_cast<std::ptrdiff_t>(firstIndex), indices.end(), -1) == indices.end();
    if (!whole) indices.resize(firstIndex);
    return whole ? static_cast<std::int32_t>(firstIndex) : -1;
  }

  /// The half-edge at which v is a corner of a face, perhaps that in place `guess`.
  std::int32_t cornerIn(std::int32_t v, std::int32_t face, std::int32_t guess) const {
    if (!charts_.hasSeams()) return old_.outgoing(v);
    const std::int32_t h = old_.faceOffsets()[at(face)] + guess;
    return guess < old_.sides(face) && old_.vert(h) == v ? h : charts_.cornerOf(v, face);
  }

  Row primaryRow(std::int32_t point) const {
    const bool vertex = point < new_.vertexCount();
    return rowIn(point, cellOf(vertex ? new_.face(primary_[at(point)]) : point - new_.vertexCount()));
  }

  /// Point `point` in the chart of a cell, point by point of its stencil.
  Row rowIn(std::int32_t point, const Cell& cell) const {
    const std::vector<std::int32_t> pivots = charts_.hasSeams() ? pivotsOf(point, cell) : std::vector<std::int32_t>();
    Charts::ChartRow row;
    bool whole = true;
    rows_.visit(point, [&](std::int32_t p, double w) { whole = addSource(p, w, cell.chart, pivots, row) && whole; });
    if (whole && charts_.close(cell.chart, row)) return std::move(row.row);
    return clampedRow(point, cell.chart, pivots);
  }

  /// The half-edges in the cell's chart round whose vertices its stencil may reach into other faces.
  std::vector<std::int32_t> pivotsOf(std::int32_t point, const Cell& cell) const {
    if (cell.pivotCount > 0) return {cell.known().begin(), cell.known().end()};
    std::vector<std::int32_t> pivots;
    bool outside = false;
    rows_.visit(point, [&](std::int32_t p, double) {
      const std::int32_t c = p < old_.vertexCount() ? charts_.cornerOf(p, cell.chart) : -1;
      if (c >= 0) {
        pivots.push_back(c);
      } else {
        outside = true;
      }
    });
    if (!outside) return {};
    // Where two halves of a face grow together, the other is seen over the cut.
    const std::int32_t first = old_.faceOffsets()[at(cell.chart)];
    for (std::int32_t h = first; h < first + old_.sides(cell.chart); ++h) {
      if (old_.onBoundary(old_.vert(h))) pivots.push_back(h);
    }
    if (pivots.empty()) pivots.push_back(first);
    return pivots;
  }

  /// Adds weight times a source point; false when it can't be seen from the chart.
  bool addSource(std::int32_t p, double weight, std::int32_t chart, std::span<const std::int32_t> pivots,
                 Charts::ChartRow& row) const {
    if (p >= old_.vertexCount()) return addCentral(centralFace(p), weight, chart, pivots, row);
    Charts::Place place;
    place.corner = charts_.hasSeams() ? charts_.cornerOf(p, chart) : old_.outgoing(p);
    if (place.corner >= 0) {
      place.face = chart;
    } else {
      place = charts_.findVertex(p, pivots);
    }
    return charts_.add(place, weight, row);
  }

  bool addCentral(std::int32_t f, double weight, std::int32_t chart, std::span<const std::int32_t> pivots,
                  Charts::ChartRow& row) const {
    Charts::Place place;
    place.face = f;
    if (f != chart && charts_.hasSeams()) place = charts_.findFace(f, pivots);
    if (place.face < 0) return false;
    if (charts_.hasCentral()) {
      if (!place.plain) return charts_.planar() && charts_.add(place, charts_.value(charts_.central(f)), weight, row);
      row.row.push_back({charts_.central(f), weight});
      return true;
    }
    // Central control vertices of level 0 have no value of their own: the barycentre's is theirs.
    bool whole = true;
    for (const std::int32_t h : old_.halfEdgesOf(f)) {
      place.corner = h;
      whole = charts_.add(place, weight / old_.sides(f), row) && whole;
    }
    return whole;
  }

  /// What can't be continued takes the chart's value at the pivot that weighs most in the stencil.
  Row clampedRow(std::int32_t point, std::int32_t chart, std::span<const std::int32_t> pivots) const {
    std::vector<double> weights(pivots.size());
    rows_.visit(point, [&](std::int32_t p, double w) {
      for (std::size_t i = 0; i < pivots.size(); ++i) weights[i] += p == old_.vert(pivots[i]) ? w : 0;
    });
    const auto heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
    const std::int32_t held = charts_.corner(pivots[at(heaviest)]);
    Row row;
    rows_.visit(point, [&](std::int32_t p, double w) {
      Charts::ChartRow entries;
      if (addSource(p, w, chart, pivots, entries) && entries.weight == 0) {
        row.insert(row.end(), entries.row.begin(), entries.row.end());
      } else {
        row.push_back({held, w});
      }
    });
    mergeEntries(row);
    return row;
  }

  // Values that a vertex has in further charts
  // -------------------------------------------------------------------------

  /// The rows of a vertex's further values, and which of them each of its corners has (0: its own).
  struct Extras {
    std::vector<Row> rows;
    std::vector<std::pair<std::int32_t, std::int32_t>> corners;
  };

  void addExtras() {
    std::vector<std::int32_t> vertices;
    for (std::int32_t v = 0; v < new_.vertexCount(); ++v) {
      if (onSeam(v)) vertices.push_back(v);
    }
    std::vector<Extras> extras(vertices.size());
    Parallel::forEach(
        0, static_cast<std::int64_t>(vertices.size()),
        [&](std::int64_t i) { extras[at(i)] = extrasOf(vertices[at(i)]); }, 64);
    for (const Extras& extra : extras) append(extra);
  }

  bool onSeam(std::int32_t v) const {
    for (const std::int32_t h : new_.halfEdgesFrom(v)) {
      if (charts_.touched(cellOf(new_.face(h)).chart)) return true;
    }
    return false;
  }

  Extras extrasOf(std::int32_t v) const {
    Extras extras;
    const std::int32_t homeFace = home(v);
    const Cell own = cellOf(new_.face(primary_[at(v)]));
    const Row ownRow = hasFaceRow(v) ? Row() : primaryRow(v);
    for (const std::int32_t h : new_.halfEdgesFrom(v)) {
      const Cell cell = cellOf(new_.face(h));
      if (cell.chart == own.chart) continue;
      std::optional<Row> row = homeFace >= 0 ? carriedRow(v, homeFace, cell, ownRow) : rowIn(v, cell);
      if (!row || sameRow(*row, ownRow)) continue;
      const auto known =
          std::find_if(extras.rows.begin(), extras.rows.end(), [&](const Row& other) { return sameRow(other, *row); });
      extras.corners.emplace_back(h, static_cast<std::int32_t>(known - extras.rows.begin()));
      if (known == extras.rows.end()) extras.rows.push_back(std::move(*row));
    }
    return extras;
  }

  /// Point v, which lies in face `homeFace`, in the chart of a cell of another face; none where its own value is
  /// that too.
  std::optional<Row> carriedRow(std::int32_t v, std::int32_t homeFace, const Cell& cell, const Row& ownRow) const {
    if (!hasFaceRow(v) && liesIn(v, cell.chart)) {
      Row row = rowIn(v, cell);
      if (sameRow(row, ownRow)) return std::nullopt;
      return row;
    }
    const std::vector<std::int32_t> pivots = pivotsOf(v, cell);
    const Charts::Place place = charts_.findFace(homeFace, pivots);
    if (place.face >= 0 && place.plain) return std::nullopt;
    Charts::ChartRow row;
    const bool carried = charts_.planar() && charts_.add(place, {values_[2 * at(v)], values_[2 * at(v) + 1]}, 1, row);
    if (carried && charts_.close(cell.chart, row)) return std::move(row.row);
    return clampedRow(v, cell.chart, pivots);
  }

  /// Further values are loose rows, which come last in a table.
  void append(const Extras& extras) {
    LevelTable& table = level_.table;
    for (const auto& corner : extras.corners) level_.corners[at(corner.first)] = level_.valueCount + corner.second;
    for (const Row& row : extras.rows) {
      table.loose.outputs.push_back(level_.valueCount++);
      for (const Weight& entry : row) {
        table.indices.edit().push_back(entry.point);
        table.weights.push_back(entry.weight);
      }
      table.loose.offsets.push_back(static_cast<std::int32_t>(table.indices.size()) - table.loose.firstIndex);
    }
  }

  const Level& child_;
  const Topology& old_;
  const Topology& new_;
  const Charts& charts_;
  LevelRows rows_;
  std::vector<std::int32_t> faceOfInput_;
  std::vector<std::int32_t> primary_;  // per vertex of the child: a half-edge that leaves it
  FaceVaryingLevel level_;
  std::vector<double> values_;  // of the vertices, where they are looked at
};

}  // namespace

FaceVaryingLevel buildFaceVaryingLevel(const Level& parent, const Level& child, const Charts& charts,
                                       std::int32_t parentValueCount, std::int32_t length,
                                       std::vector<double>& values) {
  return LevelBuilder(parent, child, charts, parentValueCount).build(length, values);
}

}  // namespace honeycomb::Far
