#include "far/tables/chart_rows.h"

#include <algorithm>

#include "far/base/index.h"

namespace honeycomb::Far {

bool ChartRows::hasFaceRow(std::int32_t point) const {
  const LevelRows::Kind kind = rows_.place(point).kind;
  return kind == LevelRows::Kind::circulant || kind == LevelRows::Kind::projected;
}

bool ChartRows::liesIn(std::int32_t point, std::int32_t face) const {
  bool inside = true;
  visitFaces(
      point,
      [&](std::int32_t p, double) {
        inside = inside && (p < old_.vertexCount() ? charts_.cornerOf(p, face) >= 0 : centralFace(p) == face);
      },
      [&](const LevelRows::Sum& sum, double) { inside = inside && sums_.of(sum).face == face; });
  return inside;
}

std::int32_t ChartRows::centralFace(std::int32_t point) const {
  const std::int32_t f = point - old_.vertexCount();
  return faceOfInput_.empty() ? f : faceOfInput_[at(f)];
}

Row ChartRows::rowIn(std::int32_t point, const ChartCell& cell) const {
  const std::vector<std::int32_t> pivots = charts_.hasSeams() ? pivotsOf(point, cell) : std::vector<std::int32_t>();
  Charts::ChartRow row;
  bool whole = true;
  const auto take = [&](std::int32_t p, double w) { whole = addSource(p, w, cell.chart, pivots, row) && whole; };
  if (hasFaceRow(point)) {
    rows_.visit(point, take);
  } else {
    visitFaces(point, take, [&](const LevelRows::Sum& sum, double share) {
      whole = addSum(sum, share, cell.chart, pivots, row) && whole;
    });
  }
  if (whole && charts_.close(cell.chart, row)) return std::move(row.row);
  return clampedRow(point, cell.chart, pivots);
}

std::vector<std::int32_t> ChartRows::pivotsOf(std::int32_t point, const ChartCell& cell) const {
  if (cell.pivotCount > 0) return {cell.known().begin(), cell.known().end()};
  std::vector<std::int32_t> pivots;
  bool outside = false;
  visitFaces(
      point,
      [&](std::int32_t p, double) {
        const std::int32_t c = p < old_.vertexCount() ? charts_.cornerOf(p, cell.chart) : -1;
        if (c >= 0) pivots.push_back(c);
        outside = outside || (c < 0 && (p < old_.vertexCount() || centralFace(p) != cell.chart));
      },
      [&](const LevelRows::Sum& sum, double) { outside = outside || sums_.of(sum).face != cell.chart; });
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
bool ChartRows::addSource(std::int32_t p, double weight, std::int32_t chart, std::span<const std::int32_t> pivots,
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

/// Adds share times the sum S of a whole face; false when it can't be seen from the chart.
bool ChartRows::addSum(const LevelRows::Sum& sum, double share, std::int32_t chart,
                       std::span<const std::int32_t> pivots, Charts::ChartRow& row) const {
  const ChartSums::Face& large = sums_.of(sum);
  const Charts::Place place = sums_.place(large, chart, pivots);
  if (place.face < 0) return false;
  if (!place.plain) return charts_.planar() && charts_.add(place, large.mean, share * large.weights[0], row);
  row.row.push_back({sourceCount_ + large.number, share});
  return true;
}

bool ChartRows::addCentral(std::int32_t f, double weight, std::int32_t chart, std::span<const std::int32_t> pivots,
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

Row ChartRows::clampedRow(std::int32_t point, std::int32_t chart, std::span<const std::int32_t> pivots) const {
  std::vector<double> weights(pivots.size());
  visitFaces(
      point,
      [&](std::int32_t p, double w) {
        for (std::size_t i = 0; i < pivots.size(); ++i) weights[i] += p == old_.vert(pivots[i]) ? w : 0;
      },
      [](const LevelRows::Sum&, double) {});
  const auto heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  const std::int32_t held = charts_.corner(pivots[at(heaviest)]);
  Row row;
  const auto take = [&](std::int32_t p, double w) {
    Charts::ChartRow entries;
    if (addSource(p, w, chart, pivots, entries) && entries.weight == 0) {
      row.insert(row.end(), entries.row.begin(), entries.row.end());
    } else {
      row.push_back({held, w});
    }
  };
  visitFaces(point, take, [&](const LevelRows::Sum& sum, double share) {
    const ChartSums::Face& large = sums_.of(sum);
    const Charts::Place place = sums_.place(large, chart, pivots);
    if (place.face < 0 || !place.plain) {
      row.push_back({held, share * large.weights[at(sum.projection)]});
    } else if (hasFaceRow(point)) {
      rows_.visitSum(sum, [&](std::int32_t p, double w) { take(p, share * w); });
    } else {
      row.push_back({sourceCount_ + large.number, share});
    }
  });
  mergeEntries(row);
  return row;
}

}  // namespace honeycomb::Far
