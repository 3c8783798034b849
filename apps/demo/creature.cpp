#include "apps/demo/creature.h"

#include "apps/demo/creature_motion.h"

namespace honeycomb::Demo {

std::vector<float> Creature::frame(std::int32_t number) const {
  const std::vector<Frame> pose = poseAt(static_cast<double>(number) / kFrameCount);
  std::vector<float> points;
  points.reserve(3 * shape_.vertices.size());
  for (const BoundVertex& vertex : shape_.vertices) {
    const glm::dvec3 p = pose[static_cast<std::size_t>(vertex.bone)].point(vertex.local);
    for (const double c : {p.x, p.y, p.z}) points.push_back(static_cast<float>(c));
  }
  return points;
}

}  // namespace honeycomb::Demo
