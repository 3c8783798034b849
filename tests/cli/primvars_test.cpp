#include <algorithm>
#include <cmath>
#include <sstream>

#include "io/obj.h"
#include "workplace.h"

namespace honeycomb::Test {
namespace {

constexpr int kAround = 8, kUp = 3;

/// A cylinder of quads open at both ends, with u once round it. `colours`: of the vertices, their position halved.
/// `seam`: u is 0 and 1 at one line of edges; else it goes up again from the middle on, without a seam.
std::string cylinderObj(bool colours, bool seam) {
  std::ostringstream obj;
  for (int j = 0; j <= kUp; ++j)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 6.283185307179586 * i / kAround, x = std::cos(angle), y = std::sin(angle);
      obj << "v " << x << ' ' << y << ' ' << j;
      if (colours) obj << ' ' << x / 2 << ' ' << y / 2 << ' ' << j / 2.0;
      obj << '\n';
    }
  for (int j = 0; j <= kUp; ++j)
    for (int i = 0; i <= kAround; ++i)
      obj << "vt " << (seam ? i : std::min(i, kAround - i)) / double{kAround} << ' ' << j / double{kUp} << '\n';
  const auto corner = [](int i, int j) {
    return " " + std::to_string(j * kAround + i % kAround + 1) + "/" + std::to_string(j * (kAround + 1) + i + 1);
  };
  for (int j = 0; j < kUp; ++j)
    for (int i = 0; i < kAround; ++i)
      obj << 'f' << corner(i, j) << corner(i + 1, j) << corner(i + 1, j + 1) << corner(i, j + 1) << '\n';
  return obj.str();
}

class PrimvarsTest : public Workplace {
 protected:
  Io::Mesh refined(const std::string& obj, const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"refine", file("in.obj", obj), path("out.obj"), "--precision", "double"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto mesh = Io::readObj(path("out.obj"));
    EXPECT_TRUE(mesh);
    return mesh ? *mesh : Io::Mesh{};
  }
};

/// The largest difference of u between the corners of one face.
double widestFace(const Io::Mesh& mesh) {
  double widest = 0;
  for (std::size_t f = 0; f + 1 < mesh.polygons.faceOffsets.size(); ++f) {
    double low = 1e9, high = -1e9;
    for (auto c = mesh.polygons.faceOffsets[f]; c < mesh.polygons.faceOffsets[f + 1]; ++c) {
      const double u = mesh.texcoords[2 * static_cast<std::size_t>(mesh.cornerTexcoords[static_cast<std::size_t>(c)])];
      low = std::min(low, u);
      high = std::max(high, u);
    }
    widest = std::max(widest, high - low);
  }
  return widest;
}

const std::vector<std::vector<std::string>> kSchemes{{"--scheme", "akleman"},
                                                     {"--scheme", "zhang-wang"},
                                                     {"--scheme", "zhang-wang", "--ccv-offset", "0"},
                                                     {"--scheme", "half-box"}};

TEST_F(PrimvarsTest, ColoursAreRefinedAsPositionsAre) {
  for (const auto& scheme : kSchemes) {
    const Io::Mesh mesh = refined(cylinderObj(true, true), scheme);
    ASSERT_EQ(mesh.colours.size(), mesh.positions.size()) << scheme[1];
    for (std::size_t i = 0; i < mesh.colours.size(); ++i) ASSERT_NEAR(mesh.colours[i], mesh.positions[i] / 2, 1e-5);
  }
}

TEST_F(PrimvarsTest, TextureCoordinatesWithoutASeamAreOneAVertex) {
  for (const auto& scheme : kSchemes) {
    const Io::Mesh mesh = refined(cylinderObj(false, false), scheme);
    EXPECT_TRUE(mesh.colours.empty());
    EXPECT_EQ(mesh.cornerTexcoords, mesh.polygons.indices) << scheme[1];
    EXPECT_LT(widestFace(mesh), 1.5 / kAround);
  }
}

TEST_F(PrimvarsTest, TextureIsNotSmearedAcrossASeam) {
  for (const auto& scheme : kSchemes) {
    const Io::Mesh mesh = refined(cylinderObj(false, true), scheme);
    EXPECT_GT(mesh.texcoords.size(), 2 * mesh.positions.size() / 3) << scheme[1];
    EXPECT_LT(widestFace(mesh), 1.5 / kAround) << scheme[1];
    double least = 1;
    for (std::size_t i = 0; i < mesh.texcoords.size(); i += 2) least = std::min(least, mesh.texcoords[i]);
    EXPECT_LT(least, 0) << "cells on the seam continue their chart beyond it";
  }
}

TEST_F(PrimvarsTest, TextureOfATessellationIsNotSmearedAcrossASeam) {
  for (const std::string normals : {"none", "exact"}) {
    const std::vector<std::string> options{"--scheme",     "half-box", "--levels",  "1",
                                           "--tessellate", "3",        "--normals", normals};
    const Io::Mesh mesh = refined(cylinderObj(false, true), options);
    ASSERT_EQ(mesh.cornerTexcoords.size(), mesh.polygons.indices.size());
    EXPECT_LT(widestFace(mesh), 0.5 / kAround);
    // v is z / 3 everywhere, in whatever chart: nothing is off the surface.
    for (std::size_t c = 0; c < mesh.cornerTexcoords.size(); ++c) {
      const double v = mesh.texcoords[2 * static_cast<std::size_t>(mesh.cornerTexcoords[c]) + 1];
      ASSERT_NEAR(v, mesh.position(mesh.polygons.indices[c])[2] / kUp, 1e-5);
    }
  }
}

TEST_F(PrimvarsTest, FacesWithoutTextureCoordinatesAreAtZero) {
  std::string obj = cylinderObj(false, true);
  obj.replace(obj.rfind("f "), std::string::npos, "f 24 17 25 32\n");
  const Io::Mesh mesh = refined(obj, {"--levels", "1"});
  int atZero = 0;
  for (std::size_t f = 0; f + 1 < mesh.polygons.faceOffsets.size(); ++f) {
    bool zero = true;
    for (auto c = mesh.polygons.faceOffsets[f]; c < mesh.polygons.faceOffsets[f + 1]; ++c) {
      const auto t = 2 * static_cast<std::size_t>(mesh.cornerTexcoords[static_cast<std::size_t>(c)]);
      zero = zero && mesh.texcoords[t] == 0 && mesh.texcoords[t + 1] == 0;
    }
    atZero += zero ? 1 : 0;
  }
  EXPECT_GE(atZero, 1);
}

TEST_F(PrimvarsTest, BakeWritesThemToItsMesh) {
  const std::string obj = cylinderObj(true, true);
  const std::string in = file("in.obj", obj);
  const auto control = Io::readObj(in);
  ASSERT_TRUE(control);
  std::vector<float> frame;
  for (const double x : control->positions) frame.push_back(static_cast<float>(x));
  const std::string motion = cache("in.pc2", control->polygons.vertexCount, 1, frame);
  const Outcome outcome = run({"bake", in, path("out.pc2"), "--cache", motion, "--mesh", path("out.obj")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const Outcome still = run({"refine", in, path("still.obj")});
  ASSERT_EQ(still.exitCode, 0) << still.err;
  EXPECT_EQ(read("out.obj"), read("still.obj"));
}

TEST_F(PrimvarsTest, IsolatedVerticesTakeTheirColoursAlong) {
  const std::string obj = "v 9 9 9 .9 .9 .9\n" + cylinderObj(true, true);
  std::string shifted;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("f ", 0) == 0) {
      std::istringstream corners(line.substr(2));
      line = "f";
      for (std::string corner; corners >> corner;) {
        const std::size_t slash = corner.find('/');
        line += " " + std::to_string(std::stoi(corner.substr(0, slash)) + 1) + corner.substr(slash);
      }
    }
    shifted += line + "\n";
  }
  const Io::Mesh mesh = refined(shifted, {"--drop-isolated"});
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.colours.size(); ++i) ASSERT_NEAR(mesh.colours[i], mesh.positions[i] / 2, 1e-5);
}

TEST_F(PrimvarsTest, TagsThatCannotBeObeyedNameTheirLine) {
  const std::string obj = cubeObj();
  const auto lines = std::to_string(std::count(obj.begin(), obj.end(), '\n') + 2);
  const auto refine = [&](const std::string& tag) {
    return std::vector<std::string>{"refine", file("in.obj", obj + "# tags\n" + tag), path("out.obj")};
  };
  using testing::HasSubstr;
  EXPECT_REFUSED(refine("t crease 2/1/0 0 0 3\n"), HasSubstr("in.obj:" + lines), HasSubstr("crease"));
  EXPECT_REFUSED(refine("t corner 1/1/0 0 10\n"), HasSubstr("in.obj:" + lines), HasSubstr("corner"));
  EXPECT_REFUSED(refine("t crease 2/1/0 0 1\n"), HasSubstr("in.obj:" + lines), HasSubstr("sharpness"));
}

}  // namespace
}  // namespace honeycomb::Test
