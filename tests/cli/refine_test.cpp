#include <cmath>
#include <nlohmann/json.hpp>

#include "io/obj.h"
#include "workplace.h"

namespace honeycomb::Test {
namespace {

class RefineTest : public Workplace {
 protected:
  /// Refines, expects success and silence, and returns the output's text.
  std::string refine(const std::string& in, std::vector<std::string> options) const {
    std::vector<std::string> arguments{"refine", in, path("out.obj")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "");
    return read("out.obj");
  }
};

TEST_F(RefineTest, CountsFollowTheZipRule) {
  const std::string in = file("cube.obj", cubeObj());
  for (int level = 1; level <= 4; ++level) {
    refine(in, {"--levels", std::to_string(level)});
    const auto mesh = Io::readObj(path("out.obj"));
    ASSERT_TRUE(mesh);
    // V' = 2E, E' = 3E, F' = F + V from 8, 12, 6.
    EXPECT_EQ(mesh->polygons.vertexCount, 24 * std::pow(3, level - 1));
    EXPECT_EQ(std::ssize(mesh->polygons.indices), 24 * std::pow(3, level));
  }
}

TEST_F(RefineTest, FirstLevelOfTheCubeHasThePapersWeights) {
  refine(file("cube.obj", cubeObj()), {"--levels", "1", "--precision", "double"});
  const auto mesh = Io::readObj(path("out.obj"));
  ASSERT_TRUE(mesh);
  // a(4) = 0.7625, A = (a, 3q, q, 3q) with q = (1-a)/7; c_k = (A_k + A_{k-1})/2: corner points of a unit face lie at
  // distance c_2 + c_3 = 2q + (a + 3q)/2 - ... from the sides they are near to.
  const double q = (1 - 0.7625) / 7, along = 0.5, across = (q + 3 * q) / 2 * 2;
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-12; };
  int found = 0;
  for (int v = 0; v < mesh->polygons.vertexCount; ++v) {
    const auto p = mesh->position(v);
    for (int axis = 0; axis < 3; ++axis) {
      const double a = p[static_cast<std::size_t>(axis)], b = p[static_cast<std::size_t>((axis + 1) % 3)];
      if (near(a, along) && near(std::min(b, 1 - b), across)) ++found;
      if (near(b, along) && near(std::min(a, 1 - a), across)) ++found;
    }
  }
  EXPECT_EQ(found, 24);
}

TEST_F(RefineTest, SerialSimdAndTbbGiveTheSameFile) {
  const std::vector<std::pair<std::string, std::string>> meshes{{file("torus.obj", torusObj(12)), "4"},
                                                                {file("grid.obj", gridObj(9)), "4"}};
  for (const auto& [in, levels] : meshes)
    for (const std::string precision : {"single", "double"}) {
      const std::vector<std::string> options{"--levels", levels, "--precision", precision, "--normals", "exact"};
      auto serial = options, simd = options, tbb = options;
      serial.insert(serial.end(), {"--backend", "serial"});
      simd.insert(simd.end(), {"--backend", "simd"});
      tbb.insert(tbb.end(), {"--backend", "tbb", "--threads", "4"});
      const std::string reference = refine(in, serial);
      EXPECT_GT(reference.size(), 100000U);
      EXPECT_TRUE(refine(in, simd) == reference) << in << " " << precision;
      EXPECT_TRUE(refine(in, tbb) == reference) << in << " " << precision;
      EXPECT_TRUE(refine(in, options) == reference) << "auto: " << in << " " << precision;
    }
}

TEST_F(RefineTest, SpatialOrderGivesTheSamePointsAtOtherPlaces) {
  const std::string in = file("torus.obj", torusObj(12));
  const std::string inOrder = refine(in, {"--levels", "1"});
  const auto expected = Io::readObj(path("out.obj"));
  EXPECT_NE(refine(in, {"--levels", "1", "--order", "spatial"}), inOrder);
  const auto found = Io::readObj(path("out.obj"));
  ASSERT_TRUE(expected && found);
  ASSERT_EQ(found->positions.size(), expected->positions.size());
  EXPECT_EQ(found->polygons.faceCount(), expected->polygons.faceCount());
  const auto near = [](std::span<const double> a, std::span<const double> b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < 1e-5;
  };
  for (std::int64_t v = 0; v < expected->polygons.vertexCount; ++v) {
    std::int64_t partners = 0;
    for (std::int64_t w = 0; w < found->polygons.vertexCount; ++w)
      partners += near(expected->position(v), found->position(w)) ? 1 : 0;
    ASSERT_EQ(partners, 1) << "vertex " << v;
  }
}

TEST_F(RefineTest, OrdersThatDoNotExistAreRefused) {
  const Outcome outcome = run({"refine", file("cube.obj", cubeObj()), path("out.obj"), "--order", "sorted"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.err, "error: --order: there is no 'sorted'; choose from: input, spatial\n");
}

TEST_F(RefineTest, ExactNormalsAreUnitAndOneAVertex) {
  refine(file("torus.obj", torusObj(12)), {"--normals", "exact"});
  const auto mesh = Io::readObj(path("out.obj"));
  ASSERT_TRUE(mesh);
  ASSERT_EQ(mesh->normals.size(), mesh->positions.size());
  EXPECT_EQ(mesh->cornerNormals, mesh->polygons.indices);
  for (std::size_t i = 0; i < mesh->normals.size(); i += 3)
    EXPECT_NEAR(std::hypot(mesh->normals[i], mesh->normals[i + 1], mesh->normals[i + 2]), 1, 1e-6);
}

TEST_F(RefineTest, FastNormalsAreUnitAndNearTheExactOnes) {
  const std::string in = file("torus.obj", torusObj(24));
  const auto normals = [&](const std::string& kind) {
    refine(in, {"--levels", "3", "--normals", kind});
    return Io::readObj(path("out.obj"))->normals;
  };
  const std::vector<double> fast = normals("fast"), exact = normals("exact");
  ASSERT_EQ(fast.size(), exact.size());
  EXPECT_NE(fast, exact);
  for (std::size_t i = 0; i < fast.size(); i += 3) {
    EXPECT_NEAR(std::hypot(fast[i], fast[i + 1], fast[i + 2]), 1, 1e-6);
    EXPECT_GT(fast[i] * exact[i] + fast[i + 1] * exact[i + 1] + fast[i + 2] * exact[i + 2], std::cos(0.1)) << i / 3;
  }
}

TEST_F(RefineTest, NoNormalsUnlessAskedFor) {
  EXPECT_EQ(refine(file("cube.obj", cubeObj()), {}).find("vn"), std::string::npos);
}

TEST_F(RefineTest, OptionsChangeTheSurface) {
  const std::string in = file("grid.obj", gridObj(4));
  std::set<std::string> different{refine(in, {})};
  const std::vector<std::vector<std::string>> variants{{"--tension", "sqrt3"}, {"--tension", "topmod"},
                                                       {"--tension", "0.6"},   {"--edge-parameter", "0.25"},
                                                       {"--boundary", "eq16"}, {"--boundary", "eq16", "--sn", "0.5"},
                                                       {"--boundary", "drop"}, {"--corners", "valence2"}};
  for (const auto& variant : variants) different.insert(refine(in, variant));
  EXPECT_EQ(different.size(), variants.size() + 1);
  EXPECT_EQ(refine(in, {}), refine(in, {"--tension", "paper", "--edge-parameter", "0.5", "--boundary", "brick"}));
}

TEST_F(RefineTest, TaggedCornersStay) {
  const std::string in = file("grid.obj", gridObj(4));
  const auto hasCorner = [this] {
    const auto mesh = Io::readObj(path("out.obj"));
    for (int v = 0; v < mesh->polygons.vertexCount; ++v)
      if (mesh->position(v)[0] == 0 && mesh->position(v)[1] == 0) return true;
    return false;
  };
  refine(in, {"--levels", "3", "--corners", "valence2"});
  EXPECT_TRUE(hasCorner());
  refine(in, {"--levels", "3"});
  EXPECT_FALSE(hasCorner());
}

TEST_F(RefineTest, JsonSummaryNamesWhatWasDone) {
  const Outcome outcome = run({"refine", file("cube.obj", cubeObj()), path("out.obj"), "--levels", "3", "--json"});
  EXPECT_EQ(outcome.err, "");
  const auto summary = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(summary.at("levels"), 3);
  EXPECT_EQ(summary.at("backend"), "tbb");
  EXPECT_EQ(summary.at("vertices"), 216);
  EXPECT_EQ(summary.at("faces"), 110);
  EXPECT_GT(summary.at("build_ms"), 0);
}

}  // namespace
}  // namespace honeycomb::Test
