#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "far/topology/topology.h"
#include "io/scene/scene.h"
#include "tests/io/files.h"

namespace honeycomb::Io::Test {
namespace {

using testing::HasSubstr;
using Point = std::array<double, 3>;

/// Assimp's own models, which the set-up installs.
class AssimpModels : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kFolder)) GTEST_SKIP() << kFolder << " is missing: run ./setup";
  }
  static std::string path(const std::string& name) { return std::string(kFolder) + "/" + name; }
  static SceneMesh mesh(const std::string& name, const SceneRequest& request = {}) {
    const Result<Scene> scene = Scene::open(path(name));
    EXPECT_TRUE(scene) << scene.error().message;
    Result<SceneMesh> mesh = scene->mesh(request);
    EXPECT_TRUE(mesh) << mesh.error().message;
    return *std::move(mesh);
  }
  static std::vector<Point> frame(const SceneMesh& mesh, std::int32_t f) {
    std::vector<float> storage;
    const auto points = mesh.frames->frame(f, storage);
    EXPECT_TRUE(points) << points.error().message;
    std::vector<Point> result;
    for (std::size_t i = 0; i < points->size(); i += 3)
      result.push_back({(*points)[i], (*points)[i + 1], (*points)[i + 2]});
    return result;
  }
  static double distance(const std::vector<Point>& points, const Point& p) {
    double nearest = INFINITY;
    for (const Point& q : points) nearest = std::min(nearest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    return nearest;
  }

  static constexpr const char* kFolder = "/usr/share/assimp/models";
};

// The upper joint of the sample stands at (0, 1, 0) and has turned by 90 degrees after one second.
TEST_F(AssimpModels, SimpleSkinBends) {
  SceneRequest request;
  request.framesPerSecond = 1;
  const SceneMesh skin = mesh("glTF2/simple_skin/simple_skin.gltf", request);
  EXPECT_EQ(skin.frames->info().frameCount, 6);
  const std::vector<Point> straight = frame(skin, 0), bent = frame(skin, 1);
  for (const Point& p : {Point{0.5, 0, 0}, Point{-0.5, 0, 0}, Point{0.5, 2, 0}, Point{-0.5, 2, 0}})
    EXPECT_LT(distance(straight, p), 1e-6);
  for (const Point& p : {Point{0.5, 0, 0}, Point{-0.5, 0, 0}, Point{-1, 1.5, 0}, Point{-1, 0.5, 0}})
    EXPECT_LT(distance(bent, p), 1e-6);
}

/// The floats of an accessor, as the file has them.
std::vector<float> accessorOf(const nlohmann::json& gltf, const std::string& bin, int index) {
  const auto& accessor = gltf["accessors"][static_cast<std::size_t>(index)];
  const auto& view = gltf["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  const std::size_t offset = view.value("byteOffset", 0U) + accessor.value("byteOffset", 0U);
  std::vector<float> values(accessor["count"].get<std::size_t>() * (accessor["type"] == "VEC3" ? 3 : 1));
  std::memcpy(values.data(), bin.data() + offset, values.size() * sizeof(float));
  return values;
}

// Every vertex, at a key of the weights' animation: base + w0 offset0 + w1 offset1, by 100, turned as the node is.
TEST_F(AssimpModels, MorphCubeFollowsItsWeights) {
  const std::string folder = "glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube";
  const auto gltf = nlohmann::json::parse(readBytes(path(folder + ".gltf")));
  const std::string bin = readBytes(path(folder + ".bin"));
  const auto& sampler = gltf["animations"][0]["samplers"][0];
  const auto times = accessorOf(gltf, bin, sampler["input"]), weights = accessorOf(gltf, bin, sampler["output"]);
  const auto& primitive = gltf["meshes"][0]["primitives"][0];
  const auto base = accessorOf(gltf, bin, primitive["attributes"]["POSITION"]);
  const auto first = accessorOf(gltf, bin, primitive["targets"][0]["POSITION"]);
  const auto second = accessorOf(gltf, bin, primitive["targets"][1]["POSITION"]);
  SceneRequest request;
  request.framesPerSecond = 30;  // that of its keys
  const SceneMesh cube = mesh(folder + ".gltf", request);
  EXPECT_EQ(cube.mesh.polygons.vertexCount, 8);
  for (const std::size_t f : {0U, 30U, 60U, 99U}) {
    ASSERT_NEAR(times[f], static_cast<double>(f) / 30, 1e-5);
    const std::vector<Point> points = frame(cube, static_cast<std::int32_t>(f));
    for (std::size_t v = 0; v < base.size(); v += 3) {
      Point p;
      for (std::size_t i = 0; i < 3; ++i)
        p[i] = 100.0 * (base[v + i] + weights[2 * f] * first[v + i] + weights[2 * f + 1] * second[v + i]);
      // The quaternion (0, r, -r, 0) turns by 180 degrees about (0, 1, -1): x, y, z to -x, -z, -y.
      EXPECT_LT(distance(points, {-p[0], -p[2], -p[1]}), 1e-4) << f << " " << v / 3;
    }
  }
}

TEST_F(AssimpModels, FbxAndColladaCharactersWeldToClosedMeshes) {
  for (const char* name : {"FBX/animation_with_skeleton.fbx", "FBX/huesitos.fbx", "Collada/box_nested_animation.dae"}) {
    const SceneMesh character = mesh(name);
    const auto topology = Far::Topology::create(character.mesh.polygons);
    ASSERT_TRUE(topology) << name << ": " << topology.error().message;
    EXPECT_EQ(topology->boundaryEdgeCount(), 0) << name;
    EXPECT_EQ(topology->eulerCharacteristic(), 2) << name;
    ASSERT_TRUE(character.frames) << name;
    EXPECT_NE(frame(character, 0), frame(character, character.frames->info().frameCount - 1)) << name;
  }
}

TEST_F(AssimpModels, DamagedColladaIsReadOrRefused) {
  std::ifstream file(path("Collada/box_nested_animation.dae"), std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  const TemporaryFolder folder;
  std::mt19937 random(5);
  for (int damage = 0; damage < 60; ++damage) {
    std::string bytes = whole;
    for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] = static_cast<char>(random() % 128);
    std::ofstream(folder / "box.dae", std::ios::binary) << bytes;
    const Result<Scene> scene = Scene::open(folder / "box.dae");
    if (scene) continue;
    EXPECT_THAT(scene.error().message, HasSubstr("box.dae")) << damage;
  }
}

TEST_F(AssimpModels, MissingBonesAndMissingMeshesAreNamed) {
  EXPECT_THAT(Scene::open(path("X/anim_test.x")).error().message,
              HasSubstr("mesh 'pCylinder1': its skin names the bone 'joint3', which no node is called"));
  EXPECT_THAT(Scene::open(path("glTF2/TestNoRootNode/SceneWithoutNodes.gltf")).error().message,
              HasSubstr("has no mesh; give a file with faces"));
  EXPECT_THAT(Scene::open(path("glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb")).error().message,
              HasSubstr("vertex 0 (counted from 0) is not finite"));
  EXPECT_THAT(Scene::open(path("glTF2/MissingBin/BoxTextured.gltf")).error().message, HasSubstr("BoxTextured0.bin"));
}

}  // namespace
}  // namespace honeycomb::Io::Test
