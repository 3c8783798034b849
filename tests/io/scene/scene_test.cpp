#include "io/scene/scene.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "far/topology/topology.h"
#include "tests/io/files.h"
#include "tests/io/scene/characters.h"
#include "tests/support/random.h"

namespace honeycomb::Io::Test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

class CharacterFile : public testing::Test {
 protected:
  CharacterFile() { writeBytes(path(), text_); }
  std::filesystem::path path() const { return folder_ / "character.gltf"; }
  Scene open() const {
    Result<Scene> scene = Scene::open(path());
    EXPECT_TRUE(scene) << scene.error().message;
    return *std::move(scene);
  }
  SceneMesh mesh(const SceneRequest& request) const {
    Result<SceneMesh> mesh = open().mesh(request);
    EXPECT_TRUE(mesh) << mesh.error().message;
    return *std::move(mesh);
  }
  std::string refusal(const SceneRequest& request) const {
    const auto mesh = open().mesh(request);
    return mesh ? "accepted" : mesh.error().message;
  }
  /// The error of opening a changed file.
  std::string refusalOf(const std::string& what, const std::string& by) const {
    std::string changed = text_;
    const std::size_t place = changed.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    writeBytes(path(), changed.replace(place, what.size(), by));
    const auto scene = Scene::open(path());
    return scene ? "accepted" : scene.error().message;
  }

  TemporaryFolder folder_;
  std::string text_ = Character::gltf();
};

/// The corner of the box at a moment, from the formulas of glTF alone: joints as complex numbers in the plane z =
/// const.
std::array<double, 3> bentCorner(int c, double seconds) {
  const double share = seconds / Character::kSeconds;
  std::array<double, 3> p = Character::corner(c);
  for (std::size_t i = 0; i < 3; ++i) p[i] += share * Character::morph(c)[i];
  std::array<double, 3> sum{};
  double turned = 0, x = 0, y = 0, bound = 0;  // the joint's global place, and where it was bound
  for (int k = 0; k < Character::kJoints; ++k) {
    const double along = Character::bindShift(k), across = share * Character::shift(k);
    x += along * std::cos(turned) - across * std::sin(turned);
    y += along * std::sin(turned) + across * std::cos(turned);
    turned += share * Character::angle(k);
    bound += along;
    const double dx = p[0] - bound, dy = p[1], w = Character::weight(c, k);
    sum[0] += w * (x + dx * std::cos(turned) - dy * std::sin(turned));
    sum[1] += w * (y + dx * std::sin(turned) + dy * std::cos(turned));
    sum[2] += w * p[2];
  }
  return sum;
}

int cornerAt(const Mesh& mesh, std::int64_t v) {
  const auto p = mesh.position(v);
  return static_cast<int>(std::lround(p[0]) + 2 * std::lround(p[1]) + 4 * std::lround(p[2]));
}

TEST_F(CharacterFile, ListsClipsAndNodes) {
  const Scene scene = open();
  ASSERT_THAT(scene.clips(), SizeIs(1));
  EXPECT_EQ(scene.clips()[0].name, "bend");
  EXPECT_DOUBLE_EQ(scene.clips()[0].seconds, 2);
  ASSERT_THAT(scene.nodes(), SizeIs(1));
  EXPECT_EQ(scene.nodes()[0].name, "body");
  EXPECT_EQ(scene.nodes()[0].vertices, 36);
  EXPECT_EQ(scene.nodes()[0].faces, 12);
  EXPECT_TRUE(scene.nodes()[0].skinned);
  EXPECT_TRUE(scene.nodes()[0].morphed);
}

TEST_F(CharacterFile, WeldedSeamsMakeAClosedManifold) {
  for (const double tolerance : {0.0, 1e-6}) {
    SceneRequest request;
    request.weld = tolerance;
    const SceneMesh welded = mesh(request);
    EXPECT_EQ(welded.fileVertices, 36);
    EXPECT_EQ(welded.mesh.polygons.vertexCount, 8);
    const auto topology = Far::Topology::create(welded.mesh.polygons);
    ASSERT_TRUE(topology) << topology.error().message;
    EXPECT_EQ(topology->edgeCount(), 18);
    EXPECT_EQ(topology->eulerCharacteristic(), 2);
  }
}

TEST_F(CharacterFile, CornersKeepTextureCoordinatesAcrossSeams) {
  const Mesh mesh = this->mesh({}).mesh;
  ASSERT_THAT(mesh.cornerTexcoords, SizeIs(36));
  // A triangle of a quad has three of the four corners of the unit square, and v runs upwards.
  for (std::size_t c = 0; c < 36; ++c) {
    const std::size_t k = std::array<std::size_t, 6>{0, 1, 2, 0, 2, 3}[c % 6];
    const auto uv = static_cast<std::size_t>(mesh.cornerTexcoords[c]);
    EXPECT_EQ(mesh.texcoords[2 * uv], k == 1 || k == 2 ? 1 : 0) << c;
    EXPECT_EQ(mesh.texcoords[2 * uv + 1], k >= 2 ? 0 : 1) << c;
  }
}

