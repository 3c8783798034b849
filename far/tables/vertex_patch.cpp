#include "far/tables/vertex_patch.h"

#include "far/base/index.h"

namespace honeycomb::Far {

std::array<std::int32_t, 3> VertexPatch::sides() const {
  const std::array<std::int32_t, 3> f = faces();
  return {topology_.sides(f[0]), topology_.sides(f[1]), topology_.sides(f[2])};
}

std::int32_t VertexPatch::corner(std::size_t face, std::int32_t j) const {
  const std::int32_t h = halfEdges_[face];
  const std::size_t f = at(topology_.face(h));
  const std::int32_t end = topology_.faceOffsets()[f + 1];
  const std::int32_t toEnd = end - h;
  return topology_.vert(j < toEnd ? h + j : topology_.faceOffsets()[f] + j - toEnd);
}

std::int32_t VertexPatch::point(std::int32_t i) const {
  if (i == 0) return topology_.vert(halfEdges_[0]);
  if (i < 4) return topology_.dest(halfEdges_[at(i - 1)]);
  std::int32_t inside = i - 4;
  for (std::size_t face = 0; face < 2; ++face) {
    const std::int32_t count = topology_.sides(topology_.face(halfEdges_[face])) - 3;
    if (inside < count) return corner(face, inside + 2);
    inside -= count;
  }
  return corner(2, inside + 2);
}

std::vector<std::int32_t> VertexPatch::points() const {
  std::vector<std::int32_t> all(at(pointCount()));
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(all.size()); ++i) all[at(i)] = point(i);
  return all;
}

}  // namespace honeycomb::Far
