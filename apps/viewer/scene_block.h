#pragma once

#include <array>
#include <glm/glm.hpp>

#include "apps/viewer/camera.h"
#include "apps/viewer/style.h"

namespace honeycomb::Viewer {

/// The studio is lit by directional lights only: a cluster for the key's soft edge and a dome of dim ones, each with a
/// shadow of its own, which together give soft contact shadows and the darkening of hollows.
constexpr int kLights = 16;
/// Their depth maps are the tiles of one square image.
constexpr int kTilesAcross = 4;
constexpr std::uint32_t kTileSize = 768;

/// A light as the shaders see it; see shaders/scene.glsl for the fields.
struct LightBlock {
  glm::mat4 toTile;
  glm::vec4 direction;
  glm::vec4 radiance;
};

/// The uniform block of shaders/scene.glsl, std140.
struct SceneBlock {
  glm::mat4 viewProjection;
  glm::mat4 inverseViewProjection;
  glm::vec4 eye;
  glm::vec4 ground;
  glm::vec4 backdropCentre;
  glm::vec4 backdropRim;
  glm::vec4 shadowTint;
  glm::vec4 bounce;
  glm::vec4 rimDirection;
  glm::vec4 rimRadiance;
  glm::vec4 keyDirection;
  glm::vec4 keyRadiance;
  glm::vec4 picture;
  std::array<LightBlock, kLights> lights;
};

/// Lights that throw shadows: the first ones.
std::uint32_t shadowCount(Lighting lighting);

/// The studio's light arranged round the box, the key over the camera's left shoulder.
SceneBlock arrangeScene(const Camera& camera, const Bounds& bounds, const Style& style, glm::uvec2 picture);

}  // namespace honeycomb::Viewer
