#include "far/tables/chart_rows.h"

#include <algorithm>

#include "far/base/index.h"

namespace honeycomb::Far {

bool ChartRows::hasFaceRow(std::int32_t point) const {
  const LevelRows::Kind kind = rows_.place(point).kind;
  return kind == LevelRows::Kind::circulant || kind == LevelRows::Kind::projected;
}

bool ChartRows::readsSums(std::int32_t point) const {
  const LevelRows::Kind kind = rows_.place(point).kind;
  return kind == LevelRows::Kind::summed || kind == LevelRows::Kind::projected;
}

bool ChartRows::liesIn(std::int32_t point, std::int32_t face) const {
  bool inside = true;
  visitFaces(
      point,
      [&](std::int32_t p, double) {
        inside = inside && (p < old_.vertexCount() ? charts_.cornerOf(p, face) >= 0 : centralFace(p) == face);
      },
      [&](const LevelRows::Sum& sum, double) { inside = inside && sums_.liesIn(sum, face); });
  return inside;
}

std::int32_t ChartRows::centralFace(std::int32_t point) const {
  const std::int32_t f = point - old_.vertexCount();
  return faceOfInput_.empty() ? f : faceOfInput_[at(f)];
}

Row ChartRows::rowIn(std::int32_t point, const ChartCell& cell) const {
  const Pivots pivots = charts_.hasSeams() ? pivotsOf(point, cell) : Pivots();
  Charts::ChartRow row;
  bool whole = true;
  visitFaces(
      point, [&](std::int32_t p, double w) { whole = addSource(p, w, cell.chart, pivots, row) && whole; },
      [&](const LevelRows::Sum& sum, double share) { whole = addSum(sum, share, cell.chart, pivots, row) && whole; });
  if (whole && charts_.close(cell.chart, row)) return std::move(row.row);
  return clampedRow(point, cell.chart, pivots);
}

ChartRows::Pivots ChartRows::pivotsOf(std::int32_t point, const ChartCell& cell) const {
  if (cell.pivotCount > 0) return {{cell.known().begin(), cell.known().end()}, nullptr, false};
  Pivots pivots;
  bool outside = false;
  visitFaces(
      point,
      [&](std::int32_t p, double) {
        const std::int32_t c = p < old_.vertexCount() ? charts_.cornerOf(p, cell.chart) : -1;
        if (c >= 0) pivots.corners.push_back(c);
        outside = outside || (c < 0 && (p < old_.vertexCount() || centralFace(p) != cell.chart));
      },
      [&](const LevelRows::Sum& sum, double) { outside = outside || !sums_.liesIn(sum, cell.chart); });
  if (!outside) return {};
  pivots.beyond = true;
  if (old_.sides(cell.chart) > kLargestCirculant || sums_.firstOfMany(cell.chart)) {
    pivots.further = &beyond(cell.chart);
  } else {
    const std::vector<std::int32_t> others = cornersBeyond(cell.chart);
    pivots.corners.insert(pivots.corners.end(), others.begin(), others.end());
  }
  return pivots;
}

/// Where two halves of a face grow together, the other is seen over the cut.
std::vector<std::int32_t> ChartRows::cornersBeyond(std::int32_t chart) const {
  std::vector<std::int32_t> corners;
  for (const std::int32_t h : old_.halfEdgesOf(chart)) {
    if (old_.onBoundary(old_.vert(h))) corners.push_back(h);
  }
  if (corners.empty()) corners.push_back(old_.faceOffsets()[at(chart)]);
  return corners;
}

const Charts::Round& ChartRows::beyond(std::int32_t chart) const {
  const std::scoped_lock lock(lock_);
  const auto place = beyond_.try_emplace(chart);
  if (place.second) place.first->second = charts_.walkRound(cornersBeyond(chart));
  return place.first->second;
}

/// Each of the parts that meet in one vertex has this, and few faces therefore.
const Charts::Round& ChartRows::justBeyond(std::int32_t chart) const {
  const std::scoped_lock lock(lock_);
  const auto place = justBeyond_.try_emplace(chart);
  if (place.second) place.first->second = charts_.walkRound(cornersBeyond(chart), Charts::kFewFaces);
  return place.first->second;
}

const Charts::Round& ChartRows::around(std::int32_t p) const {
  const std::scoped_lock lock(lock_);
  const auto place = around_.try_emplace(p);
  if (place.second) {
    const std::int32_t h = old_.outgoing(p);
    place.first->second = charts_.walkRound({&h, 1});
  }
  return place.first->second;
}

Charts::Place ChartRows::findFace(std::int32_t face, const Pivots& pivots) const {
  const Charts::Place place = charts_.findFace(face, pivots.corners, pivots.further);
  return place.face >= 0 ? place : charts_.findOver(pivots.corners, beyond(face)).place;
}

/// Of the copies that a vertex has along a crease the first stands for all; another, or the part of a face in which the
/// pivots are, may have to be crossed for it.
Charts::Place ChartRows::findVertex(std::int32_t p, const Pivots& pivots) const {
  const Charts::Place place = charts_.findVertex(p, pivots.corners, pivots.further);
  if (place.face >= 0) return place;
  Charts::Walk best = charts_.findOver(pivots.corners, around(p));
  best.place.corner = old_.outgoing(p);
  if (best.place.face >= 0) return best.place;
  for (const std::int32_t h : old_.halfEdgesFrom(p)) {
    const Charts::Walk way = charts_.findOver(pivots.corners, justBeyond(old_.face(h)));
    if (way.place.face < 0 || !way.betterThan(best)) continue;
    best = way;
    best.place.corner = h;
  }
  return best.place;
}

/// Adds weight times a source point; false when it can't be seen from the chart.
bool ChartRows::addSource(std::int32_t p, double weight, std::int32_t chart, const Pivots& pivots,
                          Charts::ChartRow& row) const {
  if (p >= old_.vertexCount()) return addCentral(centralFace(p), weight, chart, pivots, row);
  Charts::Place place;
  place.corner = charts_.hasSeams() ? charts_.cornerOf(p, chart) : old_.outgoing(p);
  if (place.corner >= 0) {
    place.face = chart;
  } else {
    place = findVertex(p, pivots);
  }
  return charts_.add(place, weight, row);
}

Charts::Place ChartRows::placeOf(std::int32_t face, std::int32_t chart, const Pivots& pivots) const {
  Charts::Place place;
  place.face = face;
  return face == chart || !charts_.hasSeams() ? place : findFace(face, pivots);
}

/// Adds share times a sum; false when it can't be seen from the chart.
bool ChartRows::addSum(const LevelRows::Sum& sum, double share, std::int32_t chart, const Pivots& pivots,
                       Charts::ChartRow& row) const {
  if (sums_.manyParts(sum)) return addManyParts(sum, share, chart, pivots, row);
  bool whole = true;
  for (const ChartSums::Part& part : sums_.parts(sum)) {
    const Charts::Place place = placeOf(part.face, chart, pivots);
    if (place.face >= 0 && place.plain) {
      row.row.push_back({sourceCount_ + part.number, share});
    } else {
      whole = whole && place.face >= 0 && charts_.planar() && charts_.add(place, part.sum, part.weight, share, row);
    }
  }
  return whole;
}

/// Many parts of one face are seen from another part of it, once for all rows.
bool ChartRows::addManyParts(const LevelRows::Sum& sum, double share, std::int32_t chart, const Pivots& pivots,
                             Charts::ChartRow& row) const {
  if (!pivots.beyond) return false;
  const Seen& many = seen(sum, chart);
  if (many.plain) {
    row.row.push_back({sourceCount_ + sums_.whole(sum), share});
  } else {
    row.weight += share * many.row.weight;
    row.sum += share * many.row.sum;
  }
  return many.plain || many.continued;
}

const ChartRows::Seen& ChartRows::seen(const LevelRows::Sum& sum, std::int32_t chart) const {
  const Charts::Round& round = beyond(chart);
  const std::scoped_lock lock(lock_);
  const auto place = seen_.try_emplace({sum.face, sum.projection, chart});
  if (place.second) place.first->second = see(sum, chart, round);
  return place.first->second;
}

/// What is plain beside parts that aren't is summed up with them.
ChartRows::Seen ChartRows::see(const LevelRows::Sum& sum, std::int32_t chart, const Charts::Round& round) const {
  Seen seen;
  seen.continued = charts_.planar();
  for (const ChartSums::Part& part : sums_.parts(sum)) {
    Charts::Place place;
    if (part.face != chart) {
      const Charts::Walk* way = round.to(part.face);
      place = way == nullptr ? Charts::Place{.plain = false} : way->place;
    }
    seen.plain = seen.plain && place.plain;
    place.continued = place.continued || place.plain;
    seen.continued = seen.continued && charts_.add(place, part.sum, part.weight, 1, seen.row);
  }
  return seen;
}

bool ChartRows::addCentral(std::int32_t f, double weight, std::int32_t chart, const Pivots& pivots,
                           Charts::ChartRow& row) const {
  Charts::Place place = placeOf(f, chart, pivots);
  if (place.face < 0) return false;
  if (charts_.hasCentral()) {
    if (!place.plain) return charts_.planar() && charts_.add(place, charts_.value(charts_.central(f)), 1, weight, row);
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

/// The corner whose vertex weighs most in a point's stencil.
std::int32_t ChartRows::heaviest(std::int32_t point, const Pivots& pivots) const {
  std::vector<double> weights(pivots.corners.size());
  visitFaces(
      point,
      [&](std::int32_t p, double w) {
        for (std::size_t i = 0; i < weights.size(); ++i) weights[i] += p == old_.vert(pivots.corners[i]) ? w : 0;
      },
      [](const LevelRows::Sum&, double) {});
  if (weights.empty()) return pivots.further->pivots.front();
  return pivots.corners[at(std::max_element(weights.begin(), weights.end()) - weights.begin())];
}

Row ChartRows::clampedRow(std::int32_t point, std::int32_t chart, const Pivots& pivots) const {
  const std::int32_t held = charts_.corner(heaviest(point, pivots));
  Row row;
  const auto take = [&](std::int32_t p, double w) {
    Charts::ChartRow entries;
    if (addSource(p, w, chart, pivots, entries) && entries.weight == 0) {
      row.insert(row.end(), entries.row.begin(), entries.row.end());
    } else {
      row.push_back({held, w});
    }
  };
  const auto takePart = [&](const ChartSums::Part& part, double share) {
    const Charts::Place place = placeOf(part.face, chart, pivots);
    const bool plain = place.face >= 0 && place.plain && part.number >= 0;
    row.push_back(plain ? Weight{sourceCount_ + part.number, share} : Weight{held, share * part.weight});
  };
  visitFaces(point, take, [&](const LevelRows::Sum& sum, double share) {
    if (sums_.manyParts(sum) && pivots.beyond && seen(sum, chart).plain) {
      row.push_back({sourceCount_ + sums_.whole(sum), share});
    } else if (sums_.manyParts(sum)) {
      row.push_back({held, share * sums_.weight(sum)});
    } else {
      for (const ChartSums::Part& part : sums_.parts(sum)) takePart(part, share);
    }
  });
  mergeEntries(row);
  return row;
}

}  // namespace honeycomb::Far
