#include <nlohmann/json.hpp>

#include "workplace.h"

namespace honeycomb::Test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class InfoTest : public Workplace {
 protected:
  json info(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "info");
    arguments.emplace_back("--json");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return json::parse(outcome.out);
  }
};

TEST_F(InfoTest, ClosedMesh) {
  const json torus = info({file("torus.obj", torusObj(6))});
  EXPECT_EQ(torus.at("vertices"), 36);
  EXPECT_EQ(torus.at("edges"), 72);
  EXPECT_EQ(torus.at("faces"), 36);
  EXPECT_EQ(torus.at("sides"), json({{"4", 36}}));
  EXPECT_EQ(torus.at("valences"), json({{"4", 36}}));
  EXPECT_EQ(torus.at("boundary_loops"), json::array());
  EXPECT_EQ(torus.at("components"), 1);
  EXPECT_EQ(torus.at("genus"), 1);
  EXPECT_EQ(torus.at("bounds").at("high").at(0), 3);
}

TEST_F(InfoTest, BorderedMesh) {
  const json grid = info({file("grid.obj", gridObj(3))});
  EXPECT_EQ(grid.at("valences"), json({{"2", 4}, {"3", 8}, {"4", 4}}));
  EXPECT_EQ(grid.at("boundary_loops"), json({12}));
  EXPECT_EQ(grid.at("genus"), 0);
}

TEST_F(InfoTest, ComponentsAndSideCounts) {
  const json two = info({file("two.obj", cubeObj() + "v 0 0 5\nv 1 0 5\nv 0 1 5\nf 9 10 11\n")});
  EXPECT_EQ(two.at("components"), 2);
  EXPECT_EQ(two.at("sides"), json({{"3", 1}, {"4", 6}}));
  EXPECT_EQ(two.at("boundary_loops"), json({3}));
  EXPECT_EQ(two.at("genus"), 0);
}

TEST_F(InfoTest, PredictionsEqualWhatIsBuilt) {
  for (const std::string& in : {file("torus.obj", torusObj(7)), file("grid.obj", gridObj(5))}) {
    const json levels = info({in, "--levels", "4"}).at("levels");
    ASSERT_EQ(levels.size(), 5U);
    for (std::size_t k = 1; k <= 4; ++k) {
      const Outcome refined = run({"refine", in, path("out.obj"), "--levels", std::to_string(k), "--json"});
      const json built = json::parse(refined.out);
      for (const char* count : {"vertices", "edges", "faces"})
        EXPECT_EQ(levels[k].at(count), built.at(count)) << in << k;
      EXPECT_TRUE(levels[k].at("fits"));
      EXPECT_GE(levels[k].at("run_bytes"), built.at("table_bytes"));
    }
  }
}

TEST_F(InfoTest, PredictionsOfEverySchemeEqualWhatIsBuilt) {
  const std::string in = file("torus.obj", torusObj(16));
  for (const std::string scheme :
       {"zhang-wang", "half-box", "midpoint", "trisect", "doo-sabin", "trisect:1,half-box:2"}) {
    const json predicted = info({in, "--scheme", scheme, "--levels", "3"}).at("levels").back();
    const json built =
        json::parse(run({"refine", in, path("out.obj"), "--scheme", scheme, "--levels", "3", "--json"}).out);
    for (const char* count : {"vertices", "edges", "faces"}) EXPECT_EQ(predicted.at(count), built.at(count)) << scheme;
    EXPECT_EQ(predicted.at("level"), built.at("levels"));
    EXPECT_EQ(predicted.at("step"), built.at("steps").back());
    EXPECT_GE(predicted.at("run_bytes"), built.at("table_bytes")) << scheme;
  }
}

TEST_F(InfoTest, TextHasTheCountsAndOneRowALevel) {
  const Outcome outcome = run({"info", file("torus.obj", torusObj(40)), "--levels", "3"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.err, "");
  for (const std::string part : {"1,600", "half-edges", "none, the mesh is closed", "genus 1", "57,600"})
    EXPECT_THAT(outcome.out, HasSubstr(part));
}

TEST_F(InfoTest, EveryDefectIsListedWithItsLine) {
  const std::string in = file("bad.obj", cubeObj() + "v 5 5 5\nf 1 2 3 2\nv 6 6 6\n");
  const Outcome outcome = run({"info", in, "--json"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_TRUE(isOneErrorLine(outcome.err)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("of 3 defects"));
  const json defects = json::parse(outcome.out).at("defects");
  ASSERT_EQ(defects.size(), 3U);
  EXPECT_EQ(defects[0].at("line"), 16);
  EXPECT_EQ(defects[0].at("face"), 7);
  EXPECT_EQ(defects[1].at("line"), 15);
  EXPECT_EQ(defects[1].at("vertex"), 9);
  EXPECT_EQ(defects[2].at("line"), 17);
  EXPECT_EQ(defects[2].at("vertex"), 10);
}

TEST_F(InfoTest, MachineNamesBackendsAndLimits) {
  const json machine = info({});
  EXPECT_EQ(machine.at("backends"), json({"auto", "serial", "simd", "tbb", "vulkan"}));
  EXPECT_GT(machine.at("threads"), 0);
  EXPECT_EQ(machine.at("limits").at("half_edges"), 2147483647);
  EXPECT_TRUE(machine.at("vulkan_devices").is_array());
  EXPECT_THAT(run({"info"}).out, HasSubstr("2,147,483,647 half-edges"));
}

TEST_F(InfoTest, ThreadsLimitIsObeyed) {
  EXPECT_EQ(info({"--threads", "1"}).at("threads"), 1);
}

}  // namespace
}  // namespace honeycomb::Test
