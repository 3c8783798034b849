#include <nlohmann/json.hpp>

#include "workplace.h"

namespace honeycomb::Test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class BenchTest : public Workplace {
 protected:
  /// As short as can be: what is looked at isn't time.
  std::vector<std::string> quick(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "bench");
    for (const char* option : {"--samples", "1", "--sample-ms", "0"}) arguments.emplace_back(option);
    return arguments;
  }
  json bench(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--json", path("bench.json")});
    const Outcome outcome = run(quick(std::move(arguments)));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return json::parse(read("bench.json"));
  }
};

/// "serial xyz 2" of each entry.
std::set<std::string> namesOf(const json& entries) {
  std::set<std::string> names;
  for (const json& entry : entries)
    names.insert(entry.at("evaluator").get<std::string>() + " " + entry.at("layout").get<std::string>() + " " +
                 std::to_string(entry.at("level").get<int>()));
  return names;
}

TEST_F(BenchTest, EveryEvaluatorLevelAndLayoutIsMeasuredOrSkippedWithAReason) {
  const json all = bench({"--faces", "64", "--levels", "1,2"});
  std::set<std::string> names = namesOf(all.at("runs"));
  names.merge(namesOf(all.at("skipped")));
  for (const std::string evaluator : {"serial", "simd", "tbb", "csr", "vulkan", "vulkan-csr", "opensubdiv-cpu",
                                      "opensubdiv-omp", "opensubdiv-catmark", "eigen"})
    for (const std::string layout : {"xyz", "xyzw"})
      for (const std::string level : {"1", "2"})
        EXPECT_TRUE(names.contains(evaluator + " " + layout + " " + level)) << evaluator << layout << level;
  for (const json& skipped : all.at("skipped")) EXPECT_NE(skipped.at("why"), "");
}

TEST_F(BenchTest, BuildingIsLeftOutWhereNobodyWantsIt) {
  const std::vector<std::string> arguments = {"--faces", "64", "--levels", "2", "--evaluators", "serial"};
  EXPECT_FALSE(bench(arguments).at("build").empty());
  std::vector<std::string> without = arguments;
  without.emplace_back("--no-building");
  const json all = bench(without);
  EXPECT_TRUE(all.at("build").empty());
  EXPECT_EQ(all.at("runs").size(), 2U) << "two layouts";
}

TEST_F(BenchTest, JsonHasTheSchemaThatIsPromised) {
  const json all = bench({"--faces", "64", "--levels", "2", "--evaluators", "serial,tbb,csr", "--threads", "2"});
  for (const char* fact : {"processor", "threads", "caches", "memory_bytes", "compiler", "flags", "version"})
    EXPECT_TRUE(all.at("machine").contains(fact)) << fact;
  for (const char* limit : {"write_gb_s", "write_nt_gb_s", "copy_gb_s"})
    EXPECT_GT(all.at("limits").at(limit).get<double>(), 0) << limit;
  EXPECT_EQ(all.at("limits").at("measured").size(), 12U) << "three limits, one and all threads, two layouts";
  ASSERT_EQ(all.at("runs").size(), 6U);
  const json run = all.at("runs")[1];
  EXPECT_EQ(run.at("evaluator"), "tbb");
  EXPECT_EQ(run.at("scheme"), "akleman");
  EXPECT_EQ(run.at("mesh"), "torus");
  EXPECT_EQ(run.at("control_faces"), 64);
  EXPECT_EQ(run.at("refined_vertices"), 64 * 4 * 3);
  EXPECT_EQ(run.at("layout"), "xyz");
  EXPECT_EQ(run.at("normals"), "none");
  EXPECT_EQ(run.at("threads"), 2);
  for (const char* spread : {"min", "median", "max"})
    EXPECT_GT(run.at("ns_per_vertex").at(spread).get<double>(), 0) << spread;
  EXPECT_GT(run.at("table_bytes"), 0);
  EXPECT_GT(run.at("build_ms"), 0);
  std::set<std::string> built;
  for (const json& build : all.at("build"))
    if (build.at("library") == "honeycomb") built.insert(build.at("what").get<std::string>());
  EXPECT_EQ(built, (std::set<std::string>{"control", "topology", "full-topology", "tables", "tiles", "flattened"}));
}

TEST_F(BenchTest, EvaluatorsOfTheLevelTablesGiveTheSameBitsAndFlattenedOnesRound) {
  const json report = bench(
      {"--faces", "64", "--levels", "3", "--evaluators", "serial,simd,tbb,simd-tiled,tbb-tiled,tbb-tile-order,csr"});
  for (const json& run : report.at("runs")) {
    if (run.at("evaluator") == "csr") {
      EXPECT_GT(run.at("difference"), 0);
      EXPECT_LT(run.at("difference"), 4e-6);
    } else {
      EXPECT_EQ(run.at("difference"), 0) << run.at("evaluator");
    }
  }
}

