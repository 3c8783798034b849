#include <nlohmann/json.hpp>

#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

class TableTest : public Workplace {
 protected:
  const std::string mesh_ = file("grid.obj", gridObj(6));

  /// A table of the mesh.
  std::string built(const std::string& name, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"table", "build", mesh_, path(name)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return path(name);
  }
};

TEST_F(TableTest, BakesTheFramesThatItsSchemeBakes) {
  const std::string cache = bentCache("bent.pc2", gridObj(6), 5);
  const std::vector<std::string> scheme{"--scheme", "akleman", "--tension", "sqrt3", "--levels", "2"};
  std::vector<std::string> plain{"bake", mesh_, "--cache", cache, path("plain.pc2")};
  plain.insert(plain.end(), scheme.begin(), scheme.end());
  ASSERT_EQ(run(plain).exitCode, 0);
  std::vector<std::string> tiled = scheme;
  tiled.emplace_back("--tiles");
  for (const std::string& table : {built("a.hct", scheme), built("tiled.hct", tiled)}) {
    for (const std::string backend : {"serial", "simd", "tbb"}) {
      const Outcome outcome =
          run({"bake", mesh_, "--table", table, "--cache", cache, path("tabled.pc2"), "--backend", backend});
      ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
      EXPECT_EQ(read("tabled.pc2"), read("plain.pc2")) << table << " " << backend;
    }
  }
}

TEST_F(TableTest, BakesAMeshAFrame) {
  const std::string cache = bentCache("bent.pc2", gridObj(6), 2);
  const std::string table = built("a.hct", {"--levels", "1"});
  ASSERT_EQ(run({"bake", mesh_, "--cache", cache, path("plain_%d.obj"), "--levels", "1"}).exitCode, 0);
  ASSERT_EQ(run({"bake", mesh_, "--cache", cache, path("tabled_%d.obj"), "--table", table}).exitCode, 0);
  EXPECT_EQ(read("tabled_0.obj"), read("plain_0.obj"));
  EXPECT_FALSE(read("plain_0.obj").empty());
}

TEST_F(TableTest, IsOfItsMeshAlone) {
  const std::string table = built("a.hct");
  const std::string larger = file("larger.obj", gridObj(7));
  const std::string largerCache = bentCache("larger.pc2", gridObj(7), 2);
  const std::string cache = bentCache("bent.pc2", gridObj(6), 2);
  EXPECT_REFUSED((std::vector<std::string>{"bake", larger, "--cache", largerCache, "--table", table, path("out.pc2")}),
                 HasSubstr("reads 49 control points, and " + larger + " has 64"), HasSubstr("honeycomb table build"));
  std::string other = gridObj(6);
  const std::size_t face = other.find("f ");
  const std::size_t end = other.find('\n', face);
  other += other.substr(face, end - face + 1);
  other.erase(face, end - face + 1);
  const std::string otherMesh = file("other.obj", other);
  EXPECT_REFUSED((std::vector<std::string>{"bake", otherMesh, "--cache", cache, "--table", table, path("out.pc2")}),
                 HasSubstr("was made for another mesh"));
}

TEST_F(TableTest, HasTheSchemeItself) {
  EXPECT_REFUSED((std::vector<std::string>{"bake", mesh_, "--table", built("a.hct"), path("out.pc2"), "--levels", "3"}),
                 HasSubstr("--table: the file has scheme, levels and their options"));
}

TEST_F(TableTest, SaysWhatItHas) {
  const std::string table = built("a.hct", {"--levels", "2", "--limits", "--tension", "sqrt3"});
  const Outcome text = run({"table", "info", table});
  EXPECT_EQ(text.exitCode, 0);
  EXPECT_THAT(text.out, HasSubstr("akleman --boundary brick --tension sqrt3"));
  EXPECT_THAT(text.out, HasSubstr("level 2 indices"));
  const auto report = nlohmann::json::parse(run({"table", "info", table, "--json"}).out);
  EXPECT_EQ(report["control_vertices"], 49);
  EXPECT_EQ(report["levels"], 2);
  EXPECT_EQ(report["limits"], true);
  EXPECT_EQ(report["tiles"], false);
  EXPECT_EQ(report["primvars"]["positions"], 3);
  EXPECT_EQ(report["sections"][0]["offset"].get<std::int64_t>() % 64, 0);
}

TEST_F(TableTest, LeavesIndexBuffersOutWhenAsked) {
  const auto names = [&](const std::string& table) { return run({"table", "info", table}).out; };
  EXPECT_THAT(names(built("a.hct")), HasSubstr("triangles"));
  EXPECT_THAT(names(built("b.hct", {"--no-index-buffers"})), testing::Not(HasSubstr("triangles")));
}

TEST_F(TableTest, IsCheckedByItsSections) {
  const std::string table = built("a.hct");
  EXPECT_THAT(run({"table", "check", table}).out, HasSubstr(": sound"));
  std::string bytes = read("a.hct");
  const auto report = nlohmann::json::parse(run({"table", "info", table, "--json"}).out);
  for (const auto& section : report["sections"]) {
    if (section["name"] == "level 2 indices") bytes[section["offset"].get<std::size_t>()] ^= 1;
  }
  const std::string damaged = file("damaged.hct", bytes);
  EXPECT_REFUSED((std::vector<std::string>{"table", "check", damaged}), HasSubstr(damaged),
                 HasSubstr("section level 2 indices at byte"), HasSubstr("is damaged"));
  EXPECT_REFUSED((std::vector<std::string>{"table", "info", mesh_}), HasSubstr("is no table file"));
}

TEST_F(TableTest, ShowsInWhatTwoDiffer) {
  const std::string a = built("a.hct");
  const Outcome same = run({"table", "diff", a, built("b.hct")});
  EXPECT_EQ(same.exitCode, 0) << same.out << same.err;
  EXPECT_EQ(same.out, "");
  const Outcome other = run({"table", "diff", a, built("c.hct", {"--tension", "sqrt3"})});
  EXPECT_EQ(other.exitCode, 1);
  EXPECT_THAT(other.out, HasSubstr("level 1 weights: differs from element"));
  EXPECT_TRUE(isOneErrorLine(other.err)) << other.err;
}

TEST_F(TableTest, RefusesWhatItCantHave) {
  EXPECT_REFUSED((std::vector<std::string>{"table", "build", mesh_, path("a.obj")}),
                 HasSubstr("name a table file .hct"));
  EXPECT_REFUSED((std::vector<std::string>{"table", "build", mesh_, path("a.hct"), "--scheme", "zhang-wang",
                                           "--ccv-offset", "0.1"}),
                 HasSubstr("barycentres"));
}

}  // namespace
}  // namespace honeycomb::Test
