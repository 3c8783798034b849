#include "far/conversions/quad_tubes.h"

#include <algorithm>
#include <optional>

#include "far/base/index.h"

namespace honeycomb::Far {
namespace {

/// The half-edges at the bottom of the quads of a ring, left to right.
using Ring = std::vector<std::int32_t>;

class TubeFinder {
 public:
  explicit TubeFinder(const Topology& topology)
      : topology_(topology),
        tried_(at(topology.halfEdgeCount()), 0),
        stamp_(at(topology.vertexCount()), -1),
        taken_(at(topology.faceCount()), 0) {}

  /// The tube that has half-edge h at the bottom of one of its quads, if there is one that wasn't looked at before.
  std::optional<QuadTube> tubeThrough(std::int32_t h) {
    const std::optional<Ring> first = ringThrough(h);
    if (!first) return std::nullopt;
    std::vector<Ring> rings{*first};
    while (const std::optional<Ring> below = neighbour(rings.back(), Side::below)) rings.push_back(*below);
    std::reverse(rings.begin(), rings.end());
    while (const std::optional<Ring> above = neighbour(tops(rings.back()), Side::above)) rings.push_back(*above);
    if (!capped(rings.front()) || !capped(tops(rings.back()))) return std::nullopt;
    return makeTube(rings);
  }

 private:
  enum class Side { below, above };

  bool isQuad(std::int32_t h) const { return topology_.sides(topology_.face(h)) == 4; }
  std::int32_t opposite(std::int32_t h) const { return topology_.next(topology_.next(h)); }
  Ring tops(const Ring& ring) const {
    Ring result;
    for (const std::int32_t h : ring) result.push_back(opposite(h));
    return result;
  }

  /// Walks to the right; half-edges once walked over are never walked again, as they are in the same ring or strip.
  std::optional<Ring> ringThrough(std::int32_t start) {
    Ring ring;
    std::int32_t h = start;
    do {
      if (tried_[at(h)] != 0) return std::nullopt;
      tried_[at(h)] = tried_[at(opposite(h))] = 1;
      ring.push_back(h);
      const std::int32_t right = topology_.twin(topology_.next(h));
      if (right < 0 || !isQuad(right)) return std::nullopt;
      h = topology_.next(right);
    } while (h != start);
    if (ring.size() < 3) return std::nullopt;
    return ring;
  }

  /// The ring on the other side of a rim, whose quads lie on each other column by column.
  std::optional<Ring> neighbour(const Ring& rim, Side side) {
    std::vector<std::int32_t> expected;
    for (const std::int32_t h : rim) {
      const std::int32_t t = topology_.twin(h);
      if (t < 0 || !isQuad(t) || tried_[at(t)] != 0) return std::nullopt;
      expected.push_back(side == Side::above ? t : opposite(t));
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const std::int32_t right = topology_.twin(topology_.next(expected[i]));
      if (right < 0 || topology_.next(right) != expected[(i + 1) % expected.size()]) return std::nullopt;
    }
    for (const std::int32_t h : expected) tried_[at(h)] = tried_[at(opposite(h))] = 1;
    return expected;
  }

  bool capped(const Ring& rim) const {
    const auto outside = [&](std::int32_t h) { return topology_.twin(h) < 0 ? -1 : topology_.face(topology_.twin(h)); };
    const std::int32_t cap = outside(rim.front());
    const bool onePolygon = std::all_of(rim.begin(), rim.end(), [&](std::int32_t h) { return outside(h) == cap; });
    if (onePolygon && (cap < 0 || topology_.sides(cap) == static_cast<std::int32_t>(rim.size()))) return true;
    return std::all_of(rim.begin(), rim.end(),
                       [&](std::int32_t h) { return outside(h) >= 0 && topology_.sides(outside(h)) != 4; });
  }

  std::optional<QuadTube> makeTube(const std::vector<Ring>& rings) {
    QuadTube tube;
    tube.columns = static_cast<std::int32_t>(rings.front().size());
    tube.rings = static_cast<std::int32_t>(rings.size());
    for (const Ring& ring : rings)
      for (const std::int32_t h : ring) {
        tube.vertices.push_back(topology_.vert(h));
        tube.faces.push_back(topology_.face(h));
      }
    for (const std::int32_t h : tops(rings.back())) tube.vertices.push_back(topology_.dest(h));
    return claim(tube) ? std::optional(tube) : std::nullopt;
  }

  /// No vertex twice, and no face of another tube.
  bool claim(const QuadTube& tube) {
    for (const std::int32_t f : tube.faces)
      if (taken_[at(f)] != 0) return false;
    ++tube_;
    for (const std::int32_t v : tube.vertices) {
      if (stamp_[at(v)] == tube_) return false;
      stamp_[at(v)] = tube_;
    }
    for (const std::int32_t f : tube.faces) taken_[at(f)] = 1;
    return true;
  }

  const Topology& topology_;
  std::vector<std::uint8_t> tried_;  // by half-edge: at the bottom or top of a quad of a ring that was looked at
  std::vector<std::int32_t> stamp_;  // by vertex: the last tube that was tried with it
  std::vector<std::uint8_t> taken_;  // by face: in a tube
  std::int32_t tube_ = 0;
};

}  // namespace

std::vector<QuadTube> findQuadTubes(const Topology& topology, const CallerFaces& faces) {
  std::vector<QuadTube> tubes;
  TubeFinder finder(topology);
  for (std::int32_t f = 0; f < faces.count(); ++f) {
    if (faces.sides(f) != 4) continue;
    for (const std::int32_t h : {faces.halfEdge(f), faces.halfEdge(f) + 1})
      if (std::optional<QuadTube> tube = finder.tubeThrough(h)) tubes.push_back(std::move(*tube));
  }
  return tubes;
}

}  // namespace honeycomb::Far
