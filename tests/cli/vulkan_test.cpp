#include <cstdlib>
#include <nlohmann/json.hpp>

#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

const RunOptions kNoDevice{{{"VK_ICD_FILENAMES", "/nonexistent"}, {"VK_DRIVER_FILES", "/nonexistent"}}, -1};

class VulkanBackendTest : public Workplace {
 protected:
  /// More frames than are on their way at once.
  static constexpr int kFrames = 8;
  std::vector<float> bentFrames(const std::string& obj) const {
    std::vector<float> numbers;
    for (int f = 0; f < kFrames; ++f)
      for (const float number : bentFrame(obj, f)) numbers.push_back(number);
    return numbers;
  }
  std::string frames(const std::string& obj, int points) const {
    return cache("in.pc2", points, kFrames, bentFrames(obj));
  }
  bool hasDevice() const { return !nlohmann::json::parse(run({"info", "--json"}).out).at("vulkan_devices").empty(); }
};

TEST_F(VulkanBackendTest, WithoutADeviceOneLineSaysWhatToDo) {
  const std::string in = file("cube.obj", cubeObj());
  const Outcome outcome = run({"refine", in, path("out.obj"), "--backend", "vulkan"}, kNoDevice);
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(outcome.err)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("Vulkan"));
  EXPECT_THAT(outcome.err, HasSubstr("--backend tbb"));
  EXPECT_THAT(listing(), testing::ElementsAre("cube.obj"));
}

