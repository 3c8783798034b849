#pragma once

#include <cstdint>
#include <vector>

#include "apps/demo/creature_shape.h"

namespace honeycomb::Demo {

/// The demo's animal: a salamander-like lizard of about 4 units that walks in place, two strides in a seamless loop.
/// The same bits on every run.
class Creature {
 public:
  static constexpr std::int32_t kFrameCount = 72;  ///< at 30 frames a second; frame 0 follows the last

  Creature() : shape_(makeCreatureShape()) {}

  const Far::Polygons& polygons() const { return shape_.polygons; }
  /// x y z per vertex: x forward, y up, the ground at y = 0.
  std::vector<float> frame(std::int32_t number) const;

 private:
  CreatureShape shape_;
};

}  // namespace honeycomb::Demo
