#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/obj.h"
#include "io/pc2.h"
#include "workplace.h"

namespace honeycomb::Test {
namespace {

class BakeTest : public Workplace {
 protected:
  std::string cacheOf(const std::string& obj, int frames) const { return bentCache("in.pc2", obj, frames); }
  void expectBaked(const std::vector<std::string>& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "");
  }
  /// The positions that `honeycomb refine` gives for the OBJ with other positions.
  std::vector<float> refinedAlone(const std::string& obj, const std::vector<float>& positions,
                                  const std::string& levels, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"refine", file("frame.obj", withPositions(obj, positions)),
                                       path("frame_out.obj"), "--levels", levels};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expectBaked(arguments);
    const auto mesh = Io::readObj(path("frame_out.obj"));
    return {mesh->positions.begin(), mesh->positions.end()};
  }
  std::vector<float> bakedFrame(const std::string& name, int f) const {
    const auto reader = Io::Pc2Reader::open(path(name));
    if (!reader) return {};
    const auto frame = reader->frame(f);
    return {frame->begin(), frame->end()};
  }
};

TEST_F(BakeTest, EachFrameEqualsThatFrameRefinedAlone) {
  const std::string obj = torusObj(10);
  const std::string in = file("torus.obj", obj), frames = cacheOf(obj, 7);
  for (const std::string backend : {"serial", "simd", "tbb"}) {
    expectBaked(
        {"bake", in, path("out.pc2"), "--cache", frames, "--levels", "3", "--backend", backend, "--threads", "3"});
    for (int f = 0; f < 7; ++f)
      EXPECT_TRUE(bakedFrame("out.pc2", f) == refinedAlone(obj, bentFrame(obj, f), "3")) << backend << ", frame " << f;
  }
}

TEST_F(BakeTest, BorderedMeshesBakeAlike) {
  const std::string obj = gridObj(6);
  expectBaked({"bake", file("grid.obj", obj), path("out.pc2"), "--cache", cacheOf(obj, 3), "--levels", "3"});
  for (int f = 0; f < 3; ++f) EXPECT_TRUE(bakedFrame("out.pc2", f) == refinedAlone(obj, bentFrame(obj, f), "3"));
}

TEST_F(BakeTest, EverySchemesFramesEqualThatFrameRefinedAlone) {
  const std::string obj = gridObj(4);
  const std::string in = file("grid.obj", obj), frames = cacheOf(obj, 2);
  const std::vector<std::vector<std::string>> schemes{{"--scheme", "zhang-wang", "--ccv-offset", "0.2"},
                                                      {"--scheme", "half-box"},
                                                      {"--scheme", "zhang-wang:1,half-box:1"}};
  for (const auto& scheme : schemes) {
    std::vector<std::string> arguments{"bake", in, path("out.pc2"), "--cache", frames, "--mesh", path("mesh.obj")};
    arguments.insert(arguments.end(), scheme.begin(), scheme.end());
    expectBaked(arguments);
    for (int f = 1; f >= 0; --f)
      EXPECT_TRUE(bakedFrame("out.pc2", f) == refinedAlone(obj, bentFrame(obj, f), "2", scheme)) << scheme[1] << f;
    EXPECT_EQ(read("mesh.obj"), read("frame_out.obj")) << scheme[1];
  }
}

TEST_F(BakeTest, CentralControlVerticesMoveWithACacheOfTheirOwn) {
  // Points of the mesh double as central control vertices: six of the cube's eight, in other places each frame.
  const std::vector<float> first = bentFrame(cubeObj(), 1), second = bentFrame(cubeObj(), 3);
  std::vector<float> numbers(first.begin(), first.begin() + 18);
  numbers.insert(numbers.end(), second.begin(), second.begin() + 18);
  const std::string in = file("cube.obj", cubeObj()), frames = cacheOf(cubeObj(), 2);
  expectBaked({"bake", in, path("out.pc2"), "--cache", frames, "--scheme", "zhang-wang", "--ccv",
               cache("ccv.pc2", 6, 2, numbers)});
  for (int f = 0; f < 2; ++f) {
    const std::vector<float> centres(numbers.begin() + 18 * f, numbers.begin() + 18 * (f + 1));
    const std::string central = file("centres.obj", withPositions("f ", centres));
    EXPECT_TRUE(bakedFrame("out.pc2", f) ==
                refinedAlone(cubeObj(), bentFrame(cubeObj(), f), "2", {"--scheme", "zhang-wang", "--ccv", central}));
  }
}

