#include "far/tables/face_varying_level.h"

#include <algorithm>
#include <optional>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/tables/chart_rows.h"
#include "far/tables/level_values.h"
#include "far/tables/replaced_rows.h"
#include "far/tables/row_writer.h"
#include "far/tables/summed_row_writer.h"

namespace honeycomb::Far {

namespace {

bool sameRow(const Row& a, const Row& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Weight& x, const Weight& y) { return x.point == y.point && x.weight == y.weight; });
}

class LevelBuilder {
 public:
  LevelBuilder(const Level& parent, const Level& child, const Charts& charts, std::int32_t sourceCount)
      : child_(child),
        old_(parent.topology),
        new_(child.topology),
        charts_(charts),
        rows_(child.table, charts, inputFaces(parent), sourceCount) {
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

  ChartCell cellOf(std::int32_t f) const {
    ChartCell cell;
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

  /// The parent's face that vertex v lies in and in whose chart its own value is; -1 if it lies in none.
  std::int32_t home(std::int32_t v) const {
    const std::int32_t f = new_.face(primary_[at(v)]);
    return new_.parentKind(f) == FaceParent::face ? new_.parents()[at(f)] : -1;
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
    for (std::size_t i = 0; i < old.projected.size(); ++i) {
      ProjectedFace face = old.projected[i];
      const bool alone = charts_.hasSeams() && face.outputs == 0;  // of no face of the level
      face.firstIndex = alone ? -1 : addCorners(face.firstIndex, face.firstOutput, 1, face.corners, face.outputs);
      if (face.firstIndex < 0) {
        rows_.sums().split(i, table);
        continue;
      }
      rows_.sums().name(i, cellOf(new_.face(primary_[at(face.firstOutput)])).chart,
                        static_cast<std::int32_t>(table.projected.size()), table.indices.data() + face.firstIndex);
      table.projected.push_back(face);
      if (face.outputs > 0) covered.insert(covered.end(), {face.firstOutput, face.firstOutput + face.outputs});
    }
    table.targetCount = child_.pointCount();
    covered.insert(covered.end(), {0, child_.pointCount()});
    std::sort(covered.begin(), covered.end());  // ranges don't overlap: now the gaps between them, in pairs
    RowWriter writer(table);
    SummedRowWriter summed(table);
    for (std::size_t i = 0; i < covered.size(); i += 2) addGap(covered[i], covered[i + 1], writer, summed);
    summed.finish();
    writer.finish();
  }

  /// The rows of points first .. end - 1, of which those that were summed ones still are.
  void addGap(std::int32_t first, std::int32_t end, RowWriter& writer, SummedRowWriter& summed) const {
    const auto isSummed = [&](std::int32_t point) { return rows_.readsSums(point); };
    while (first < end) {
      std::int32_t last = first + 1;
      while (last < end && isSummed(last) == isSummed(first)) ++last;
      const auto makeRow = [&](std::int64_t j, Row& row) { row = primaryRow(first + static_cast<std::int32_t>(j)); };
      isSummed(first) ? summed.add(first, last - first, makeRow) : writer.add(first, last - first, makeRow);
      first = last;
    }
  }

  /// Where the weights of the batches of faces end.
  static std::int32_t batchWeights(const LevelTable& table) {
    std::int32_t end = 0;
    for (const CirculantBatch& b : table.circulants) {
      end = std::max({end, b.firstRow + b.sides, b.firstForm + b.formWeights()});
    }
    for (const ProjectedFace& f : table.projected) {
      end = std::max(end, f.firstWeight + 2 + (f.outputs > 0 ? 3 : 1) * f.corners + 3 * f.outputs);
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
    return rows_.rowIn(point, cellOf(vertex ? new_.face(primary_[at(point)]) : point - new_.vertexCount()));
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
    RowChanges further;
    for (Extras& extra : extras) append(extra, further);
    level_.table.targetCount = level_.valueCount;
    replaceRows(level_.table, further);
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
    const ChartCell own = cellOf(new_.face(primary_[at(v)]));
    const Row ownRow = rows_.hasFaceRow(v) ? Row() : primaryRow(v);
    for (const std::int32_t h : new_.halfEdgesFrom(v)) {
      const ChartCell cell = cellOf(new_.face(h));
      if (cell.chart == own.chart) continue;
      std::optional<Row> row = homeFace >= 0 ? carriedRow(v, homeFace, cell, ownRow) : rows_.rowIn(v, cell);
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
  std::optional<Row> carriedRow(std::int32_t v, std::int32_t homeFace, const ChartCell& cell, const Row& ownRow) const {
    if (!rows_.hasFaceRow(v) && rows_.liesIn(v, cell.chart)) {
      Row row = rows_.rowIn(v, cell);
      if (sameRow(row, ownRow)) return std::nullopt;
      return row;
    }
    const ChartRows::Pivots pivots = rows_.pivotsOf(v, cell);
    const Charts::Place place = rows_.findFace(homeFace, pivots);
    if (place.face >= 0 && place.plain) return std::nullopt;
    Charts::ChartRow row;
    const bool carried =
        charts_.planar() && charts_.add(place, {values_[2 * at(v)], values_[2 * at(v) + 1]}, 1, 1, row);
    if (carried && charts_.close(cell.chart, row)) return std::move(row.row);
    return rows_.clampedRow(v, cell.chart, pivots);
  }

  void append(Extras& extras, RowChanges& further) {
    for (const auto& corner : extras.corners) level_.corners[at(corner.first)] = level_.valueCount + corner.second;
    for (Row& row : extras.rows) further.rows.push_back({level_.valueCount++, std::move(row)});
  }

  const Level& child_;
  const Topology& old_;
  const Topology& new_;
  const Charts& charts_;
  ChartRows rows_;
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
