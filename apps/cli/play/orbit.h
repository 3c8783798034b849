#pragma once

#include <span>

#include "apps/viewer/camera.h"

namespace honeycomb::Cli::Play {

/// A camera that turns round a point. Angles in radians; lengths in the mesh's units.
class Orbit {
 public:
  /// Looks at the points from where an animal that looks along z is seen at its best, and holds them all. `bounds`:
  /// of the points. `aspect`: width over height of the picture.
  static Orbit framing(std::span<const float> points, const Viewer::Bounds& bounds, float aspect);
  /// The same for a camera that turns all the way round: the points' middle stays where it is.
  static Orbit turntable(std::span<const float> points, const Viewer::Bounds& bounds, float aspect);

  void turn(float yaw, float pitch);
  /// Closer by that factor (below 1: farther).
  void zoom(float factor);
  /// Moves what is looked at, in heights of the picture: to the right and up.
  void pan(float right, float up);
  /// From the same side, everything in the picture again.
  void frameAll(std::span<const float> points, const Viewer::Bounds& bounds, float aspect);

  Viewer::Camera camera() const;
  float yaw() const { return yaw_; }
  float pitch() const { return pitch_; }
  float distance() const { return distance_; }

 private:
  explicit Orbit(const Viewer::Bounds& bounds);
  glm::vec3 direction() const;

  glm::vec3 target_{0};
  float distance_ = 1;
  float yaw_;
  float pitch_;
  glm::vec3 middle_;
  float radius_;
};

}  // namespace honeycomb::Cli::Play
