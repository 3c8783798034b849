#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "far/conversions/conversions.h"
#include "io/obj.h"
#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

class ConvertTest : public Workplace {
 protected:
  std::vector<std::string> arguments(const std::string& in, const std::string& to,
                                     const std::vector<std::string>& options = {}) const {
    std::vector<std::string> all{"convert", in, path("out.obj"), "--to", to};
    all.insert(all.end(), options.begin(), options.end());
    return all;
  }
  Io::Mesh convert(const std::string& in, const std::string& to, const std::vector<std::string>& options = {}) const {
    const Outcome outcome = run(arguments(in, to, options));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return *Io::readObj(path("out.obj"));
  }
  static std::vector<std::int64_t> sides(const Io::Mesh& mesh) {
    std::vector<std::int64_t> result;
    for (std::size_t f = 0; f + 1 < mesh.polygons.faceOffsets.size(); ++f)
      result.push_back(mesh.polygons.faceOffsets[f + 1] - mesh.polygons.faceOffsets[f]);
    return result;
  }
};

TEST_F(ConvertTest, DualOfTheCubeIsTheOctahedronFacingOutwards) {
  const Io::Mesh dual = convert(file("cube.obj", cubeObj()), "dual");
  ASSERT_EQ(dual.polygons.vertexCount, 6);
  EXPECT_EQ(sides(dual), std::vector<std::int64_t>(8, 3));
  // Vertex f is the centre of face f, in the order of the file.
  EXPECT_THAT(std::vector<double>(dual.positions.begin(), dual.positions.begin() + 6),
              testing::ElementsAre(0.5, 0.5, 0, 0.5, 0.5, 1));
  for (std::size_t f = 0; f < 8; ++f) {
    const auto corner = [&](std::size_t k) { return dual.position(dual.polygons.indices[3 * f + k]); };
    const auto a = corner(0), b = corner(1), c = corner(2);
    double volume = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      volume += (a[i] - 0.5) * ((b[j] - 0.5) * (c[k] - 0.5) - (b[k] - 0.5) * (c[j] - 0.5));
    }
    EXPECT_NEAR(volume, 0.125, 1e-12) << "face " << f;
  }
}

TEST_F(ConvertTest, DualOfABorderedMeshHasAFaceForEachInsideVertex) {
  const Io::Mesh dual = convert(file("grid.obj", gridObj(5)), "dual");
  EXPECT_EQ(dual.polygons.vertexCount, 25);
  EXPECT_EQ(sides(dual), std::vector<std::int64_t>(16, 4));
}

TEST_F(ConvertTest, FacesWithoutInsideVerticesMakeNoDualVertex) {
  // A triangle on the rim touches the boundary with all its corners.
  const std::string obj = gridObj(2) + "v 2 0 0\nf 3 10 6\n";
  EXPECT_EQ(convert(file("grid.obj", obj), "dual").polygons.vertexCount, 4);
}

TEST_F(ConvertTest, TrianglesFanFromTheMeanOfEachFace) {
  const Io::Mesh triangles = convert(file("cube.obj", cubeObj()), "triangles");
  EXPECT_EQ(triangles.polygons.vertexCount, 14);
  EXPECT_EQ(sides(triangles), std::vector<std::int64_t>(24, 3));
  // f 1 4 3 2 is the first face, its centre the ninth vertex.
  EXPECT_THAT(std::vector<std::int32_t>(triangles.polygons.indices.begin(), triangles.polygons.indices.begin() + 6),
              testing::ElementsAre(0, 3, 8, 3, 2, 8));
  EXPECT_THAT(triangles.position(8), testing::ElementsAre(0.5, 0.5, 0));
}

TEST_F(ConvertTest, OrderOfFacesIsTheFilesWhateverTheirSides) {
  const std::string obj = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 4 1 0\nf 1 2 3 4\nf 2 5 3\n";
  const Io::Mesh triangles = convert(file("mixed.obj", obj), "triangles");
  EXPECT_THAT(triangles.position(5), testing::ElementsAre(1, 1, 0));
  EXPECT_THAT(triangles.polygons.indices[2], 5);
  EXPECT_THAT(triangles.polygons.indices[14], 6);
}

