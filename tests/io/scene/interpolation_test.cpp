#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "io/scene/scene.h"
#include "tests/io/files.h"
#include "tests/io/scene/gltf_builder.h"

namespace honeycomb::Io::Test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A triangle with two morph targets on one node, which one channel moves.
class MovedTriangle {
 public:
  /// `values`: as the sampler has them, at the seconds of `times`.
  std::string gltf(const std::string& path, const std::string& interpolation, const std::vector<float>& times,
                   const std::vector<float>& values, const std::string& nodeName = R"("name":"arm",)") {
    GltfBuilder file;
    const auto text = [](int number) { return std::to_string(number); };
    const std::string points = text(file.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3));
    const std::string up = text(file.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3));
    const std::string aside = text(file.floats({4, 0, 0, 4, 0, 0, 4, 0, 0}, "VEC3", 3));
    const std::string input = text(file.floats(times, "SCALAR", 1));
    const std::string type = path == "weights" ? "SCALAR" : path == "rotation" ? "VEC4" : "VEC3";
    const std::size_t width = path == "weights" ? 1 : path == "rotation" ? 4 : 3;
    const std::string output = text(file.floats(values, type, width));
    return file.file(R"("scenes":[{"nodes":[0]}],"nodes":[{)" + nodeName +
                     R"("mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":)" + points +
                     R"(},"targets":[{"POSITION":)" + up + R"(},{"POSITION":)" + aside +
                     R"(}]}]}],"animations":[{"name":"go","channels":[{"sampler":0,"target":{"node":0,"path":")" +
                     path + R"("}}],"samplers":[{"input":)" + input + R"(,"output":)" + output +
                     R"(,"interpolation":")" + interpolation + R"("}]}])");
  }
};

class Interpolated : public testing::Test {
 protected:
  Result<SceneMesh> open(const std::string& text, double framesPerSecond) {
    writeBytes(folder_ / "moved.gltf", text);
    const Result<Scene> scene = Scene::open(folder_ / "moved.gltf");
    if (!scene) return tl::unexpected(scene.error());
    notes_ = scene->notes();
    SceneRequest request;
    request.framesPerSecond = framesPerSecond;
    return scene->mesh(request);
  }
  /// Coordinate `axis` of vertex v in every frame.
  std::vector<float> track(const std::string& text, double framesPerSecond, std::size_t v, std::size_t axis) {
    const auto mesh = open(text, framesPerSecond);
    std::vector<float> storage, track;
    EXPECT_TRUE(mesh) << mesh.error().message;
    for (std::int32_t f = 0; mesh && f < mesh->frames->info().frameCount; ++f)
      track.push_back((*mesh->frames->frame(f, storage))[3 * v + axis]);
    return track;
  }

  TemporaryFolder folder_;
  std::vector<std::string> notes_;
  MovedTriangle triangle_;
};

/// Between two keys a second apart, `share` of the way (glTF 2.0, C.5).
float hermite(double from, double leaving, double to, double arriving, double share) {
  const double t = share;
  return static_cast<float>(from * (1 + 2 * t) * (1 - t) * (1 - t) + leaving * t * (1 - t) * (1 - t) +
                            to * t * t * (3 - 2 * t) + arriving * t * t * (t - 1));
}

TEST_F(Interpolated, StepsKeepTheFormerKeyUntilTheNext) {
  const std::string text = triangle_.gltf("translation", "STEP", {0, 0.5, 1}, {0, 0, 0, 5, 0, 0, 7, 0, 0});
  EXPECT_THAT(track(text, 8, 0, 0), testing::ElementsAre(0, 0, 0, 0, 5, 5, 5, 5, 7));
}

TEST_F(Interpolated, LinearStaysWhatItWas) {
  const std::string text = triangle_.gltf("translation", "LINEAR", {0, 1}, {0, 0, 0, 4, 0, 0});
  EXPECT_THAT(track(text, 4, 0, 0), testing::ElementsAre(0, 1, 2, 3, 4));
}

TEST_F(Interpolated, CubicSplinesFollowTheirTangents) {
  // Of each key: the tangent before it, the value, the tangent behind it.
  const std::string text =
      triangle_.gltf("translation", "CUBICSPLINE", {0, 1}, {9, 9, 9, 1, 2, 3, 6, 0, 0, -2, 0, 0, 5, 2, 3, 9, 9, 9});
  const auto x = track(text, 4, 0, 0), y = track(text, 4, 0, 1);
  ASSERT_EQ(x.size(), 5U);
  for (std::size_t f = 0; f < 5; ++f) {
    EXPECT_FLOAT_EQ(x[f], hermite(1, 6, 5, -2, static_cast<double>(f) / 4));
    EXPECT_FLOAT_EQ(y[f], 2);
  }
}

TEST_F(Interpolated, TangentsAreASecond) {
  const std::string text =
      triangle_.gltf("scale", "CUBICSPLINE", {0, 2}, {0, 0, 0, 1, 1, 1, 3, 0, 0, 1, 0, 0, 2, 1, 1, 0, 0, 0});
  const auto x = track(text, 2, 1, 0);  // vertex 1 is at 1 0 0
  ASSERT_EQ(x.size(), 5U);
  for (std::size_t f = 0; f < 5; ++f) EXPECT_FLOAT_EQ(x[f], hermite(1, 2 * 3, 2, 2 * 1, static_cast<double>(f) / 4));
}