TEST_F(BakeTest, HeaderKeepsTheTimesOfTheFramesBaked) {
  const std::string in = file("cube.obj", cubeObj()), frames = cacheOf(cubeObj(), 9);
  expectBaked({"bake", in, path("all.pc2"), "--cache", frames});
  expectBaked({"bake", in, path("some.pc2"), "--cache", frames, "--frames", "3:7"});
  const auto all = Io::Pc2Reader::open(path("all.pc2")), some = Io::Pc2Reader::open(path("some.pc2"));
  ASSERT_TRUE(all && some);
  EXPECT_EQ(all->info().pointCount, 72);
  EXPECT_EQ(all->info().frameCount, 9);
  EXPECT_EQ(all->info().start, 1.5F);
  EXPECT_EQ(all->info().rate, 0.5F);
  EXPECT_EQ(some->info().frameCount, 4);
  EXPECT_EQ(some->info().start, 3.0F);
  for (int f = 3; f < 7; ++f) EXPECT_EQ(bakedFrame("some.pc2", f - 3), bakedFrame("all.pc2", f));
}

TEST_F(BakeTest, OpenRangesReachToTheEnds) {
  const std::string in = file("cube.obj", cubeObj()), frames = cacheOf(cubeObj(), 5);
  for (const auto& [range, count] : {std::pair<std::string, int>{"2:", 3}, {":2", 2}, {":", 5}}) {
    expectBaked({"bake", in, path("out.pc2"), "--cache", frames, "--frames", range});
    EXPECT_EQ(Io::Pc2Reader::open(path("out.pc2"))->info().frameCount, count) << range;
  }
}

TEST_F(BakeTest, MeshIsTheFirstFrameWithTheConnectivity) {
  const std::string obj = torusObj(8);
  expectBaked(
      {"bake", file("torus.obj", obj), path("out.pc2"), "--cache", cacheOf(obj, 3), "--mesh", path("mesh.obj")});
  refinedAlone(obj, bentFrame(obj, 0), "2");
  EXPECT_EQ(read("mesh.obj"), read("frame_out.obj"));
}

TEST_F(BakeTest, CacheIsRemappedWhereVerticesAreDropped) {
  const std::string loose = "v 9 9 9\n" + [] {
    std::string text = cubeObj().substr(0, cubeObj().find('f')) + "v 7 7 7\n";
    return text + "f 2 5 4 3\nf 6 7 8 9\nf 2 3 7 6\nf 3 4 8 7\nf 4 5 9 8\nf 5 2 6 9\n";
  }();
  expectBaked({"bake", file("loose.obj", loose), path("out.pc2"), "--cache", cacheOf(loose, 4), "--drop-isolated"});
  for (int f = 0; f < 4; ++f)
    EXPECT_TRUE(bakedFrame("out.pc2", f) == refinedAlone(cubeObj(), bentFrame(cubeObj(), f), "2")) << f;
}

TEST_F(BakeTest, SequencesAreTheFramesRefinedAlone) {
  const std::string obj = gridObj(4), in = file("grid.obj", obj), frames = cacheOf(obj, 12);
  for (const std::string extension : {"obj", "ply", "glb"}) {
    expectBaked({"bake", in, path("out_%03d." + extension), "--cache", frames, "--frames", "9:12"});
    for (const int f : {9, 10, 11}) {
      const std::string name = (f < 10 ? "out_00" : "out_0") + std::to_string(f) + "." + extension;
      expectBaked({"refine", file("frame.obj", withPositions(obj, bentFrame(obj, f))), path("alone." + extension)});
      EXPECT_TRUE(read(name) == read("alone." + extension)) << name;
    }
  }
}