TEST_F(CharacterFile, FiveInfluencesAndAMorphTargetMoveTheCorners) {
  SceneRequest request;
  request.framesPerSecond = 8;
  const SceneMesh bent = mesh(request);
  ASSERT_EQ(bent.frames->info().frameCount, 17);
  EXPECT_EQ(bent.frames->info().framesPerSecond, 8);
  std::vector<float> storage;
  for (const std::int32_t f : {0, 5, 16}) {
    const auto frame = bent.frames->frame(f, storage);
    ASSERT_TRUE(frame) << frame.error().message;
    for (std::int64_t v = 0; v < 8; ++v) {
      const std::array<double, 3> expected = bentCorner(cornerAt(bent.mesh, v), f / 8.0);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR((*frame)[3 * static_cast<std::size_t>(v) + i], expected[i], 2e-6) << f << " " << v;
    }
  }
  EXPECT_THAT(bent.frames->frame(17, storage).error().message, HasSubstr("has no frame 17; name one of 0 to 16"));
}

TEST_F(CharacterFile, FramesAreTheSameFromManyThreads) {
  const SceneMesh bent = mesh({});
  std::vector<std::vector<float>> alone(20), together(20);
  for (std::size_t f = 0; f < 20; ++f) EXPECT_TRUE(bent.frames->frame(static_cast<std::int32_t>(f), alone[f]));
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (std::size_t f = t; f < 20; f += 4) (void)bent.frames->frame(static_cast<std::int32_t>(f), together[f]);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(alone, together);
}

TEST_F(CharacterFile, UnknownClipsAndNodesListThoseThereAre) {
  SceneRequest request;
  request.clip = "walk";
  EXPECT_THAT(refusal(request), HasSubstr("has no clip 'walk'; choose from: 'bend'"));
  request.clip = "bend";
  request.node = "joint1";
  EXPECT_THAT(refusal(request), HasSubstr("has no node 'joint1' with a mesh on it or below; choose from: 'body'"));
  request.node = "body";
  EXPECT_EQ(refusal(request), "accepted");
  request.framesPerSecond = 0;
  EXPECT_THAT(refusal(request), HasSubstr("give a positive rate"));
  request.framesPerSecond = 24;
  request.weld = -1;
  EXPECT_THAT(refusal(request), HasSubstr("give 0 to 1"));
}

TEST_F(CharacterFile, WhatIsWrongIsNamed) {
  EXPECT_THAT(refusalOf(R"("inverseBindMatrices":)", R"("others":)"), HasSubstr("skin 0: has no inverseBindMatrices"));
  EXPECT_THAT(refusalOf(R"("children":[2])", R"("children":[99])"),
              HasSubstr("node 1: a child is not one of the nodes"));
  EXPECT_THAT(refusalOf(R"("children":[2])", R"("children":[1])"), HasSubstr("has another parent"));
  EXPECT_THAT(refusalOf(R"("meshes":[)", R"("mushes":[)"), HasSubstr("node 0: its mesh is not one of the meshes"));
  EXPECT_THAT(refusalOf(R"("count":36)", R"("count":37)"), HasSubstr("accessor 0: reaches past its bufferView"));
  EXPECT_THAT(refusalOf(R"("type":"VEC3"})", R"("type":"VEC3","sparse":{}})"),
              HasSubstr("accessor 0: its sparse part"));
  EXPECT_THAT(refusalOf(R"({"asset")", R"(["asset")"), HasSubstr("its JSON can't be understood"));
  writeBytes(path(), "v 0 0 0");
  EXPECT_THAT(Scene::open(path()).error().message, HasSubstr("begins as no .gltf file does"));
}

// Two triangles along an edge: of its two vertices, each twice in the file, one has two colours.
TEST_F(CharacterFile, JoinedVerticesKeepTheFirstOfTheirColours) {
  GltfBuilder file;
  const auto text = [](int number) { return std::to_string(number); };
  const std::string points = text(file.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3", 3));
  const std::string colours = text(file.floats({1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, "VEC3", 3));
  writeBytes(path(), file.file(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
                               R"({"attributes":{"POSITION":)" +
                               points + R"(,"COLOR_0":)" + colours + "}}]}]"));
  const SceneMesh joined = mesh({});
  EXPECT_EQ(joined.mesh.polygons.vertexCount, 4);
  EXPECT_THAT(joined.mesh.colours, ElementsAre(1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 0));
  EXPECT_THAT(joined.notes, testing::Contains("1 joined vertices had another colour; the first of each is kept"));
}

// Assimp is handed whatever passes our own checks.
TEST_F(CharacterFile, FilesWithFlippedBytesAreReadOrRefused) {
  honeycomb::Test::Random random(11);
  for (int i = 0; i < 300; ++i) {
    std::string bytes = text_;
    for (std::size_t k = random.between(1, 4); k > 0; --k) {
      const std::size_t place = random.below(bytes.size());
      bytes[place] = random.chance(0.5) ? bytes[random.below(bytes.size())] : static_cast<char>('0' + random.below(10));
    }
    writeBytes(path(), bytes);
    const auto scene = Scene::open(path());
    if (!scene) continue;
    const auto mesh = scene->mesh({});
    std::vector<float> storage;
    if (mesh && mesh->frames) (void)mesh->frames->frame(0, storage);
  }
}

}  // namespace
}  // namespace honeycomb::Io::Test
