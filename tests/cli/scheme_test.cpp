#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/obj.h"
#include "workplace.h"

namespace honeycomb::Test {
namespace {

using Options = std::vector<std::string>;
using Point = std::array<double, 3>;

/// Faces of 3, 4 and 5 sides, in an order in which a stable sort by sides moves them: a house with a pyramid for a
/// roof.
std::string houseObj() {
  return "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 2 1\nv 0 2 1\nv 1 1 2\nv 1 -0.5 0.5\n"
         "f 1 4 3 2\nf 5 6 9\nf 2 3 7 6\nf 6 7 9\nf 3 4 8 7\nf 7 8 9\nf 4 1 5 8\nf 8 5 9\n"
         "f 1 2 10\nf 2 6 10\nf 6 5 10\nf 5 1 10\n";
}

/// The house without its porch: open, and not flat.
std::string openHouseObj() {
  const std::string house = houseObj();
  const std::size_t porch = house.find("v 1 -0.5 0.5\n"), faces = house.find("f 1 2 10");
  return house.substr(0, porch) + house.substr(house.find("f "), faces - house.find("f "));
}

class SchemeTest : public Workplace {
 protected:
  /// Refines, expects success and silence, and returns the output's text.
  std::string refine(const std::string& in, const Options& options) const {
    Options arguments{"refine", in, path("out.obj")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err + outcome.out, "");
    return read("out.obj");
  }
  std::vector<Point> refinedPoints(const std::string& in, const Options& options) const {
    refine(in, options);
    const auto mesh = Io::readObj(path("out.obj"));
    std::vector<Point> points;
    for (std::int32_t v = 0; mesh && v < mesh->polygons.vertexCount; ++v) {
      const auto p = mesh->position(v);
      points.push_back({p[0], p[1], p[2]});
    }
    return points;
  }
};

/// The largest distance between points of the same number; of different numbers of points: infinite.
double distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  double largest = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1], a[i][2] - b[i][2]));
  return largest;
}

TEST_F(SchemeTest, EachGivesTheSameFileOnSerialAndTbb) {
  std::set<std::string> different;
  const std::vector<Options> schemes{{"zhang-wang"},
                                     {"zhang-wang", "--ccv-offset", "0.3"},
                                     {"half-box"},
                                     {"midpoint"},
                                     {"trisect"},
                                     {"centroid"},
                                     {"doo-sabin"},
                                     {"zhang-wang:1,half-box:1"},
                                     {"half-box", "--tessellate", "2"}};
  const std::string in = file("house.obj", openHouseObj());
  for (Options options : schemes) {
    options.insert(options.begin(), {"--normals", "exact", "--scheme"});
    Options serial = options;
    serial.insert(serial.end(), {"--backend", "serial"});
    const std::string reference = refine(in, serial);
    EXPECT_TRUE(refine(in, options) == reference) << options[3];
    EXPECT_THAT(reference, testing::HasSubstr("vn "));
    different.insert(reference);
  }
  EXPECT_EQ(different.size(), schemes.size());
}

TEST_F(SchemeTest, FastNormalsAreTheSameOnSerialAndTbbAndLeaveThePoints) {
  const std::vector<std::string> schemes{"akleman", "zhang-wang", "half-box",  "midpoint",
                                         "trisect", "centroid",   "doo-sabin", "zhang-wang:1,half-box:1"};
  const std::string in = file("house.obj", openHouseObj());
  const auto loaded = [this](const Options& options, const std::string& mesh) {
    refine(mesh, options);
    return *Io::readObj(path("out.obj"));
  };
  for (const std::string& scheme : schemes)
    for (const std::string precision : {"single", "double"}) {
      const Options plain{"--scheme", scheme, "--precision", precision};
      Options fast = plain, serial = plain;
      fast.insert(fast.end(), {"--normals", "fast"});
      serial.insert(serial.end(), {"--normals", "fast", "--backend", "serial"});
      EXPECT_TRUE(refine(in, fast) == refine(in, serial)) << scheme << precision;
      const auto mesh = loaded(fast, in);
      EXPECT_TRUE(mesh.positions == loaded(plain, in).positions) << scheme << precision;
      EXPECT_EQ(mesh.normals.size(), mesh.positions.size()) << scheme << precision;
    }
}

