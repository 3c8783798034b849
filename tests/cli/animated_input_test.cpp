#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/pc2.h"
#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;
constexpr std::size_t kPc2Header = 32;  // names times of its own

/// Meshes that bring their animation along.
class AnimatedInputTest : public Workplace {
 protected:
  static void expectDone(const std::vector<std::string>& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  }
  std::vector<float> bentFrames(const std::string& obj, int frames) const {
    std::vector<float> numbers;
    for (int f = 0; f < frames; ++f)
      for (const float number : bentFrame(obj, f)) numbers.push_back(number);
    return numbers;
  }
};

TEST_F(AnimatedInputTest, ASequenceIsBakedAsThePointCacheOfItsFrames) {
  const std::string obj = torusObj(4);
  for (int f = 0; f < 3; ++f) (void)file("f" + std::to_string(7 + f) + ".obj", withPositions(obj, bentFrame(obj, f)));
  const std::string in = file("torus.obj", obj);
  const auto numbers = bentFrames(obj, 3);
  const std::string frames = cache("in.pc2", static_cast<std::int32_t>(numbers.size() / 9), 3, numbers);
  expectDone({"bake", in, path("cache_out.pc2"), "--cache", frames, "--levels", "1"});
  for (const std::string pattern : {"f%d.obj", "f*.obj"}) {
    expectDone({"bake", path(pattern), path("out.pc2"), "--levels", "1"});
    EXPECT_TRUE(read("out.pc2").substr(kPc2Header) == read("cache_out.pc2").substr(kPc2Header)) << pattern;
  }
}

TEST_F(AnimatedInputTest, SequencesWithGapsOrOtherFacesAreRefused) {
  (void)file("f1.obj", cubeObj());
  (void)file("f3.obj", gridObj(2));
  (void)file("f4.obj", cubeObj());
  EXPECT_REFUSED((std::vector<std::string>{"bake", path("f%d.obj"), path("out.pc2")}),
                 HasSubstr("1 frame of the sequence is missing: f2.obj"));
  (void)file("f2.obj", cubeObj());
  EXPECT_REFUSED((std::vector<std::string>{"bake", path("f%d.obj"), path("out.pc2")}),
                 HasSubstr("f3.obj: frame 2 (counted from 0) has 9 vertices, not 8 as"));
}

// Three triangles on one edge, and a vertex of no face: the cache has five points, the mesh eight.
TEST_F(AnimatedInputTest, DuplicatesOfVerticesMoveAsTheyDo) {
  const std::string in =
      file("fan.obj", "v 0 0 0\nv 1 0 0\nv 9 9 9\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 4\nf 2 1 5\nf 1 2 6\n");
  std::vector<float> numbers{0, 0, 0, 1, 0, 0, 9, 9, 9, 0, 1, 0, 0, -1, 0, 0, 0, 1};
  for (std::size_t i = 0; i < 18; ++i) numbers.push_back(numbers[i] + (i % 3 == 2 ? 5.0F : 0.0F));
  const std::string frames = cache("in.pc2", 6, 2, numbers);
  EXPECT_REFUSED((std::vector<std::string>{"bake", in, path("out.pc2"), "--cache", frames}),
                 HasSubstr("face 3 is the third on the edge between vertices 1 and 2"));
  expectDone({"bake", in, path("out.pc2"), "--cache", frames, "--split-nonmanifold", "--drop-isolated", "--levels", "1",
              "--boundary", "brick"});
  const auto baked = Io::Pc2Reader::open(path("out.pc2"));
  ASSERT_TRUE(baked) << baked.error().message;
  const auto still = baked->frame(0), moved = baked->frame(1);
  for (std::size_t i = 0; i < still->size(); ++i)
    EXPECT_NEAR((*moved)[i], (*still)[i] + (i % 3 == 2 ? 5.0F : 0.0F), 1e-5F);
  const auto info = nlohmann::json::parse(run({"info", in, "--split-nonmanifold", "--drop-isolated", "--json"}).out);
  EXPECT_EQ(info["vertices"], 9);
  EXPECT_EQ(info["dropped_vertices"], 1);
  EXPECT_THAT(info["notes"][0].get<std::string>(),
              HasSubstr("4 duplicates of vertices made it a manifold: 1 edge cut, 0 bow-ties parted"));
}

// Nobody says how fast they are: 24 frames a second.
TEST_F(AnimatedInputTest, PointCachesAndSequencesAreBakedAtAnyRate) {
  const std::string obj = torusObj(4), in = file("torus.obj", obj);
  for (int f = 0; f < 3; ++f) (void)file("f" + std::to_string(f) + ".obj", withPositions(obj, bentFrame(obj, f)));
  const std::string frames = cache("in.pc2", 16, 3, bentFrames(obj, 3));
  std::vector<float> between = bentFrame(obj, 0), later = bentFrame(obj, 1);
  for (std::size_t i = 0; i < between.size(); ++i)
    between[i] = static_cast<float>(0.5 * double{between[i]} + 0.5 * double{later[i]});
  const std::string half = cache("half.pc2", 16, 1, between);
  expectDone({"bake", in, path("half_out.pc2"), "--cache", half, "--levels", "1"});
  expectDone({"bake", in, path("whole_out.pc2"), "--cache", frames, "--levels", "1"});
  for (const std::vector<std::string>& from : {std::vector<std::string>{in, "--cache", frames}, {path("f%d.obj")}}) {
    std::vector<std::string> arguments{"bake", path("out.pc2"), "--levels", "1", "--fps", "48"};
    arguments.insert(arguments.begin() + 1, from.begin(), from.end());
    if (from.size() > 1) std::rotate(arguments.begin() + 2, arguments.begin() + 4, arguments.begin() + 5);
    expectDone(arguments);
    const std::string out = read("out.pc2"), whole = read("whole_out.pc2");
    const std::size_t bytes = (whole.size() - kPc2Header) / 3;
    ASSERT_EQ(out.size(), kPc2Header + 5 * bytes) << "0 to 2 in halves";
    EXPECT_TRUE(out.substr(kPc2Header, bytes) == whole.substr(kPc2Header, bytes));
    EXPECT_TRUE(out.substr(kPc2Header + bytes, bytes) == read("half_out.pc2").substr(kPc2Header));
    EXPECT_TRUE(out.substr(kPc2Header + 4 * bytes) == whole.substr(kPc2Header + 2 * bytes));
  }
  EXPECT_REFUSED((std::vector<std::string>{"bake", in, path("no.pc2"), "--cache", frames, "--fps", "0"}),
                 HasSubstr("in.pc2: 0 frames a second of 3 frames made at 24: give a positive rate"));
}

TEST_F(AnimatedInputTest, QuadsComeBackFromTheirTriangles) {
  const std::string in = file("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  EXPECT_EQ(nlohmann::json::parse(run({"info", in, "--json"}).out)["sides"], (nlohmann::json{{"3", 2}}));
  EXPECT_EQ(nlohmann::json::parse(run({"info", in, "--quads", "--json"}).out)["sides"], (nlohmann::json{{"4", 1}}));
}

TEST_F(AnimatedInputTest, WhatOnlyScenesHaveIsRefusedOfOthers) {
  const std::string in = file("cube.obj", cubeObj());
  EXPECT_REFUSED((std::vector<std::string>{"refine", in, path("out.obj"), "--clip", "walk"}),
                 HasSubstr("--clip: is for scenes (.gltf, "));
  EXPECT_REFUSED((std::vector<std::string>{"refine", in, path("out.obj"), "--weld", "0"}), HasSubstr("--weld: is for"));
}

}  // namespace
}  // namespace honeycomb::Test