TEST_F(ConvertTest, ValenceTwoVertexHasNoDualFace) {
  // Two hexagons back to back: every vertex lies between two faces only.
  const std::string pillow = "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 2 0\nv -1 1 0\nf 1 2 3 4 5 6\nf 6 5 4 3 2 1\n";
  EXPECT_REFUSED((std::vector<std::string>{"convert", file("pillow.obj", pillow), path("out.obj"), "--to", "dual"}),
                 HasSubstr("pillow.obj:1: vertex 1 has 2 faces"));
}

TEST_F(ConvertTest, AllBoundaryMeshHasNoDual) {
  EXPECT_REFUSED((std::vector<std::string>{"convert", file("quad.obj", gridObj(1)), path("out.obj"), "--to", "dual"}),
                 HasSubstr("quad.obj"), HasSubstr("boundary"));
}

TEST_F(ConvertTest, UnknownTargetIsRefusedWithAList) {
  EXPECT_REFUSED(arguments(file("cube.obj", cubeObj()), "bicks"),
                 HasSubstr("dual, truncate, triangles, quads, hexagonal, inverse-dual, bricks"));
}

TEST_F(ConvertTest, TruncateCutsCornersAtTheRatio) {
  const std::string cube = file("cube.obj", cubeObj());
  const Io::Mesh third = convert(cube, "truncate");
  EXPECT_EQ(third.polygons.vertexCount, 24);
  EXPECT_EQ(std::ranges::count(sides(third), 8), 6);
  EXPECT_EQ(std::ranges::count(sides(third), 3), 8);
  EXPECT_THAT(third.positions, testing::Contains(testing::DoubleNear(1.0 / 3, 1e-15)));
  const Io::Mesh quarter = convert(cube, "truncate", {"--ratio", "0.25"});
  EXPECT_THAT(quarter.positions, testing::Each(testing::AnyOf(0, 0.25, 0.75, 1)));
}

TEST_F(ConvertTest, QuadsCutFacesOfEvenSides) {
  const Io::Mesh quads = convert(file("cube.obj", cubeObj()), "quads");
  EXPECT_EQ(quads.polygons.vertexCount, 14);
  EXPECT_EQ(sides(quads), std::vector<std::int64_t>(12, 4));
}

TEST_F(ConvertTest, HexagonalMeshesHaveThreeEdgesAVertex) {
  const Io::Mesh torus = convert(file("torus.obj", torusObj(6)), "hexagonal");
  EXPECT_EQ(torus.polygons.vertexCount, 144);
  EXPECT_EQ(torus.polygons.indices.size(), 3U * 144U);
}

TEST_F(ConvertTest, InverseDualHasTheVerticesAsCentroids) {
  // Cut from its centres, the cube has colours that balance.
  convert(file("cube.obj", cubeObj()), "triangles");
  const Io::Mesh triangles = *Io::readObj(path("out.obj"));
  const Io::Mesh inverse = convert(file("triangles.obj", read("out.obj")), "inverse-dual");
  ASSERT_EQ(inverse.polygons.faceCount(), 14);
  for (std::size_t f = 0; f < 14; ++f) {
    const auto begin = static_cast<std::size_t>(inverse.polygons.faceOffsets[f]);
    const auto end = static_cast<std::size_t>(inverse.polygons.faceOffsets[f + 1]);
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i) sum += inverse.position(inverse.polygons.indices[i])[k];
      EXPECT_NEAR(sum / static_cast<double>(end - begin), triangles.positions[3 * f + k], 1e-9);
    }
  }
}