TEST_F(SchemeTest, OptionsChangeTheSurfaceAndDefaultsDont) {
  const std::string in = file("house.obj", openHouseObj());
  const std::vector<std::vector<Options>> variants{{{"zhang-wang"},
                                                    {"zhang-wang", "--an", "kobbelt"},
                                                    {"zhang-wang", "--an", "0.5"},
                                                    {"zhang-wang", "--bn", "0.6"},
                                                    {"zhang-wang", "--cn", "0.3"},
                                                    {"zhang-wang", "--alpha", "0.9"},
                                                    {"zhang-wang", "--sn", "0.5"},
                                                    {"zhang-wang", "--boundary", "brick"},
                                                    {"zhang-wang", "--boundary", "drop"},
                                                    {"zhang-wang", "--ccv-offset", "-0.1"},
                                                    {"zhang-wang", "--interpolate", "vertices"},
                                                    {"zhang-wang", "--an", "0.01", "--force"}},
                                                   {{"half-box"},
                                                    {"half-box", "--tuned", "first"},
                                                    {"half-box", "--tuned", "all"},
                                                    {"half-box", "--convert", "trisect"},
                                                    {"half-box", "--boundary", "clamped"}},
                                                   {{"trisect"}, {"trisect", "--ratio", "0.2"}}};
  std::set<std::string> different;
  std::size_t count = 0;
  for (const auto& scheme : variants)
    for (Options options : scheme) {
      // a_N shows in the vertices of the third level.
      options.insert(options.begin(), {"--levels", "3", "--scheme"});
      different.insert(refine(in, options));
      ++count;
    }
  EXPECT_EQ(different.size(), count);
  const std::string grid = file("grid.obj", gridObj(3));
  EXPECT_NE(refine(grid, {"--scheme", "zhang-wang", "--boundary", "brick", "--corners", "valence2"}),
            refine(grid, {"--scheme", "zhang-wang", "--boundary", "brick"}));
  const Options defaults{"--scheme",      "zhang-wang", "--an",         "paper", "--cn",       "0.5",
                         "--sn",          "0.25",       "--ccv-offset", "0",     "--boundary", "eq16",
                         "--interpolate", "none",       "--corners",    "none"};
  EXPECT_EQ(refine(in, defaults), refine(in, {"--scheme", "zhang-wang"}));
  EXPECT_EQ(refine(in, {"--scheme", "half-box", "--tuned", "none", "--convert", "auto", "--boundary", "natural"}),
            refine(in, {"--scheme", "half-box"}));
}

TEST_F(SchemeTest, AChainRefinesByOnePartAfterTheOther) {
  const std::string in = file("grid.obj", gridObj(4));
  const std::string three = refine(in, {"--levels", "3"});
  EXPECT_EQ(refine(in, {"--scheme", "akleman:3"}), three);
  EXPECT_EQ(refine(in, {"--scheme", "akleman:1,akleman:2", "--levels", "3"}), three);
  // The conversion of half-box splines is the step of another scheme.
  EXPECT_EQ(refine(in, {"--scheme", "half-box", "--convert", "akleman"}),
            refine(in, {"--scheme", "akleman:1,half-box:2"}));
  // Options go to the schemes that have them; a boundary rule too.
  EXPECT_EQ(refine(in, {"--scheme", "akleman:1,half-box:1", "--boundary", "natural"}),
            refine(in, {"--scheme", "akleman:1,half-box:1", "--boundary", "brick"}));
  EXPECT_NE(refine(in, {"--scheme", "akleman:1,half-box:1", "--boundary", "drop"}),
            refine(in, {"--scheme", "akleman:1,half-box:1"}));
  // Faces that brick has cut in half are brick's to refine, whatever the scheme's own default.
  EXPECT_EQ(refine(in, {"--scheme", "akleman:1,zhang-wang:1"}),
            refine(in, {"--scheme", "akleman:1,zhang-wang:1", "--boundary", "brick"}));
}

TEST_F(SchemeTest, ConversionsAreStepsButNoLevels) {
  const Options arguments{"refine", file("torus.obj", torusObj(6)), path("out.obj"), "--scheme", "half-box", "--json"};
  const auto refined = nlohmann::json::parse(run(arguments).out);
  EXPECT_EQ(refined.at("levels"), 2);
  EXPECT_EQ(refined.at("scheme"), "half-box");
  EXPECT_EQ(refined.at("steps"), nlohmann::json({"akleman", "half-box", "half-box"}));
  // 72 edges: V' = 2E, E' = 3E; then E' = 4E, V' = 4V.
  EXPECT_EQ(refined.at("vertices"), 144 * 16);
  const auto info =
      nlohmann::json::parse(run({"info", path("torus.obj"), "--scheme", "half-box", "--levels", "2", "--json"}).out);
  ASSERT_EQ(info.at("levels").size(), 4U);
  EXPECT_EQ(info.at("levels").at(1).at("level"), 0);
  EXPECT_EQ(info.at("levels").at(1).at("step"), "akleman");
  EXPECT_EQ(info.at("levels").at(3).at("level"), 2);
  EXPECT_EQ(info.at("levels").at(3).at("vertices"), refined.at("vertices"));
}

