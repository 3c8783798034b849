#pragma once

#include <glm/glm.hpp>
#include <span>

namespace honeycomb::Viewer {

/// An axis-aligned box.
struct Bounds {
  glm::vec3 lower{0};
  glm::vec3 upper{0};
  glm::vec3 centre() const { return 0.5f * (lower + upper); }
  /// Of the sphere round the box.
  float radius() const { return 0.5f * glm::length(upper - lower); }
};

/// Of x y z packed points; grows `start` where given.
Bounds boundsOf(std::span<const float> points);
Bounds unite(const Bounds& a, const Bounds& b);

/// A perspective camera; y is up in the world unless `up` says otherwise. Lengths in the mesh's units.
struct Camera {
  glm::vec3 eye{0, 0, 5};
  glm::vec3 target{0};
  glm::vec3 up{0, 1, 0};
  float fieldOfView = 0.5f;  ///< vertical, radians
  float nearPlane = 0.1f;
  float farPlane = 100.0f;

  glm::mat4 view() const;
  /// Vulkan's clip space: y down, depth 0..1.
  glm::mat4 projection(float aspect) const;
};

/// A camera that looks along -`direction` at x y z packed points and holds them all, in the middle of the picture, with
/// `margin` (a fraction of the picture) to spare on the tighter sides.
Camera frameAll(std::span<const float> points, glm::vec3 direction, float aspect, float fieldOfView = 0.45f,
                float margin = 0.06f);

}  // namespace honeycomb::Viewer