TEST_F(ConvertTest, InverseDualSaysWhenThereIsNone) {
  const std::string octahedron =
      "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1.5\nv 0 0 -1\n"
      "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
  EXPECT_REFUSED(arguments(file("octahedron.obj", octahedron), "inverse-dual"), HasSubstr("octahedron.obj"),
                 HasSubstr("there is no inverse dual"));
  EXPECT_REFUSED(arguments(file("cube.obj", cubeObj()), "inverse-dual"), HasSubstr("cube.obj:9: face 1"),
                 HasSubstr("4 sides"));
  EXPECT_REFUSED(arguments(file("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "inverse-dual"),
                 HasSubstr("open.obj:1: vertex 1"), HasSubstr("boundary"));
}

TEST_F(ConvertTest, BricksLayTheSidesOfAPrism) {
  const std::string cube = file("cube.obj", cubeObj());
  EXPECT_EQ(convert(cube, "bricks").polygons.faceCount(), 2 + 4 * 4);
  EXPECT_EQ(convert(cube, "bricks", {"--rows", "7"}).polygons.faceCount(), 2 + 7 * 4);
  EXPECT_REFUSED(arguments(file("grid.obj", gridObj(3)), "bricks"), HasSubstr("grid.obj: "), HasSubstr("closed ring"));
}

TEST_F(ConvertTest, OptionsOutOfRangeAreRefused) {
  const std::string cube = file("cube.obj", cubeObj());
  for (const std::string ratio : {"0", "0.5", "-1", "nan"})
    EXPECT_REFUSED(arguments(cube, "truncate", {"--ratio", ratio}), HasSubstr("--ratio"),
                   HasSubstr("between 0 and 0.5"));
  for (const std::string rows : {"0", "-3", "1001"})
    EXPECT_REFUSED(arguments(cube, "bricks", {"--rows", rows}), HasSubstr("--rows " + rows),
                   HasSubstr("between 1 and 1000"));
}

TEST_F(ConvertTest, OptionsOfOtherTargetsAreRefused) {
  const std::string cube = file("cube.obj", cubeObj());
  EXPECT_REFUSED(arguments(cube, "dual", {"--ratio", "0.25"}), HasSubstr("--ratio 0.25: --to dual has no ratio"));
  EXPECT_REFUSED(arguments(cube, "truncate", {"--rows", "3"}), HasSubstr("--rows 3: --to truncate has no rows"));
}

TEST_F(ConvertTest, JsonSummaryHasItsFields) {
  const Outcome outcome = run(arguments(file("cube.obj", cubeObj()), "bricks", {"--rows", "3", "--json"}));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const auto summary = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(summary.at("to"), "bricks");
  EXPECT_EQ(summary.at("vertices"), 24);
  EXPECT_EQ(summary.at("faces"), 14);
  EXPECT_EQ(summary.at("dropped_vertices"), 0);
  EXPECT_EQ(summary.at("output"), path("out.obj"));
}

TEST_F(ConvertTest, RowsCarryAnyPrimvar) {
  Far::Polygons square;
  square.vertexCount = 4;
  square.addFace({0, 1, 2, 3});
  const auto topology = Far::Topology::create(square);
  ASSERT_TRUE(topology);
  const auto triangles = Far::triangulate(*topology);
  ASSERT_TRUE(triangles);
  const std::vector<double> uv{0, 0, 1, 0, 1, 1, 0, 1};
  EXPECT_THAT(*Far::apply(*triangles, uv, 2), testing::ElementsAre(0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5));
}

/// A cube of colours x y z, each side with a chart of its own: the unit square, beside that of the side before.
std::string chartedCubeObj() {
  static constexpr std::string_view kSides[] = {"1 4 3 2", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"};
  std::string obj, faces;
  for (const std::string_view v : {"0 0 0", "1 0 0", "1 1 0", "0 1 0", "0 0 1", "1 0 1", "1 1 1", "0 1 1"})
    obj += "v " + std::string(v) + " " + std::string(v) + "\n";
  for (int f = 0; f < 6; ++f) {
    faces += "f";
    for (int k = 0; k < 4; ++k) {
      const std::string u = std::to_string(2 * f + (k == 1 || k == 2 ? 1 : 0));
      obj += "vt " + u + (k < 2 ? " 0\n" : " 1\n");
      faces += std::string(" ") + kSides[f][2 * static_cast<std::size_t>(k)] + "/" + std::to_string(4 * f + k + 1);
    }
    faces += "\n";
  }
  return obj + faces;
}

TEST_F(ConvertTest, ColoursComeAlong) {
  const std::string cube = file("cube.obj", chartedCubeObj());
  for (const std::string to : {"dual", "truncate", "triangles", "quads", "hexagonal", "bricks"}) {
    const Io::Mesh mesh = convert(cube, to);
    ASSERT_EQ(mesh.colours.size(), mesh.positions.size()) << to;
    for (std::size_t i = 0; i < mesh.colours.size(); ++i) ASSERT_NEAR(mesh.colours[i], mesh.positions[i], 1e-12) << to;
  }
}

/// u and v of each corner of face f.
std::vector<double> faceTexcoords(const Io::Mesh& mesh, std::size_t f) {
  std::vector<double> values;
  for (auto c = mesh.polygons.faceOffsets[f]; c < mesh.polygons.faceOffsets[f + 1]; ++c) {
    const auto t = 2 * static_cast<std::ptrdiff_t>(mesh.cornerTexcoords[static_cast<std::size_t>(c)]);
    values.insert(values.end(), mesh.texcoords.begin() + t, mesh.texcoords.begin() + t + 2);
  }
  return values;
}

TEST_F(ConvertTest, ChartsStayApartWhereFacesAreCut) {
  const std::string cube = file("cube.obj", chartedCubeObj());
  const Io::Mesh triangles = convert(cube, "triangles");
  ASSERT_EQ(triangles.cornerTexcoords.size(), 72U);
  EXPECT_THAT(faceTexcoords(triangles, 0), testing::ElementsAre(0, 0, 1, 0, 0.5, 0.5));
  EXPECT_THAT(faceTexcoords(triangles, 23), testing::ElementsAre(10, 1, 10, 0, 10.5, 0.5));
  const Io::Mesh quads = convert(cube, "quads");
  ASSERT_EQ(quads.cornerTexcoords.size(), 48U);
  EXPECT_THAT(faceTexcoords(quads, 2), testing::ElementsAre(2.5, 0.5, 2, 0, 3, 0, 3, 1));
}

TEST_F(ConvertTest, ChartsGoOnBeyondTheirSeamWhereCornersAreCut) {
  const std::string cube = file("cube.obj", chartedCubeObj());
  convert(cube, "quads");
  const std::string quads = file("quads.obj", read("out.obj"));
  for (const auto& [in, to] : {std::pair{cube, "truncate"}, {quads, "hexagonal"}}) {
    const Io::Mesh mesh = convert(in, to);
    ASSERT_EQ(mesh.cornerTexcoords.size(), mesh.polygons.indices.size()) << to;
    ASSERT_GE(mesh.polygons.faceCount(), 14) << to;
    for (std::size_t f = 0; f < static_cast<std::size_t>(mesh.polygons.faceCount()); ++f) {
      double low = 1e9, high = -1e9;
      const std::vector<double> values = faceTexcoords(mesh, f);
      for (std::size_t i = 0; i < values.size(); i += 2) {
        low = std::min(low, values[i]);
        high = std::max(high, values[i]);
      }
      // Charts begin 2 apart.
      EXPECT_LT(high - low, 1.2) << to << ", face " << f;
      EXPECT_GT(high - low, 0.2) << to << ", face " << f;
    }
  }
}

TEST_F(ConvertTest, TextureWithoutSeamsComesAlong) {
  std::string obj = gridObj(4), corners;
  for (int i = 0; i < 25; ++i) obj += "vt " + std::to_string(i % 5 * 2) + " " + std::to_string(i / 5 * 3) + "\n";
  for (const char c : obj.substr(obj.find("f "), obj.find("vt ") - obj.find("f "))) corners += c;
  const Io::Mesh plain = convert(file("plain.obj", gridObj(4)), "dual");
  EXPECT_TRUE(plain.cornerTexcoords.empty());
  std::string textured = obj.substr(0, obj.find("f ")) + obj.substr(obj.find("vt "));
  std::istringstream lines(corners);
  for (std::string line; std::getline(lines, line); textured += "\n") {
    std::istringstream numbers(line.substr(2));
    textured += "f";
    for (std::string v; numbers >> v;) textured += " " + v + "/" + v;
  }
  const Io::Mesh dual = convert(file("textured.obj", textured), "dual");
  EXPECT_EQ(dual.cornerTexcoords, dual.polygons.indices);
  for (std::size_t v = 0; v < 16; ++v) EXPECT_NEAR(dual.texcoords[2 * v], 8 * dual.positions[3 * v], 1e-12);
}

TEST_F(ConvertTest, SeamsThatCannotBeFollowedAreLeftOut) {
  const std::string cube = file("cube.obj", chartedCubeObj());
  for (const auto& [to, leftOut] : {std::pair{"dual", true}, {"bricks", true}, {"quads", false}}) {
    const Outcome outcome = run(arguments(cube, to, {"--json"}));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out).at("texcoords_left_out"), leftOut) << to;
    EXPECT_EQ(Io::readObj(path("out.obj"))->cornerTexcoords.empty(), leftOut) << to;
  }
}

}  // namespace
}  // namespace honeycomb::Test
