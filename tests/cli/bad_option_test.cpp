#include <fstream>
#include <nlohmann/json.hpp>

#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

struct BadOption {
  std::string name;
  std::vector<std::string> options;
  std::string what;
};

void PrintTo(const BadOption& option, std::ostream* out) {
  *out << option.name;
}

class BadOptionTest : public Workplace, public testing::WithParamInterface<BadOption> {};

TEST_P(BadOptionTest, IsRefusedWithItsRangeOrChoices) {
  std::vector<std::string> arguments{"refine", file("cube.obj", cubeObj()), path("out.obj")};
  arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
  EXPECT_REFUSED(arguments, HasSubstr(GetParam().what));
}

INSTANTIATE_TEST_SUITE_P(
    Bad, BadOptionTest,
    testing::Values(BadOption{"TensionOne", {"--tension", "1"}, "tension 1 is out of range"},
                    BadOption{"TensionZero", {"--tension", "0"}, "(0, 1)"},
                    BadOption{"TensionNaN", {"--tension", "nan"}, "(0, 1)"},
                    BadOption{"TensionName", {"--tension", "soft"}, "paper, sqrt3, topmod"},
                    BadOption{"EdgeParameterAboveOne", {"--edge-parameter", "1.01"}, "[0, 1]"},
                    BadOption{"EdgeParameterBelowZero", {"--edge-parameter", "-0.1"}, "[0, 1]"},
                    BadOption{"BoundaryWeight", {"--boundary", "eq16", "--sn", "2"}, "[0, 1]"},
                    BadOption{"BoundaryWeightOfBrick", {"--sn", "0.2"}, "eq16"},
                    BadOption{"CornersOfDrop", {"--corners", "valence2", "--boundary", "drop"}, "brick"},
                    BadOption{"Boundary", {"--boundary", "natural"}, "brick, eq16, drop"},
                    BadOption{"Corners", {"--corners", "all"}, "none, valence2"},
                    BadOption{"Scheme", {"--scheme", "polish"}, "akleman, zhang-wang, half-box"},
                    BadOption{"BackendCuda", {"--backend", "cuda"}, "auto, serial, simd, tbb, vulkan"},
                    BadOption{"Precision", {"--precision", "half"}, "single, double"},
                    BadOption{"DoubleOnVulkan", {"--precision", "double", "--backend", "vulkan"}, "serial or tbb"},
                    BadOption{"Normals", {"--normals", "good"}, "none, exact, fast"},
                    BadOption{"FastNormalsOfNoLevels", {"--normals", "fast", "--levels", "0"}, "1 to 20"},
                    BadOption{"FastNormalsOfATessellation",
                              {"--scheme", "half-box", "--normals", "fast", "--tessellate", "2"},
                              "--normals exact"},
                    BadOption{"NoLevels", {"--levels", "0"}, "1 to 20"},
                    BadOption{"TwentyOneLevels", {"--levels", "21"}, "1 to 20"},
                    BadOption{"NegativeLevels", {"--levels", "-1"}, "1 to 20"},
                    BadOption{"Threads", {"--threads", "-2"}, "--threads -2"}),
    [](const auto& tested) { return tested.param.name; });

class CommandLineTest : public Workplace {};

TEST_F(CommandLineTest, WhatCantBeParsedExitsTwoWithOneLine) {
  const std::string in = file("cube.obj", cubeObj());
  const std::vector<std::vector<std::string>> lines{
      {},
      {"polish", in},
      {"refine"},
      {"refine", in},
      {"refine", in, path("out.obj"), "--levels", "two"},
      {"refine", in, path("out.obj"), "--levels"},
      {"refine", in, path("out.obj"), "--levels", ""},
      {"refine", in, path("out.obj"), "--edge-parameter", "x"},
      {"refine", in, path("out.obj"), "--edge-parameter", ""},
      {"refine", in, path("out.obj"), "--unknown"},
      {"refine", in, path("out.obj"), path("more.obj")},
      {"convert", in, path("out.obj")},
  };
  for (const auto& line : lines) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.exitCode, 2) << outcome.err;
    EXPECT_TRUE(isOneErrorLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("--help"));
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_THAT(listing(), testing::ElementsAre("cube.obj"));
}

TEST_F(CommandLineTest, HelpAndVersionGoToStandardOutput) {
  for (const std::vector<std::string>& line : {std::vector<std::string>{"--help"},
                                               {"--version"},
                                               {"refine", "--help"},
                                               {"bake", "--help"},
                                               {"info", "--help"},
                                               {"convert", "--help"}}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out, "");
  }
}

TEST_F(CommandLineTest, HelpShowsDefaultsAndChoices) {
  const std::string help = run({"refine", "--help"}).out;
  for (const std::string part :
       {"--levels INT=2", "--tension TEXT=paper", "brick, eq16, drop", "auto, serial, simd, tbb, vulkan"})
    EXPECT_THAT(help, HasSubstr(part));
}

TEST_F(CommandLineTest, LevelsPast2To31HalfEdgesAreRefusedByName) {
  // 24 half-edges x 3^17 is the first past 2^31.
  EXPECT_REFUSED((std::vector<std::string>{"refine", file("cube.obj", cubeObj()), path("out.obj"), "--levels", "20"}),
                 HasSubstr("cube.obj: level 1"), HasSubstr("bytes"));
  const Outcome outcome = run({"info", path("cube.obj"), "--levels", "17", "--json"});
  const auto level = nlohmann::json::parse(outcome.out).at("levels").at(17);
  EXPECT_EQ(level.at("half_edges"), 3099363912);
  EXPECT_EQ(level.at("fits"), false);
}

std::int64_t memoryOfTheMachine() {
  std::ifstream file("/proc/meminfo");
  std::string key;
  std::int64_t kilobytes = 0;
  file >> key >> kilobytes;
  return kilobytes * 1024;
}

TEST_F(CommandLineTest, LevelsPastTheMemoryAreRefusedWithTheirBytes) {
  const std::string in = file("cube.obj", cubeObj());
  const auto info = nlohmann::json::parse(run({"info", in, "--levels", "16", "--json"}).out);
  if (info.at("levels").at(16).at("run_bytes") <= memoryOfTheMachine())
    GTEST_SKIP() << "this machine's memory suffices";
  EXPECT_REFUSED((std::vector<std::string>{"refine", in, path("out.obj"), "--levels", "16"}), HasSubstr(in),
                 HasSubstr(" bytes) of memory"), HasSubstr("is free; use --levels "));
}

TEST_F(CommandLineTest, ErosionThatLeavesNothingIsRefused) {
  EXPECT_REFUSED(
      (std::vector<std::string>{"refine", file("grid.obj", gridObj(1)), path("out.obj"), "--boundary", "drop"}),
      HasSubstr("grid.obj: "), HasSubstr("the drop rule leaves nothing of this mesh"));
}

}  // namespace
}  // namespace honeycomb::Test
