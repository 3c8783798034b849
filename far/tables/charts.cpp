#include "far/tables/charts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// A face spans the plane if twice the area of its frame is at least this much of its diameter squared.
constexpr double kLeastArea = 1e-3;

/// A continuation that leaves the face it starts from by more diameters than this comes from a chart without sense
/// beyond the seam (an edge shrunk to almost a point): it isn't taken.
constexpr double kFarthest = 16;

/// Of values on the two sides of a crease, relative to the largest there is.
constexpr double kCreaseRounding = 1e-9;

std::int32_t firstPivot(const Charts::Round& round) {
  return round.pivots.front();
}

/// On from where `way` has come to, to the face that `back` has come there from.
Charts::Walk over(const Charts::Walk& way, const Charts::Walk& back) {
  Charts::Walk whole = way;
  whole.seams += back.seams;
  whole.steps += back.steps;
  whole.place.plain = way.place.plain && back.place.plain;
  const auto [factor, shift] = back.place.toChart;
  const std::complex<double> inverse = whole.place.toChart[0] / factor;
  whole.place.toChart[1] -= inverse * shift;
  whole.place.toChart[0] = inverse;
  whole.place.continued = (way.place.plain || way.place.continued) && (back.place.plain || back.place.continued) &&
                          std::isfinite(inverse.real()) && std::isfinite(inverse.imag());
  return whole;
}

double cross(std::complex<double> a, std::complex<double> b) {
  return a.real() * b.imag() - a.imag() * b.real();
}

}  // namespace

Charts::Charts(const Topology& topology, std::span<const std::int32_t> corners, std::span<const double> values,
               std::int32_t length, std::int32_t firstCentral, bool mayHaveSeams)
    : topology_(topology),
      corners_(corners),
      values_(values),
      length_(length),
      firstCentral_(firstCentral),
      creases_(topology) {
  if (!mayHaveSeams) return;
  for (const double x : values) tolerance_ = std::max(tolerance_, kCreaseRounding * std::abs(x));
  findSeams();
  if (!seams_) return;
  if (planar()) findFrames();
  findRounds();
}

/// The half-edge on the other side of an edge or a crease.
std::int32_t Charts::across(std::int32_t h) const {
  const std::int32_t t = topology_.twin(h);
  return t >= 0 ? t : creases_.mate(h);
}

bool Charts::equal(std::int32_t a, std::int32_t b) const {
  const auto value = [&](std::int32_t h) { return values_.begin() + std::ptrdiff_t{corner(h)} * length_; };
  return std::equal(value(a), value(a) + length_, value(b),
                    [&](double x, double y) { return std::abs(x - y) <= tolerance_; });
}

bool Charts::isSeam(std::int32_t h) const {
  const std::int32_t t = topology_.twin(h);
  if (t >= 0) return corner(h) != corner(topology_.next(t)) || corner(topology_.next(h)) != corner(t);
  const std::int32_t mate = creases_.mate(h);
  return mate >= 0 && !(equal(h, topology_.next(mate)) && equal(topology_.next(h), mate));
}

void Charts::findSeams() {
  std::vector<std::uint8_t> atVertex(at(topology_.vertexCount()));
  Parallel::forEach(0, topology_.vertexCount(), [&](std::int64_t v) {
    for (const std::int32_t h : topology_.halfEdgesFrom(static_cast<std::int32_t>(v))) {
      if (isSeam(h) || isSeam(topology_.prev(h))) atVertex[at(v)] = 1;
    }
  });
  seams_ = std::find(atVertex.begin(), atVertex.end(), std::uint8_t{1}) != atVertex.end();
  if (!seams_) return;
  touched_.assign(at(topology_.faceCount()), 0);
  Parallel::forEach(0, topology_.faceCount(), [&](std::int64_t f) {
    for (const std::int32_t h : topology_.halfEdgesOf(static_cast<std::int32_t>(f))) {
      if (atVertex[at(topology_.vert(h))] != 0) touched_[at(f)] = 1;
    }
  });
}

void Charts::findFrames() {
  frames_.assign(at(topology_.faceCount()), {-1, -1, -1});
  Parallel::forEach(0, topology_.faceCount(), [&](std::int64_t f) {
    if (touched_[at(f)] != 0) frames_[at(f)] = frameOf(static_cast<std::int32_t>(f));
  });
}

/// The first corner, the one farthest from it, and the one farthest from the line through both.
std::array<std::int32_t, 3> Charts::frameOf(std::int32_t f) const {
  const std::int32_t a = topology_.faceOffsets()[at(f)];
  const std::int32_t end = topology_.faceOffsets()[at(f) + 1];
  const auto arm = [&](std::int32_t h) { return value(corner(h)) - value(corner(a)); };
  std::int32_t b = a + 1;
  for (std::int32_t h = a + 1; h < end; ++h) {
    if (std::norm(arm(h)) > std::norm(arm(b))) b = h;
  }
  const auto height = [&](std::int32_t h) { return std::abs(Far::cross(arm(b), arm(h))); };
  std::int32_t c = a + 1;
  for (std::int32_t h = a + 1; h < end; ++h) {
    if (height(h) > height(c)) c = h;
  }
  if (!(height(c) > kLeastArea * std::norm(arm(b)))) return {-1, -1, -1};
  return {a, b, c};
}

