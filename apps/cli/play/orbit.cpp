#include "apps/cli/play/orbit.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace honeycomb::Cli::Play {
namespace {

constexpr float kFieldOfView = 0.45f;  ///< vertical, radians
constexpr float kMargin = 0.06f;       ///< of the picture, on each side
constexpr float kSteepest = 1.50f;     ///< pitch; straight down the camera would have no up
constexpr float kOpeningYaw = 0.62f;   ///< from z towards x
constexpr float kOpeningPitch = 0.33f;
constexpr int kTurntableSides = 16;  ///< from which the points must fit

glm::vec3 directionOf(float yaw, float pitch) {
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}

/// How far from `target`, along `direction`, an eye that looks at it sees all points.
float distanceFor(std::span<const float> points, glm::vec3 target, glm::vec3 direction, float aspect) {
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), direction));
  const glm::vec3 up = glm::cross(direction, right);
  const float openY = std::tan(0.5f * kFieldOfView) * (1 - 2 * kMargin);
  const float openX = openY * aspect;
  float distance = 0;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const glm::vec3 arm = glm::vec3(points[i], points[i + 1], points[i + 2]) - target;
    const float wide = std::max(std::abs(glm::dot(arm, right)) / openX, std::abs(glm::dot(arm, up)) / openY);
    distance = std::max(distance, glm::dot(arm, direction) + wide);
  }
  return distance;
}

}  // namespace

Orbit::Orbit(const Viewer::Bounds& bounds)
    : yaw_(kOpeningYaw), pitch_(kOpeningPitch), middle_(bounds.centre()), radius_(std::max(bounds.radius(), 1e-6f)) {}

Orbit Orbit::framing(std::span<const float> points, const Viewer::Bounds& bounds, float aspect) {
  Orbit orbit(bounds);
  orbit.frameAll(points, bounds, aspect);
  return orbit;
}

Orbit Orbit::turntable(std::span<const float> points, const Viewer::Bounds& bounds, float aspect) {
  Orbit orbit(bounds);
  orbit.target_ = orbit.middle_;
  orbit.distance_ = 1e-6f;
  for (int side = 0; side < kTurntableSides; ++side) {
    const float yaw = glm::two_pi<float>() * static_cast<float>(side) / kTurntableSides;
    const float needed = distanceFor(points, orbit.target_, directionOf(yaw, orbit.pitch_), aspect);
    orbit.distance_ = std::max(orbit.distance_, needed);
  }
  return orbit;
}

glm::vec3 Orbit::direction() const {
  return directionOf(yaw_, pitch_);
}

void Orbit::turn(float yaw, float pitch) {
  yaw_ = std::remainder(yaw_ + yaw, glm::two_pi<float>());
  pitch_ = std::clamp(pitch_ + pitch, -kSteepest, kSteepest);
}

void Orbit::zoom(float factor) {
  distance_ = std::clamp(distance_ / factor, 1e-3f * radius_, 1e3f * radius_);
}

void Orbit::pan(float right, float up) {
  const float height = 2 * distance_ * std::tan(0.5f * kFieldOfView);
  const glm::vec3 axis = glm::normalize(glm::cross(glm::vec3(0, 1, 0), direction()));
  target_ -= height * (right * axis + up * glm::cross(direction(), axis));
}

void Orbit::frameAll(std::span<const float> points, const Viewer::Bounds& bounds, float aspect) {
  middle_ = bounds.centre();
  radius_ = std::max(bounds.radius(), 1e-6f);
  const Viewer::Camera camera = Viewer::frameAll(points, direction(), aspect, kFieldOfView, kMargin);
  target_ = camera.target;
  distance_ = std::max(glm::length(camera.eye - camera.target), 1e-6f);
}

Viewer::Camera Orbit::camera() const {
  Viewer::Camera camera;
  camera.fieldOfView = kFieldOfView;
  camera.target = target_;
  camera.eye = target_ + distance_ * direction();
  const float away = glm::length(camera.eye - middle_);
  camera.nearPlane = std::max(away - 1.2f * radius_, 0.02f * std::max(away, 0.1f * radius_));
  camera.farPlane = away + 4 * radius_;
  return camera;
}

}  // namespace honeycomb::Cli::Play