TEST_F(Interpolated, CubicRotationsAreMadeUnit) {
  const auto s = static_cast<float>(std::sqrt(0.5));
  // A quarter turn about z, x y z w, without tangents.
  const std::string text = triangle_.gltf("rotation", "CUBICSPLINE", {0, 1},
                                          {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, s, s, 0, 0, 0, 0});
  const auto x = track(text, 4, 1, 0), y = track(text, 4, 1, 1);
  ASSERT_EQ(x.size(), 5U);
  for (std::size_t f = 0; f < 5; ++f) {
    const double share = static_cast<double>(f) / 4;
    const double angle = 2 * std::atan2(hermite(0, 0, s, 0, share), hermite(1, 0, s, 0, share));
    EXPECT_NEAR(x[f], std::cos(angle), 1e-6) << f;
    EXPECT_NEAR(y[f], std::sin(angle), 1e-6) << f;
  }
}

TEST_F(Interpolated, MorphWeightsStepAndCurve) {
  const std::vector<float> values{0, 0.25, 1, 0.5};  // two targets a key
  const std::string steps = triangle_.gltf("weights", "STEP", {0, 1}, values);
  EXPECT_THAT(track(steps, 4, 0, 2), testing::ElementsAre(0, 0, 0, 0, 1));
  EXPECT_THAT(track(steps, 4, 0, 0), testing::ElementsAre(1, 1, 1, 1, 2));
  const std::string curves =
      triangle_.gltf("weights", "CUBICSPLINE", {0, 1}, {9, 9, 0, 0.25, 2, -1, 0, 3, 1, 0.5, 9, 9});
  const auto z = track(curves, 4, 0, 2), x = track(curves, 4, 0, 0);
  ASSERT_EQ(z.size(), 5U);
  for (std::size_t f = 0; f < 5; ++f) {
    EXPECT_FLOAT_EQ(z[f], hermite(0, 2, 1, 0, static_cast<double>(f) / 4));
    EXPECT_FLOAT_EQ(x[f], 4 * hermite(0.25, -1, 0.5, 3, static_cast<double>(f) / 4));
  }
}

TEST_F(Interpolated, NodesWithoutANameAreFound) {
  const std::string text = triangle_.gltf("translation", "STEP", {0, 1}, {0, 0, 0, 5, 0, 0}, "");
  EXPECT_THAT(track(text, 2, 0, 0), testing::ElementsAre(0, 0, 5));
}

TEST_F(Interpolated, WhatCannotBeReadIsPlayedAsLinearAndSaidSo) {
  std::string text = triangle_.gltf("translation", "STEP", {0, 1}, {0, 0, 0, 4, 0, 0});
  const std::string type = R"("type":"VEC3"})";
  text.replace(text.rfind(type), type.size(),
               R"("type":"VEC3","sparse":{"count":1,"indices":{"bufferView":0,"componentType":5123},)"
               R"("values":{"bufferView":1}}})");
  (void)open(text, 4);
  EXPECT_THAT(notes_, testing::Contains(HasSubstr("clip 'go': 1 of its channels are step or cubic")));
  (void)open(triangle_.gltf("translation", "STEP", {0, 1}, {0, 0, 0, 4, 0, 0}), 4);
  EXPECT_THAT(notes_, Not(testing::Contains(HasSubstr("step or cubic"))));
}

TEST_F(Interpolated, KeysThatAreNotFiniteAreNamed) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const std::string interpolation : {"LINEAR", "STEP"}) {
    const auto mesh = open(triangle_.gltf("translation", interpolation, {0, 1, 2}, {0, 0, 0, 0, 0, 0, 0, kNan, 0}), 4);
    ASSERT_FALSE(mesh) << interpolation;
    EXPECT_EQ(mesh.error().code, ErrorCode::invalidFile);
    EXPECT_THAT(mesh.error().message, HasSubstr("moved.gltf: clip 'go', node 'arm'")) << interpolation;
    EXPECT_THAT(mesh.error().message, HasSubstr("key 2 (counted from 0) is not")) << interpolation;
  }
  const auto rotation = open(triangle_.gltf("rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, kNan, 0, 1}), 4);
  EXPECT_THAT(rotation.error().message, HasSubstr("clip 'go', node 'arm', rotation: key 1 (counted from 0) is not"));
  const auto tangent = open(
      triangle_.gltf("scale", "CUBICSPLINE", {0, 1}, {0, 0, 0, 1, 1, 1, 0, 0, 0, kNan, 0, 0, 1, 1, 1, 0, 0, 0}), 4);
  EXPECT_THAT(tangent.error().message, HasSubstr("clip 'go', node 'arm': key 1 (counted from 0) is not finite"));
  const auto weight = open(triangle_.gltf("weights", "LINEAR", {0, 1}, {0, 0, kNan, 0}), 4);
  EXPECT_THAT(weight.error().message, HasSubstr("clip 'go', morph weights of 'arm': key 1"));
  const auto time = open(triangle_.gltf("translation", "LINEAR", {0, kNan}, {0, 0, 0, 1, 1, 1}), 4);
  EXPECT_THAT(time.error().message, HasSubstr("clip 'go', node 'arm', translation: key 1"));
}

}  // namespace
}  // namespace honeycomb::Io::Test
