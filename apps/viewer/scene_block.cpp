#include "apps/viewer/scene_block.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace honeycomb::Viewer {

std::uint32_t shadowCount(Lighting lighting) {
  return lighting == Lighting::full ? kLights : 1;
}

namespace {

constexpr int kKeyLights = 4;
constexpr int kDomeLights = kLights - kKeyLights;
constexpr int kQuickLights = 4;       ///< one key light, and a dome without shadows
constexpr float kQuickDome = 0.9f;    ///< dimmer: the hollows that it would leave dark are all over
constexpr float kKeySpread = 0.055f;  ///< tangent of the half-angle the key light is seen under
constexpr float kKeyBlur = 0.008f;    ///< of a shadow's edge, in tiles
constexpr float kDomeBlur = 0.012f;
constexpr float kGroundReach = 3.5f;  ///< radii of the mesh over which its shadow shows
const glm::vec3 kKeyColour(1.00f, 0.95f, 0.87f);
const glm::vec3 kZenith(0.90f, 0.95f, 1.00f);
const glm::vec3 kHorizon(0.98f, 0.97f, 1.00f);
constexpr float kKeyPower = 1.02f;
constexpr float kDomePower = 0.66f;
constexpr float kGolden = 2.39996323f;  ///< golden angle: points of a spiral spread evenly

/// The camera's horizontal axes, so that the light stays where a photographer would put it.
struct StudioAxes {
  glm::vec3 right;
  glm::vec3 up;
  glm::vec3 toCamera;
};

StudioAxes axesOf(const Camera& camera) {
  const glm::vec3 up(0, 1, 0);
  glm::vec3 back = camera.eye - camera.target;
  back.y = 0;
  const float length = glm::length(back);
  const glm::vec3 toCamera = length > 1e-6f ? back / length : glm::vec3(0, 0, 1);
  return {glm::cross(up, toCamera), up, toCamera};
}

/// World to a light's tile: an orthographic view along the light that just holds the ball.
glm::mat4 tileMatrix(glm::vec3 direction, glm::vec3 centre, float radius) {
  const glm::vec3 up = std::abs(direction.y) > 0.95f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const float reach = 1.06f * radius;
  const glm::mat4 view = glm::lookAtRH(centre + 2.0f * radius * direction, centre, up);
  // The far plane lies well behind the ball: the ground below it is looked up too.
  const glm::mat4 clip = glm::orthoRH_ZO(-reach, reach, -reach, reach, 0.5f * radius, 8.0f * radius);
  const glm::mat4 half = glm::scale(glm::translate(glm::mat4(1), {0.5f, 0.5f, 0}), {0.5f, 0.5f, 1});
  return half * clip * view;
}

glm::vec3 keyDirection(const StudioAxes& axes) {
  return glm::normalize(-0.62f * axes.right + 1.05f * axes.up + 0.55f * axes.toCamera);
}

LightBlock keyLight(int i, const StudioAxes& axes) {
  const glm::vec3 middle = keyDirection(axes);
  const glm::vec3 side = glm::normalize(glm::cross(middle, axes.up));
  const glm::vec3 above = glm::cross(side, middle);
  const float r = kKeySpread * std::sqrt((static_cast<float>(i) + 0.5f) / kKeyLights);
  const float angle = kGolden * static_cast<float>(i);
  const glm::vec3 direction = glm::normalize(middle + r * (std::cos(angle) * side + std::sin(angle) * above));
  return {{}, glm::vec4(direction, kKeyBlur), glm::vec4(kKeyColour * (kKeyPower / kKeyLights), 0)};
}

LightBlock domeLight(int i, const StudioAxes& axes) {
  const float height = glm::mix(0.97f, 0.16f, (static_cast<float>(i) + 0.5f) / kDomeLights);
  const float angle = kGolden * static_cast<float>(i) + 0.7f;
  const float level = std::sqrt(1 - height * height);
  const glm::vec3 direction =
      height * axes.up + level * (std::cos(angle) * axes.right + std::sin(angle) * axes.toCamera);
  const glm::vec3 radiance = glm::mix(kHorizon, kZenith, height) * (kDomePower / kDomeLights);
  return {{}, glm::vec4(direction, kDomeBlur), glm::vec4(radiance, 0)};
}

/// Light i of the few that quick pictures have.
LightBlock quickLight(int i, const StudioAxes& axes) {
  if (i == 0) return {{}, glm::vec4(keyDirection(axes), kKeyBlur), glm::vec4(kKeyColour * kKeyPower, 0)};
  LightBlock light = domeLight((2 * i - 1) * kDomeLights / (2 * (kQuickLights - 1)), axes);
  light.radiance *= kQuickDome * static_cast<float>(kDomeLights) / (kQuickLights - 1);
  return light;
}

LightBlock fullLight(int i, const StudioAxes& axes) {
  return i < kKeyLights ? keyLight(i, axes) : domeLight(i - kKeyLights, axes);
}

void arrangeLights(SceneBlock& scene, const StudioAxes& axes, const Bounds& bounds, Lighting lighting) {
  const int count = lighting == Lighting::full ? kLights : kQuickLights;
  scene.rimDirection.w = static_cast<float>(count);
  scene.rimRadiance.w = static_cast<float>(shadowCount(lighting));
  const float radius = std::max(bounds.radius(), 1e-6f);
  float onGround = 0;
  for (int i = 0; i < count; ++i) {
    LightBlock light = lighting == Lighting::full ? fullLight(i, axes) : quickLight(i, axes);
    light.toTile = tileMatrix(glm::vec3(light.direction), bounds.centre(), radius);
    light.radiance.w = light.radiance.y * std::max(light.direction.y, 0.0f);
    onGround += light.radiance.w;
    scene.lights[static_cast<std::size_t>(i)] = light;
  }
  for (LightBlock& light : scene.lights) light.radiance.w /= onGround;
}

}  // namespace

