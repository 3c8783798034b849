#include "apps/viewer/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/viewer/cube.h"

namespace honeycomb::ViewerTests {
namespace {

/// The largest |x| and |y| of the points in clip space; depth must be within 0..1.
glm::vec2 reachOf(const Viewer::Camera& camera, std::span<const float> points, float aspect) {
  const glm::mat4 matrix = camera.projection(aspect) * camera.view();
  glm::vec2 reach(0);
  for (std::size_t i = 0; i < points.size(); i += 3) {
    const glm::vec4 clip = matrix * glm::vec4(points[i], points[i + 1], points[i + 2], 1);
    reach = glm::max(reach, glm::abs(glm::vec2(clip) / clip.w));
    EXPECT_GT(clip.z / clip.w, 0) << "nearer than the near plane";
    EXPECT_LT(clip.z / clip.w, 1) << "farther than the far plane";
  }
  return reach;
}

TEST(Camera, FrameAllHoldsAllPointsAndFillsTheTighterSide) {
  const Cube cube(0);
  std::vector<float> points = cube.points;
  for (std::size_t i = 0; i < points.size(); i += 3) points[i] = 5 + 2 * points[i];
  for (const float aspect : {0.5F, 1.0F, 1.6F}) {
    for (const glm::vec3 direction : {glm::vec3(1, 0.5F, 0.8F), glm::vec3(0, 1, 0), glm::vec3(-3, -1, 0.1F)}) {
      const Viewer::Camera camera = Viewer::frameAll(points, direction, aspect, 0.6F, 0.1F);
      const glm::vec2 reach = reachOf(camera, points, aspect);
      EXPECT_NEAR(std::max(reach.x, reach.y), 0.8F, 1e-4F) << "aspect " << aspect;
    }
  }
}

TEST(Camera, UpInTheWorldIsUpInThePicture) {
  const Viewer::Camera camera = Viewer::frameAll(Cube(0).points, {0.3F, 0.2F, 1}, 1);
  const glm::mat4 matrix = camera.projection(1) * camera.view();
  const glm::vec4 high = matrix * glm::vec4(0, 1, 0, 1);
  EXPECT_LT(high.y / high.w, 0) << "Vulkan's y points down";
}

TEST(Bounds, HoldThePoints) {
  const std::vector<float> points{1, 2, 3, -4, 7, 0};
  const Viewer::Bounds bounds = Viewer::boundsOf(points);
  EXPECT_EQ(bounds.lower, glm::vec3(-4, 2, 0));
  EXPECT_EQ(bounds.upper, glm::vec3(1, 7, 3));
  EXPECT_EQ(Viewer::unite(bounds, {{0, 0, 0}, {9, 1, 1}}).upper, glm::vec3(9, 7, 3));
}

}  // namespace
}  // namespace honeycomb::ViewerTests