TEST_F(BenchTest, MeshesOfEveryKindAreMeasured) {
  const std::vector<std::string> few{"--evaluators", "tbb,csr", "--levels", "1", "--layouts", "xyz"};
  const auto meshOf = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), few.begin(), few.end());
    const json runs = bench(arguments).at("runs");
    EXPECT_EQ(runs.size(), 2U);
    return runs.at(0).at("mesh").get<std::string>() + " " + runs.at(0).at("control_faces").dump();
  };
  EXPECT_EQ(meshOf({"--faces", "100"}), "torus 100");
  EXPECT_EQ(meshOf({"--faces", "100", "--shuffle"}), "shuffled torus 100");
  EXPECT_THAT(meshOf({"--mesh", "mixed", "--faces", "100"}), HasSubstr("mixed 1"));
  EXPECT_THAT(meshOf({"--mesh", "demo"}), HasSubstr("creature.obj"));
  const std::string grid = file("grid.obj", gridObj(4));
  EXPECT_EQ(meshOf({grid}), grid + " 16");
  EXPECT_EQ(meshOf({grid, "--scheme", "half-box", "--boundary", "clamped"}), grid + " 16");
}

TEST_F(BenchTest, AChainHasTheLevelsItSays) {
  const json runs =
      bench({"--faces", "16", "--scheme", "akleman:1,midpoint:2", "--evaluators", "serial", "--layouts", "xyz"})
          .at("runs");
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].at("level"), 3);
}

TEST_F(BenchTest, NormalsAreMeasuredWhereAnEvaluatorHasThem) {
  const std::vector<std::string> few{"--faces", "16", "--levels", "1", "--evaluators", "serial,tbb,simd-tiled,csr"};
  std::vector<std::string> exact = few, fast = few;
  exact.insert(exact.end(), {"--normals", "exact"});
  fast.insert(fast.end(), {"--normals", "fast"});
  const json withExact = bench(exact);
  EXPECT_EQ(namesOf(withExact.at("runs")),
            (std::set<std::string>{"serial xyz 1", "serial xyzw 1", "tbb xyz 1", "tbb xyzw 1", "simd-tiled xyz 1",
                                   "simd-tiled xyzw 1"}));
  EXPECT_EQ(namesOf(withExact.at("skipped")), (std::set<std::string>{"csr xyz 1", "csr xyzw 1"}));
  EXPECT_EQ(withExact.at("runs").at(0).at("normals"), "exact");
  EXPECT_TRUE(bench(fast).at("skipped").at(0).at("why").is_string());
}

TEST_F(BenchTest, TheTableHasALineForEachEvaluator) {
  const Outcome outcome = run(quick({"--faces", "16", "--levels", "1", "--evaluators", "serial,csr"}));
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_THAT(outcome.out, testing::AllOf(HasSubstr("torus: 16 faces, 16 vertices"), HasSubstr("level 1, xyzw"),
                                          HasSubstr("  serial "), HasSubstr("same bits"), HasSubstr("  csr "),
                                          HasSubstr("write_nt_gb_s"), HasSubstr("level 1, building")));
}

TEST_F(BenchTest, WrongOptionsAreRefused) {
  const std::string cube = file("cube.obj", cubeObj());
  EXPECT_REFUSED(quick({"--evaluators", "serial,warp"}), HasSubstr("--evaluators: there is no 'warp'"),
                 HasSubstr("serial, simd, tbb"));
  EXPECT_REFUSED(quick({"--layouts", "zyx"}), HasSubstr("xyz, xyzw"));
  EXPECT_REFUSED(quick({"--normals", "good"}), HasSubstr("none, fast, exact"));
  EXPECT_REFUSED(quick({"--levels", "3,x"}), HasSubstr("'x'"));
  EXPECT_REFUSED(quick({"--levels", "0"}), HasSubstr("1 to 20"));
  EXPECT_REFUSED(quick({"--scheme", "polish"}), HasSubstr("akleman"));
  EXPECT_REFUSED(quick({"--mesh", "plate"}), HasSubstr("torus, mixed, demo"));
  EXPECT_REFUSED(quick({"--mesh", "torus", cube}), HasSubstr("leave out one"));
  EXPECT_REFUSED(quick({"--faces", "15"}), HasSubstr("from 16"));
  EXPECT_REFUSED(quick({"--faces", "100", cube}), HasSubstr("--faces"));
  EXPECT_REFUSED((std::vector<std::string>{"bench", "--samples", "0"}), HasSubstr("--samples 0"));
  EXPECT_REFUSED((std::vector<std::string>{"bench", "--sample-ms", "-1"}), HasSubstr("--sample-ms -1"));
  EXPECT_REFUSED(quick({"--scheme", "zhang-wang", "--ccv-offset", "1"}), HasSubstr("--ccv-offset"));
  EXPECT_EQ(run({"bench", "--faces", "many"}).exitCode, 2);
}

TEST_F(BenchTest, AJsonThatCantBeWrittenIsRefusedBeforeAnythingIsMeasured) {
  const Outcome outcome = run(quick({"--faces", "16", "--json", path("nowhere/bench.json")}));
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(outcome.err)) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_REFUSED(quick({"--json", path("")}), HasSubstr("folder"));
}

TEST_F(BenchTest, LevelsThatDontFitAreRefusedBeforeAnythingIsBuilt) {
  EXPECT_REFUSED(quick({"--levels", "3,12"}), HasSubstr("torus: level "), HasSubstr("use --levels"));
  EXPECT_REFUSED(quick({"--faces", "536870912"}), HasSubstr("--faces 536870912"));
}

TEST_F(BenchTest, ADefectiveMeshIsRefusedWithItsLine) {
  EXPECT_REFUSED(quick({file("bow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n")}),
                 HasSubstr("bow.obj:"));
  EXPECT_REFUSED(quick({path("none.obj")}), HasSubstr("none.obj"));
}

}  // namespace
}  // namespace honeycomb::Test
