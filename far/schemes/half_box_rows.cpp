#include "far/schemes/half_box_rows.h"

#include <array>

#include "far/schemes/doo_sabin.h"

namespace honeycomb::Far {

namespace {

/// The neighbours of a vertex with three edges, and the faces between each and the next; -1 outside.
struct Star {
  std::array<std::int32_t, 3> neighbours{};
  std::array<std::int32_t, 3> faces{-1, -1, -1};
};

Star starOf(const Topology& topology, std::int32_t first) {
  Star star;
  std::int32_t h = first;
  for (std::size_t i = 0; i < 3; ++i) {
    star.neighbours[i] = topology.dest(h);
    star.faces[i] = topology.face(h);
    const std::int32_t p = topology.prev(h);
    h = topology.twin(p);
    if (h >= 0) continue;
    star.neighbours[i + 1] = topology.vert(p);  // on a boundary: the edge that enters, behind the second face
    break;
  }
  return star;
}

/// The weight of a vertex beside a face, where it is tuned: not by faces that a clamped boundary ends.
TunedWeights::const_iterator tunedBeside(const Topology& topology, std::int32_t f, const TunedWeights& tuned) {
  if (f < 0 || tuned.empty()) return tuned.end();
  const FaceRun& run = topology.run(f);
  const bool clamped = run.kind == FaceKind::clampedSide || run.kind == FaceKind::clampedCorner;
  return clamped ? tuned.end() : tuned.find(run.sides);
}

}  // namespace

CirculantRule halfBoxRule(std::int32_t sides) {
  if (sides != 6) return dooSabinRule(sides);
  CirculantRule rule;
  rule.here = 3.0 / 8;
  rule.mean = 1.0 / 8;
  rule.opposite = -1.0 / 8;
  return rule;
}

void addHalfBoxVertexRow(const Topology& topology, std::int32_t h, const TunedWeights& tuned, Row& row) {
  const Star star = starOf(topology, h);
  double centre = 0.25;
  std::array<double, 3> around{0.25, 0.25, 0.25};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto weight = tunedBeside(topology, star.faces[i], tuned);
    if (weight == tuned.end()) continue;
    const double more = weight->second - 0.25;
    centre += more;
    around[i] -= more / 2;
    around[(i + 1) % 3] -= more / 2;
  }
  row.push_back({topology.vert(h), centre});
  for (std::size_t i = 0; i < 3; ++i) row.push_back({star.neighbours[i], around[i]});
}

}  // namespace honeycomb::Far
