#include "far/tables/charts.h"

#include <algorithm>
#include <cmath>

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
  if (seams_ && planar()) findFrames();
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

/// Round the vertex that `pivot` leaves, until found(h, place) for the half-edge h that leaves it in a face.
template <class Found>
Charts::Place Charts::walk(std::int32_t pivot, bool counterClockwise, const Found& found, std::int32_t& seams,
                           std::int32_t& steps) const {
  Place place;
  std::int32_t h = pivot;
  seams = steps = 0;
  do {
    const std::int32_t edge = counterClockwise ? topology_.prev(h) : h;
    const std::int32_t t = across(edge);
    if (t < 0) return {};
    seams += isSeam(edge) ? 1 : 0;
    ++steps;
    cross(edge, place);
    h = counterClockwise ? t : topology_.next(t);
    if (found(h, place)) return place;
  } while (h != pivot);
  return {};
}

template <class Found>
Charts::Place Charts::search(std::span<const std::int32_t> pivots, const Found& found) const {
  Place best;
  std::int32_t bestSeams = 0;
  std::int32_t bestSteps = 0;
  for (const std::int32_t pivot : pivots) {
    for (const bool counterClockwise : {true, false}) {
      std::int32_t seams = 0;
      std::int32_t steps = 0;
      const Place place = walk(pivot, counterClockwise, found, seams, steps);
      const bool better = best.face < 0 || seams < bestSeams || (seams == bestSeams && steps < bestSteps);
      if (place.face < 0 || !better) continue;
      best = place;
      bestSeams = seams;
      bestSteps = steps;
    }
  }
  return best;
}

Charts::Place Charts::findFace(std::int32_t face, std::span<const std::int32_t> pivots) const {
  return search(pivots, [&](std::int32_t h, Place& place) {
    if (topology_.face(h) != face) return false;
    place.face = face;
    return true;
  });
}

Charts::Place Charts::findVertex(std::int32_t v, std::span<const std::int32_t> pivots) const {
  return search(pivots, [&](std::int32_t h, Place& place) {
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
  });
}

bool Charts::add(const Place& place, double weight, ChartRow& row) const {
  if (place.face < 0) return false;
  if (place.plain) {
    row.row.push_back({corner(place.corner), weight});
    return true;
  }
  return planar() && add(place, value(corner(place.corner)), weight, row);
}

bool Charts::add(const Place& place, std::complex<double> value, double weight, ChartRow& row) const {
  if (!place.continued) return false;
  row.weight += weight;
  row.sum += weight * (place.toChart[0] * value + place.toChart[1]);
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
