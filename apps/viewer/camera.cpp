#include "apps/viewer/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "far/tables/bounds.h"

namespace honeycomb::Viewer {
namespace {

/// The largest of each of four: how far points lie to the right, left, above and below in a camera at distance 0 that
/// opens one unit per unit of depth. A point at (x, depth) is inside at distance d when |x| <= open (d + depth).
struct Spread {
  float right = std::numeric_limits<float>::lowest();
  float left = right;
  float above = right;
  float below = right;
  float front = right;  ///< of the points, towards the eye
  float back = right;
};

/// The camera's axes, pointing right, up and towards the eye.
struct Axes {
  glm::vec3 right;
  glm::vec3 up;
  glm::vec3 backward;
};

Axes axesFor(glm::vec3 direction, glm::vec3 up) {
  const glm::vec3 backward = glm::normalize(direction);
  const glm::vec3 right = glm::normalize(glm::cross(up, backward));
  return {right, glm::cross(backward, right), backward};
}

Spread spreadOf(std::span<const float> points, const Axes& axes, float openX, float openY) {
  Spread spread;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const glm::vec3 point(points[i], points[i + 1], points[i + 2]);
    const float x = glm::dot(point, axes.right) / openX;
    const float y = glm::dot(point, axes.up) / openY;
    const float z = glm::dot(point, axes.backward);
    spread.right = std::max(spread.right, z + x);
    spread.left = std::max(spread.left, z - x);
    spread.above = std::max(spread.above, z + y);
    spread.below = std::max(spread.below, z - y);
    spread.front = std::max(spread.front, z);
    spread.back = std::max(spread.back, -z);
  }
  return spread;
}

}  // namespace

Bounds boundsOf(std::span<const float> points) {
  if (points.size() < 3) return {};
  const Far::Box<float> box = Far::bounds<float>(points);
  return {glm::vec3(box.low[0], box.low[1], box.low[2]), glm::vec3(box.high[0], box.high[1], box.high[2])};
}

Bounds unite(const Bounds& a, const Bounds& b) {
  return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)};
}

glm::mat4 Camera::view() const {
  return glm::lookAtRH(eye, target, up);
}

glm::mat4 Camera::projection(float aspect) const {
  glm::mat4 matrix = glm::perspectiveRH_ZO(fieldOfView, aspect, nearPlane, farPlane);
  matrix[1][1] = -matrix[1][1];
  return matrix;
}

Camera frameAll(std::span<const float> points, glm::vec3 direction, float aspect, float fieldOfView, float margin) {
  Camera camera;
  camera.fieldOfView = fieldOfView;
  if (points.size() < 3) return camera;
  if (std::abs(glm::normalize(direction).y) > 0.99f) camera.up = {0, 0, -1};
  const Axes axes = axesFor(direction, camera.up);
  const float openY = std::tan(0.5f * fieldOfView) * (1 - 2 * margin);
  const float openX = openY * aspect;
  const Spread spread = spreadOf(points, axes, openX, openY);
  // An eye at (x, y, z) along the axes holds a point when z >= z_p +- (x_p - x) / open. The four planes meet, two by
  // two, at the nearest eyes that hold the width and the height; the farther of the two depths holds both.
  const float x = 0.5f * openX * (spread.right - spread.left);
  const float y = 0.5f * openY * (spread.above - spread.below);
  const float z = 0.5f * std::max(spread.right + spread.left, spread.above + spread.below);
  const float depth = spread.front + spread.back;
  const float size = std::max(depth, 1e-6f);
  const float eyeZ = std::max(z, spread.front + 0.05f * size);
  camera.eye = x * axes.right + y * axes.up + eyeZ * axes.backward;
  camera.target = camera.eye - (eyeZ - 0.5f * (spread.front - spread.back)) * axes.backward;
  camera.nearPlane = std::max(0.02f * size, 0.5f * (eyeZ - spread.front));
  camera.farPlane = eyeZ + spread.back + 2 * size;
  return camera;
}

}  // namespace honeycomb::Viewer