TEST_F(VulkanBackendTest, AutoNeedsNoDevice) {
  const Outcome outcome = run({"refine", file("cube.obj", cubeObj()), path("out.obj")}, kNoDevice);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(VulkanBackendTest, InfoSaysThatThereIsNoDevice) {
  const Outcome outcome = run({"info", "--json"}, kNoDevice);
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_TRUE(nlohmann::json::parse(outcome.out).at("vulkan_devices").empty());
}

TEST_F(VulkanBackendTest, FilesAreTheSameAsTheCpus) {
  if (!hasDevice()) GTEST_SKIP() << "no Vulkan device";
  for (const std::string& in : {file("torus.obj", torusObj(20)), file("grid.obj", gridObj(7))}) {
    for (const std::string backend : {"serial", "vulkan"}) {
      const Outcome outcome =
          run({"refine", in, path(backend + ".obj"), "--levels", "4", "--normals", "exact", "--backend", backend});
      EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
      EXPECT_EQ(outcome.err, "");
    }
    EXPECT_TRUE(read("serial.obj") == read("vulkan.obj")) << in;
  }
}

TEST_F(VulkanBackendTest, EverySchemesFilesAreTheSameAsTheCpus) {
  if (!hasDevice()) GTEST_SKIP() << "no Vulkan device";
  const std::string in = file("grid.obj", gridObj(4));
  const std::vector<std::vector<std::string>> schemes{
      {"--scheme", "zhang-wang", "--ccv-offset", "0.3", "--normals", "exact"},
      {"--scheme", "half-box", "--normals", "exact"},
      {"--scheme", "half-box", "--normals", "fast"},
      {"--scheme", "zhang-wang", "--ccv-offset", "0.3", "--normals", "fast"},
      {"--scheme", "half-box", "--levels", "0", "--tessellate", "2", "--normals", "exact"},
      {"--scheme", "midpoint:1,trisect:1,zhang-wang:1,centroid:1,doo-sabin:1"}};
  for (const auto& scheme : schemes) {
    for (const std::string backend : {"serial", "vulkan"}) {
      std::vector<std::string> arguments{"refine", in, path(backend + ".obj"), "--backend", backend};
      arguments.insert(arguments.end(), scheme.begin(), scheme.end());
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
      EXPECT_EQ(outcome.err, "");
    }
    EXPECT_TRUE(read("serial.obj") == read("vulkan.obj")) << scheme[1];
  }
}

TEST_F(VulkanBackendTest, BakesAreTheSameAsTheCpus) {
  if (!hasDevice()) GTEST_SKIP() << "no Vulkan device";
  const std::string in = file("torus.obj", torusObj(12)), cacheFile = frames(torusObj(12), 144);
  for (const std::string backend : {"tbb", "vulkan"}) {
    const Outcome outcome =
        run({"bake", in, path(backend + ".pc2"), "--cache", cacheFile, "--levels", "3", "--backend", backend});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
  }
  EXPECT_TRUE(read("tbb.pc2") == read("vulkan.pc2"));
}

TEST_F(VulkanBackendTest, PartsOfAnAnimationAndItsMeshAreTheSameAsTheCpus) {
  if (!hasDevice()) GTEST_SKIP() << "no Vulkan device";
  const std::string in = file("torus.obj", torusObj(12)), cacheFile = frames(torusObj(12), 144);
  for (const std::string range : {"1:2", "2:4", "1:8"}) {
    for (const std::string backend : {"tbb", "vulkan"}) {
      const Outcome outcome = run({"bake", in, path(backend + ".pc2"), "--cache", cacheFile, "--levels", "2", "--mesh",
                                   path(backend + ".obj"), "--frames", range, "--backend", backend});
      EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    }
    EXPECT_TRUE(read("tbb.pc2") == read("vulkan.pc2")) << range;
    EXPECT_TRUE(read("tbb.obj") == read("vulkan.obj")) << range;
  }
}

TEST_F(VulkanBackendTest, ABakeHasSeveralFramesOnTheirWay) {
  if (!hasDevice()) GTEST_SKIP() << "no Vulkan device";
  const std::string in = file("torus.obj", torusObj(12)), cacheFile = frames(torusObj(12), 144);
  const Outcome outcome = run({"bake", in, path("out.pc2"), "--cache", cacheFile, "--backend", "vulkan", "--json"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("frames_at_once"), 3);
}

TEST_F(VulkanBackendTest, TheFirstFrameThatOverflowsIsNamed) {
  if (!hasDevice()) GTEST_SKIP() << "no Vulkan device";
  const std::string in = file("torus.obj", torusObj(12));
  std::vector<float> numbers = bentFrames(torusObj(12));
  for (const int frame : {3, 4}) {
    for (std::size_t i = 0; i < 432; ++i) numbers[static_cast<std::size_t>(frame) * 432 + i] = 3e38F;
  }
  const std::string cacheFile = cache("in.pc2", 144, kFrames, numbers);
  std::vector<std::string> errors;
  for (const std::string backend : {"tbb", "vulkan"}) {
    const Outcome outcome = run({"bake", in, path("out.pc2"), "--cache", cacheFile, "--backend", backend});
    EXPECT_EQ(outcome.exitCode, 1);
    errors.push_back(outcome.err);
  }
  EXPECT_THAT(errors[1], HasSubstr("frame 3"));
  EXPECT_EQ(errors[0], errors[1]);
}

TEST_F(VulkanBackendTest, PipelinesAreKeptInTheUsersCache) {
  if (!hasDevice()) GTEST_SKIP() << "no Vulkan device";
  const std::string in = file("cube.obj", cubeObj());
  const RunOptions options{{{"XDG_CACHE_HOME", path("cache")}}, -1};
  for (int start = 0; start < 2; ++start) {
    const Outcome outcome = run({"refine", in, path("out.obj"), "--backend", "vulkan"}, options);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    std::vector<std::string> kept;
    for (const auto& entry : std::filesystem::directory_iterator(path("cache/honeycomb")))
      kept.push_back(entry.path().filename().string());
    EXPECT_THAT(kept, testing::ElementsAre(testing::StartsWith("pipelines-")));
  }
}

TEST_F(VulkanBackendTest, ACacheThatCantBeWrittenGoesUnmentioned) {
  if (!hasDevice()) GTEST_SKIP() << "no Vulkan device";
  const std::string in = file("cube.obj", cubeObj());
  std::filesystem::create_directories(path("cache"));
  file("cache/honeycomb", "no folder");
  const Outcome outcome =
      run({"refine", in, path("out.obj"), "--backend", "vulkan"}, RunOptions{{{"XDG_CACHE_HOME", path("cache")}}, -1});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(VulkanBackendTest, BenchSaysWhatEachLevelTakes) {
  if (!hasDevice()) GTEST_SKIP() << "no Vulkan device";
  const Outcome outcome = run({"bench", "--faces", "64", "--levels", "3", "--evaluators", "serial,vulkan,vulkan-csr",
                               "--layouts", "xyz", "--samples", "3", "--sample-ms", "1", "--json", path("bench.json")});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::ContainsRegex("of which level 1 [0-9.]+ ms, level 2 [0-9.]+ ms, level 3"));
  const nlohmann::json report = nlohmann::json::parse(read("bench.json"));
  for (const nlohmann::json& one : report.at("runs")) {
    ASSERT_EQ(one.contains("host_us"), one.at("evaluator") != "serial");
    if (one.contains("host_us")) {
      EXPECT_GT(one.at("host_us").at("record").at("median"), 0);
      EXPECT_GT(one.at("host_us").at("submit").at("median"), 0);
    }
    ASSERT_EQ(one.contains("levels"), one.at("evaluator") == "vulkan");
    if (!one.contains("levels")) continue;
    ASSERT_EQ(one.at("levels").size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(one.at("levels")[i].at("level"), i + 1);
      EXPECT_EQ(one.at("levels")[i].at("what"), "points");
      EXPECT_GT(one.at("levels")[i].at("ms").at("median"), 0);
    }
  }
}

TEST_F(VulkanBackendTest, BenchMeasuresEveryKindOfNormals) {
  if (!hasDevice()) GTEST_SKIP() << "no Vulkan device";
  for (const std::string normals : {"fast", "exact"}) {
    const Outcome outcome =
        run({"bench", "--faces", "64", "--levels", "2", "--evaluators", "serial,vulkan", "--layouts", "xyz",
             "--normals", normals, "--samples", "1", "--sample-ms", "1", "--json", path("bench.json")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json runs = nlohmann::json::parse(read("bench.json")).at("runs");
    ASSERT_EQ(runs.size(), 2U) << normals;
    EXPECT_EQ(runs[1].at("evaluator"), "vulkan");
    EXPECT_EQ(runs[1].at("normals"), normals);
  }
}

}  // namespace
}  // namespace honeycomb::Test