/// The house's central control vertices at a distance from the middles, by the faces' corners.
std::string liftedCentres(double offset) {
  const auto mesh = Io::parseObj(houseObj(), "house");
  std::string text = "# central control vertices\n";
  for (std::size_t f = 0; f + 1 < mesh->polygons.faceOffsets.size(); ++f) {
    const auto begin = mesh->polygons.faceOffsets[f], end = mesh->polygons.faceOffsets[f + 1];
    const auto corner = [&](std::int64_t i) {
      return mesh->position(mesh->polygons.indices[static_cast<std::size_t>(i)]);
    };
    Point centre{}, normal{};
    for (std::int64_t i = begin; i < end; ++i)
      for (std::size_t x = 0; x < 3; ++x) centre[x] += corner(i)[x] / static_cast<double>(end - begin);
    for (std::size_t x = 0; x < 3; ++x) {
      const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
      const auto a = corner(begin), b = corner(begin + 1), c = corner(begin + 2);
      normal[x] = (b[y] - a[y]) * (c[z] - a[z]) - (b[z] - a[z]) * (c[y] - a[y]);
    }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    text += "v";
    for (std::size_t x = 0; x < 3; ++x) text += " " + std::to_string(centre[x] + offset * normal[x] / length);
    text += "\n";
  }
  return text;
}

TEST_F(SchemeTest, CentralControlVerticesComeFromAFileInTheOrderOfTheFaces) {
  const std::string in = file("house.obj", houseObj()), centres = file("centres.obj", liftedCentres(0.25));
  const Options base{"--scheme", "zhang-wang"};
  const auto with = [&](const std::string& mesh, std::string option, std::string value) {
    Options options = base;
    options.insert(options.end(), {std::move(option), std::move(value), "--drop-isolated"});
    return refinedPoints(mesh, options);
  };
  const auto fromFile = with(in, "--ccv", centres);
  // The faces are planar; six decimals were written.
  EXPECT_LT(distance(fromFile, with(in, "--ccv-offset", "0.25")), 1e-5);
  EXPECT_GT(distance(fromFile, with(in, "--ccv-offset", "0.24")), 1e-3);
  EXPECT_LT(distance(with(in, "--ccv", file("middles.obj", liftedCentres(0))), refinedPoints(in, base)), 1e-5);
  // An offset a face, from a file.
  std::string same, other;
  std::istringstream lines(houseObj());
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("f ")) continue;
    other += same.empty() ? "0.25\n" : "-0.25\r\n";
    same += "0.25\n";
  }
  EXPECT_EQ(with(in, "--ccv-offset", file("same.txt", same)), with(in, "--ccv-offset", "0.25"));
  EXPECT_GT(distance(with(in, "--ccv-offset", file("other.txt", other)), with(in, "--ccv-offset", "0.25")), 1e-2);
  // Dropped vertices leave the faces' order as it is.
  const std::string loose = file("loose.obj", houseObj() + "v 9 9 9\n");
  EXPECT_EQ(with(loose, "--ccv", centres), fromFile);
}

TEST_F(SchemeTest, TessellationsLieOnOneSurfaceWhateverTheirLevel) {
  const std::string in = file("cube.obj", cubeObj());
  auto coarse =
      refinedPoints(in, {"--scheme", "half-box", "--levels", "0", "--tessellate", "2", "--precision", "double"});
  auto fine =
      refinedPoints(in, {"--scheme", "half-box", "--levels", "1", "--tessellate", "1", "--precision", "double"});
  ASSERT_EQ(coarse.size(), 18U);  // 6 faces, 12 edges
  const auto rounded = [](std::vector<Point>& points) {
    for (Point& p : points)
      for (double& x : p) x = std::round(x * 1e9);
    std::sort(points.begin(), points.end());
    return points;
  };
  EXPECT_EQ(rounded(coarse), rounded(fine));
  // A face's limit is its centroid.
  EXPECT_EQ(std::count(coarse.begin(), coarse.end(), Point{0.5e9, 0.5e9, 0}), 1);
}

TEST_F(SchemeTest, TessellationsHaveUnitNormalsAndManyTriangles) {
  const std::string in = file("house.obj", houseObj());
  for (const std::string precision : {"single", "double"}) {
    refine(in, {"--scheme", "half-box", "--levels", "0", "--tessellate", "3", "--normals", "exact", "--precision",
                precision});
    const auto mesh = Io::readObj(path("out.obj"));
    ASSERT_TRUE(mesh);
    // The house is converted by a step: a patch for each of its 2E = 40 vertices.
    EXPECT_EQ(mesh->polygons.faceCount(), 40 * 9);
    ASSERT_EQ(mesh->normals.size(), mesh->positions.size());
    for (std::size_t i = 0; i < mesh->normals.size(); i += 3)
      EXPECT_NEAR(std::hypot(mesh->normals[i], mesh->normals[i + 1], mesh->normals[i + 2]), 1, 1e-6);
  }
}

}  // namespace
}  // namespace honeycomb::Test
