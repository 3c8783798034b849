#include "far/tables/mirrored_polygon.h"

#include <cmath>
#include <numbers>

#include "far/base/index.h"

namespace honeycomb::Far {

MirroredPolygon::MirroredPolygon(const Topology& topology, std::int32_t f)
    : topology_(topology),
      first_(topology.faceOffsets()[at(f)]),
      count_(topology.sides(f)),
      mid_(topology.vertexTag(topology.vert(first_)) == VertexTag::mid),
      half_(mid_ ? count_ - 2 : count_ - 1) {}

std::int32_t MirroredPolygon::vertex(std::int32_t q) const {
  return topology_.vert(q == count_ - 1 ? first_ : first_ + 1 + q);
}

double MirroredPolygon::mirrorCosine(std::int32_t i) const {
  if (mid_ && half_ == 1) return 0;
  const double step = std::numbers::pi / half_;
  return mid_ ? std::cos(step * (i - 0.5)) / std::cos(step / 2) : std::cos(step * i);
}

std::array<MirroredPolygon::Term, 3> MirroredPolygon::corner(std::int32_t j) const {
  const std::int32_t there = mid_ ? half_ : half_ + 1;  // polygon corners that are on the path
  if (j < there) return {{{mid_ ? j + 1 : j, 1}, {0, 0}, {0, 0}}};
  const std::int32_t i = 2 * half_ - j;
  const double c = mirrorCosine(i);
  return {{{0, 1 + c}, {count_ - 1, 1 - c}, {i, -1}}};
}

std::vector<double> MirroredPolygon::fold(const std::vector<double>& polygonWeights) const {
  std::vector<double> folded(at(count_), 0.0);
  for (std::int32_t j = 0; j < sides(); ++j) {
    for (const Term& term : corner(j)) folded[at(term.q)] += term.weight * polygonWeights[at(j)];
  }
  return folded;
}

}  // namespace honeycomb::Far