std::int32_t Charts::cornerOf(std::int32_t v, std::int32_t f) const {
  const std::int32_t first = topology_.outgoing(v);
  std::int32_t h = first;
  for (std::int32_t c = topology_.faceOffsets()[at(f)]; c < topology_.faceOffsets()[at(f) + 1]; ++c) {
    if (topology_.vert(c) == v) return c;
    if (topology_.face(h) == f) return h;
    h = topology_.nextOutgoing(h);
    if (h < 0 || h == first) return -1;
  }
  return -1;
}

/// Goes from the face of h, in which `place` is, over h to the face beyond.
void Charts::cross(std::int32_t h, Place& place) const {
  if (!isSeam(h)) return;
  const bool first = place.plain;
  place.plain = false;
  if (!planar() || (!first && !place.continued)) return;
  const std::int32_t t = across(h);
  const std::complex<double> from = value(corner(topology_.next(t)));
  const std::complex<double> edge = value(corner(t)) - from;
  const std::complex<double> to = value(corner(h));
  const std::complex<double> factor = (value(corner(topology_.next(h))) - to) / edge;
  place.continued = std::isfinite(factor.real()) && std::isfinite(factor.imag());
  place.toChart[1] += place.toChart[0] * (to - factor * from);
  place.toChart[0] *= factor;
}

bool Charts::Walk::betterThan(const Walk& other) const {
  if (other.place.face < 0) return true;
  return std::tie(seams, steps, order) < std::tie(other.seams, other.steps, other.order);
}

/// To the next face round the vertex; false when there is none, or it is the first again.
bool Charts::step(Walk& walk) const {
  const std::int32_t edge = walk.counterClockwise() ? topology_.prev(walk.h) : walk.h;
  const std::int32_t t = across(edge);
  if (t < 0) return false;
  walk.seams += isSeam(edge) ? 1 : 0;
  ++walk.steps;
  cross(edge, walk.place);
  walk.h = walk.counterClockwise() ? t : topology_.next(t);
  return walk.h != walk.pivot;
}

/// The best of the ways remembered(round) from those pivots that have a round, and from `further`, and the walks from
/// the others both ways, side by side, until found(h, place) for the half-edge h that leaves the vertex in a face, or
/// they can't become better than the best so far.
template <class Remembered, class Found>
Charts::Walk Charts::search(std::span<const std::int32_t> pivots, const Round* further, const Remembered& remembered,
                            const Found& found) const {
  Walk best;
  std::vector<Walk> walks;
  std::int32_t order = 0;
  const auto remember = [&](const Round& round) {
    Walk walk = remembered(round);
    walk.order += order;
    if (walk.place.face >= 0 && walk.betterThan(best)) best = walk;
  };
  for (const std::int32_t pivot : pivots) {
    if (const Round* round = roundFrom(pivot); round != nullptr) {
      remember(*round);
    } else if (further == nullptr || !std::ranges::binary_search(further->pivots, pivot)) {
      for (const std::int32_t way : {0, 1}) walks.push_back({pivot, order + way, pivot, 0, 0, {}});
    }
    order += 2;
  }
  if (further != nullptr) remember(*further);
  std::size_t walked = 0;
  while (!walks.empty()) {
    walked += walks.size();
    std::erase_if(walks, [&](Walk& walk) {
      if (!step(walk) || !walk.betterThan(best)) return true;
      const bool there = found(walk.h, walk.place);
      if (there) best = walk;
      return there;
    });
  }
  best.place.walked = static_cast<std::int32_t>(walked);
  return best;
}

Charts::Place Charts::findFace(std::int32_t face, std::span<const std::int32_t> pivots, const Round* further) const {
  const auto remembered = [&](const Round& round) {
    const Walk* way = round.to(face);
    return way == nullptr ? Walk() : *way;
  };
  const auto found = [&](std::int32_t h, Place& place) {
    if (topology_.face(h) != face) return false;
    place.face = face;
    return true;
  };
  return search(pivots, further, remembered, found).place;
}

Charts::Walk Charts::findOver(std::span<const std::int32_t> pivots, const Round& round) const {
  if (pivots.empty()) return {};
  std::vector<Walk> ways = walkRound(pivots).ways;
  ways.emplace_back().place.face = topology_.face(pivots.front());
  Walk best;
  for (const Walk& way : ways) {
    const Walk* back = round.to(way.place.face);
    if (back == nullptr) continue;
    const Walk whole = over(way, *back);
    if (whole.betterThan(best)) best = whole;
  }
  if (best.place.face >= 0) best.place.face = topology_.face(firstPivot(round));
  return best;
}

