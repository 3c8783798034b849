#include "apps/cli/play/orbit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

namespace honeycomb::Cli::Play {
namespace {

const std::vector<float> kBox{-2, 0, -1, 2, 0, -1, 2, 1, 1, -2, 1, 1, -2, 1, -1, 2, 0, 1};
const Viewer::Bounds kBoxBounds = Viewer::boundsOf(kBox);
constexpr float kAspect = 1.6F;

/// The largest of |x| and |y| that a point has in the picture, whose sides are at 1.
float reachOf(const Viewer::Camera& camera) {
  const glm::mat4 matrix = camera.projection(kAspect) * camera.view();
  float reach = 0;
  for (std::size_t i = 0; i < kBox.size(); i += 3) {
    const glm::vec4 p = matrix * glm::vec4(kBox[i], kBox[i + 1], kBox[i + 2], 1);
    EXPECT_GT(p.z, 0) << "behind the near plane";
    EXPECT_LT(p.z, p.w) << "beyond the far plane";
    reach = std::max({reach, std::abs(p.x / p.w), std::abs(p.y / p.w)});
  }
  return reach;
}

TEST(OrbitTest, OpensWithEverythingInThePicture) {
  const float reach = reachOf(Orbit::framing(kBox, kBoxBounds, kAspect).camera());
  EXPECT_LT(reach, 0.95F);
  EXPECT_GT(reach, 0.75F) << "as large as it gets";
}

TEST(OrbitTest, ATurntableHoldsEverythingFromAllSides) {
  Orbit orbit = Orbit::turntable(kBox, kBoxBounds, kAspect);
  for (int step = 0; step < 36; ++step) {
    EXPECT_LT(reachOf(orbit.camera()), 0.96F) << step;
    orbit.turn(glm::two_pi<float>() / 36, 0);
  }
}

TEST(OrbitTest, AFullTurnComesBack) {
  Orbit orbit = Orbit::turntable(kBox, kBoxBounds, kAspect);
  const glm::vec3 before = orbit.camera().eye;
  for (int step = 0; step < 8; ++step) orbit.turn(glm::quarter_pi<float>(), 0);
  EXPECT_LT(glm::length(orbit.camera().eye - before), 1e-4F);
}

TEST(OrbitTest, NeverTurnsOverTheTop) {
  Orbit orbit = Orbit::framing(kBox, kBoxBounds, kAspect);
  orbit.turn(0, 10);
  const Viewer::Camera camera = orbit.camera();
  EXPECT_GT(glm::length(glm::cross(camera.eye - camera.target, camera.up)), 0.01F);
}

TEST(OrbitTest, ZoomHalvesTheDistanceAndFrameAllBringsItBack) {
  Orbit orbit = Orbit::framing(kBox, kBoxBounds, kAspect);
  const float distance = orbit.distance();
  orbit.zoom(2);
  EXPECT_FLOAT_EQ(orbit.distance(), distance / 2);
  orbit.frameAll(kBox, kBoxBounds, kAspect);
  EXPECT_NEAR(orbit.distance(), distance, 1e-4F * distance);
}

TEST(OrbitTest, PanMovesThePictureByThatShareOfItsHeight) {
  Orbit orbit = Orbit::framing(kBox, kBoxBounds, kAspect);
  const Viewer::Camera before = orbit.camera();
  orbit.pan(0, 0.25F);
  const Viewer::Camera after = orbit.camera();
  // What was in the middle is now a quarter of the height above it: half of the way to the upper side.
  const glm::vec4 p = after.projection(kAspect) * after.view() * glm::vec4(before.target, 1);
  EXPECT_NEAR(p.y / p.w, -0.5F, 1e-3F);
  EXPECT_NEAR(p.x / p.w, 0, 1e-3F);
}

}  // namespace
}  // namespace honeycomb::Cli::Play