SceneBlock arrangeScene(const Camera& camera, const Bounds& bounds, const Style& style, glm::uvec2 picture) {
  const StudioAxes axes = axesOf(camera);
  const float radius = std::max(bounds.radius(), 1e-6f);
  SceneBlock scene{};
  const glm::vec2 size(picture);
  scene.viewProjection = camera.projection(size.x / size.y) * camera.view();
  scene.inverseViewProjection = glm::inverse(scene.viewProjection);
  scene.eye = glm::vec4(camera.eye, style.faceted ? 1 : 0);
  scene.ground = glm::vec4(bounds.centre().x, bounds.lower.y, bounds.centre().z, kGroundReach * radius);
  scene.backdropCentre = glm::vec4(linear(style.backdropCentre), 0.5f * style.edgeWidth);
  scene.backdropRim = glm::vec4(linear(style.backdropRim), style.edgeStrength);
  scene.shadowTint = glm::vec4(0.20f, 0.21f, 0.26f, style.ground ? 1 : 0);
  const float texel = 2 * 1.06f * radius / static_cast<float>(kTileSize);
  scene.bounce = glm::vec4(0.17f, 0.155f, 0.14f, 2.0f * texel);
  const glm::vec3 behind = glm::normalize(0.7f * axes.right + 0.5f * axes.up - 0.8f * axes.toCamera);
  scene.rimDirection = glm::vec4(behind, 0);
  scene.rimRadiance = glm::vec4(0.42f, 0.45f, 0.50f, 0);
  scene.keyDirection = glm::vec4(keyDirection(axes), 60);
  scene.keyRadiance = glm::vec4(kKeyColour, 0.12f);
  scene.picture = glm::vec4(size, style.flatness ? 1 : 0, style.mostBent);
  arrangeLights(scene, axes, bounds, style.lighting);
  return scene;
}

}  // namespace honeycomb::Viewer