TEST_F(BakeTest, MddHasTheFramesOfPc2AndTheirTimes) {
  const std::string in = file("cube.obj", cubeObj()), frames = cacheOf(cubeObj(), 4);
  expectBaked({"bake", in, path("out.pc2"), "--cache", frames, "--frames", "1:4"});
  expectBaked({"bake", in, path("out.mdd"), "--cache", frames, "--frames", "1:4"});
  const std::string pc2 = read("out.pc2"), mdd = read("out.mdd");
  ASSERT_EQ(mdd.size(), 8U + 3 * 4 + (pc2.size() - 32));
  const auto word = [&mdd](std::size_t offset) {
    return std::string(mdd.rbegin() + static_cast<std::ptrdiff_t>(mdd.size() - offset - 4),
                       mdd.rbegin() + static_cast<std::ptrdiff_t>(mdd.size() - offset));
  };
  const auto bytes = [](auto value) { return std::string(reinterpret_cast<const char*>(&value), 4); };
  EXPECT_EQ(word(0), bytes(3));
  EXPECT_EQ(word(4), bytes(72));
  for (std::size_t f = 0; f < 3; ++f)  // the cache begins at 1.5 and goes on by 0.5, at 24 frames a second
    EXPECT_EQ(word(8 + 4 * f), bytes((2.0F + 0.5F * static_cast<float>(f)) / 24)) << f;
  for (std::size_t i = 0; 32 + i < pc2.size(); i += 4) ASSERT_EQ(word(20 + i), pc2.substr(32 + i, 4)) << i;
}

TEST_F(BakeTest, GlbHasAMorphTargetAFrame) {
  const std::string obj = torusObj(8), in = file("torus.obj", obj), frames = cacheOf(obj, 6);
  expectBaked({"bake", in, path("out.glb"), "--cache", frames});
  expectBaked({"bake", in, path("out.pc2"), "--cache", frames});
  const std::string glb = read("out.glb");
  std::uint32_t jsonBytes = 0;
  std::memcpy(&jsonBytes, glb.data() + 12, 4);
  const auto json = nlohmann::json::parse(glb.substr(20, jsonBytes));
  const auto& targets = json["meshes"][0]["primitives"][0]["targets"];
  ASSERT_EQ(targets.size(), 5U);
  const std::vector<float> first = bakedFrame("out.pc2", 0), fourth = bakedFrame("out.pc2", 3);
  const auto& accessor = json["accessors"][targets[2]["POSITION"].get<std::size_t>()];
  const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  std::vector<float> differences(first.size());
  std::memcpy(
      differences.data(),
      glb.data() + 28 + jsonBytes + view["byteOffset"].get<std::size_t>() + accessor["byteOffset"].get<std::size_t>(),
      4 * differences.size());
  for (std::size_t i = 0; i < first.size(); ++i) ASSERT_EQ(differences[i], fourth[i] - first[i]) << i;
}

TEST_F(BakeTest, MeshesBesideAreOfAnyKind) {
  const std::string in = file("cube.obj", cubeObj()), frames = cacheOf(cubeObj(), 2);
  for (const std::string name : {"mesh.ply", "mesh.glb"}) {
    expectBaked({"bake", in, path("out.pc2"), "--cache", frames, "--mesh", path(name)});
    expectBaked({"refine", in, path("alone" + name)});  // frame 0 is the cube itself
    EXPECT_TRUE(read(name) == read("alone" + name)) << name;
  }
}

TEST_F(BakeTest, JsonSummaryCountsFrames) {
  const std::string in = file("cube.obj", cubeObj());
  const Outcome outcome = run({"bake", in, path("out.pc2"), "--cache", cacheOf(cubeObj(), 5), "--json"});
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("frames"), 5);
  EXPECT_EQ(json.at("vertices"), 72);
}

}  // namespace
}  // namespace honeycomb::Test