Charts::Place Charts::findVertex(std::int32_t v, std::span<const std::int32_t> pivots, const Round* further) const {
  const auto remembered = [&](const Round& round) {
    Walk best;
    for (const std::int32_t h : topology_.halfEdgesFrom(v)) {
      const Walk* way = round.to(topology_.face(h));
      if (way == nullptr || !way->betterThan(best)) continue;
      best = *way;
      best.place.corner = h;
    }
    return best;
  };
  const auto found = [&](std::int32_t h, Place& place) {
    const std::int32_t f = topology_.face(h);
    if (topology_.dest(h) == v) {
      place.corner = topology_.next(h);
    } else if (topology_.vert(topology_.prev(h)) == v) {
      place.corner = topology_.prev(h);
    } else {
      place.corner = cornerOf(v, f);
    }
    if (place.corner >= 0) place.face = f;
    return place.corner >= 0;
  };
  return search(pivots, further, remembered, found).place;
}

const Charts::Walk* Charts::Round::to(std::int32_t face) const {
  const auto way = std::ranges::lower_bound(ways, face, {}, [](const Walk& walk) { return walk.place.face; });
  return way == ways.end() || way->place.face != face ? nullptr : &*way;
}

const Charts::Round* Charts::roundFrom(std::int32_t pivot) const {
  const auto round = std::ranges::lower_bound(rounds_, pivot, {}, firstPivot);
  return round == rounds_.end() || firstPivot(*round) != pivot ? nullptr : &*round;
}

Charts::Round Charts::walkRound(std::span<const std::int32_t> pivots, std::int32_t most) const {
  Round round{{pivots.begin(), pivots.end()}, {}};
  for (std::size_t i = 0; i < 2 * pivots.size(); ++i) {
    Walk walk{pivots[i / 2], static_cast<std::int32_t>(i), pivots[i / 2], 0, 0, {}};
    while (walk.steps < most && step(walk)) {
      round.ways.push_back(walk);
      round.ways.back().place.face = topology_.face(walk.h);
    }
  }
  std::ranges::sort(round.ways, [](const Walk& a, const Walk& b) {
    return a.place.face != b.place.face ? a.place.face < b.place.face : a.betterThan(b);
  });
  const auto sameFace = [](const Walk& a, const Walk& b) { return a.place.face == b.place.face; };
  round.ways.erase(std::unique(round.ways.begin(), round.ways.end(), sameFace), round.ways.end());
  return round;
}

/// A face made from a vertex looks from the vertex's first face for all others round it.
void Charts::findRounds() {
  std::vector<std::int32_t> faces(at(topology_.vertexCount()), 0);
  std::vector<std::uint8_t> met(at(topology_.vertexCount()), 0);
  for (std::int32_t h = 0; h < topology_.halfEdgeCount(); ++h) {
    ++faces[at(topology_.vert(h))];
    if (touched(topology_.face(h))) met[at(topology_.vert(h))] = 1;
  }
  for (std::int32_t v = 0; v < topology_.vertexCount(); ++v) {
    if (met[at(v)] != 0 && faces[at(v)] > kFewFaces) rounds_.push_back({{topology_.outgoing(v)}, {}});
  }
  std::ranges::sort(rounds_, {}, firstPivot);
  Parallel::forEach(
      0, static_cast<std::int64_t>(rounds_.size()),
      [&](std::int64_t i) { rounds_[at(i)] = walkRound(rounds_[at(i)].pivots); }, 1);
}

bool Charts::add(const Place& place, double weight, ChartRow& row) const {
  if (place.face < 0) return false;
  if (place.plain) {
    row.row.push_back({corner(place.corner), weight});
    return true;
  }
  return planar() && add(place, value(corner(place.corner)), 1, weight, row);
}

bool Charts::add(const Place& place, std::complex<double> sum, double weight, double share, ChartRow& row) const {
  if (!place.continued) return false;
  row.weight += share * weight;
  row.sum += share * (place.toChart[0] * sum + weight * place.toChart[1]);
  return true;
}

bool Charts::close(std::int32_t face, ChartRow& row) const {
  if (row.weight == 0 && row.sum == 0.0) return true;
  const std::array<std::int32_t, 3>& frame = frames_[at(face)];
  if (frame[0] < 0) return false;
  const std::complex<double> a = value(corner(frame[0]));
  const std::complex<double> b = value(corner(frame[1])) - a;
  const std::complex<double> c = value(corner(frame[2])) - a;
  const std::complex<double> p = row.sum - row.weight * a;
  if (!(std::abs(p) <= kFarthest * std::abs(b))) return false;
  const double toB = Far::cross(p, c) / Far::cross(b, c);
  const double toC = Far::cross(b, p) / Far::cross(b, c);
  row.row.insert(row.row.end(),
                 {{corner(frame[0]), row.weight - toB - toC}, {corner(frame[1]), toB}, {corner(frame[2]), toC}});
  mergeEntries(row.row);
  return true;
}

}  // namespace honeycomb::Far
