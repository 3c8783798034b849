#include "apps/demo/creature_cage.h"

#include <algorithm>

namespace honeycomb::Demo {

std::int32_t CageBuilder::addVertex(int bone, const glm::dvec3& local) {
  shape_.vertices.push_back({bone, local});
  return shape_.polygons.vertexCount++;
}

Loop CageBuilder::addRing(int bone, std::span<const glm::dvec3> locals) {
  Loop ring;
  for (const glm::dvec3& local : locals) ring.push_back(addVertex(bone, local));
  return ring;
}

void CageBuilder::addFace(Loop loop) {
  if (mirrored_) std::reverse(loop.begin(), loop.end());
  shape_.polygons.addFace(loop);
}

void CageBuilder::bridge(const Loop& from, const Loop& to, std::span<const std::size_t> open) {
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (std::find(open.begin(), open.end(), k) != open.end()) continue;
    const std::size_t n = (k + 1) % from.size();
    addFace({from[k], from[n], to[n], to[k]});
  }
}

void CageBuilder::close(const Loop& ring, std::int32_t tip) {
  for (std::size_t k = 0; k < ring.size(); ++k) addFace({ring[k], ring[(k + 1) % ring.size()], tip});
}

}  // namespace honeycomb::Demo
