#include <algorithm>
#include <nlohmann/json.hpp>

#include "far/topology/conversions.h"
#include "io/obj.h"
#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

class ConvertTest : public Workplace {
 protected:
  Io::ObjMesh convert(const std::string& in, const std::string& to) const {
    const Outcome outcome = run({"convert", in, path("out.obj"), "--to", to});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return *Io::readObj(path("out.obj"));
  }
  static std::vector<std::int64_t> sides(const Io::ObjMesh& mesh) {
    std::vector<std::int64_t> result;
    for (std::size_t f = 0; f + 1 < mesh.polygons.faceOffsets.size(); ++f)
      result.push_back(mesh.polygons.faceOffsets[f + 1] - mesh.polygons.faceOffsets[f]);
    return result;
  }
};

TEST_F(ConvertTest, DualOfTheCubeIsTheOctahedronFacingOutwards) {
  const Io::ObjMesh dual = convert(file("cube.obj", cubeObj()), "dual");
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
  const Io::ObjMesh dual = convert(file("grid.obj", gridObj(5)), "dual");
  EXPECT_EQ(dual.polygons.vertexCount, 25);
  EXPECT_EQ(sides(dual), std::vector<std::int64_t>(16, 4));
}

TEST_F(ConvertTest, FacesWithoutInsideVerticesMakeNoDualVertex) {
  // A triangle on the rim touches the boundary with all its corners.
  const std::string obj = gridObj(2) + "v 2 0 0\nf 3 10 6\n";
  EXPECT_EQ(convert(file("grid.obj", obj), "dual").polygons.vertexCount, 4);
}

TEST_F(ConvertTest, TrianglesFanFromTheMeanOfEachFace) {
  const Io::ObjMesh triangles = convert(file("cube.obj", cubeObj()), "triangles");
  EXPECT_EQ(triangles.polygons.vertexCount, 14);
  EXPECT_EQ(sides(triangles), std::vector<std::int64_t>(24, 3));
  // f 1 4 3 2 is the first face, its centre the ninth vertex.
  EXPECT_THAT(std::vector<std::int32_t>(triangles.polygons.indices.begin(), triangles.polygons.indices.begin() + 6),
              testing::ElementsAre(0, 3, 8, 3, 2, 8));
  EXPECT_THAT(triangles.position(8), testing::ElementsAre(0.5, 0.5, 0));
}

TEST_F(ConvertTest, OrderOfFacesIsTheFilesWhateverTheirSides) {
  const std::string obj = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 4 1 0\nf 1 2 3 4\nf 2 5 3\n";
  const Io::ObjMesh triangles = convert(file("mixed.obj", obj), "triangles");
  EXPECT_THAT(triangles.position(5), testing::ElementsAre(1, 1, 0));
  EXPECT_THAT(triangles.polygons.indices[2], 5);
  EXPECT_THAT(triangles.polygons.indices[14], 6);
}

TEST_F(ConvertTest, ValenceTwoVertexHasNoDualFace) {
  // Two hexagons back to back: every vertex lies between two faces only.
  const std::string pillow = "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 2 0\nv -1 1 0\nf 1 2 3 4 5 6\nf 6 5 4 3 2 1\n";
  EXPECT_REFUSED((std::vector<std::string>{"convert", file("pillow.obj", pillow), path("out.obj"), "--to", "dual"}),
                 HasSubstr("pillow.obj:1: vertex 0 (counted from 0) has 2 faces"));
}

TEST_F(ConvertTest, AllBoundaryMeshHasNoDual) {
  EXPECT_REFUSED((std::vector<std::string>{"convert", file("quad.obj", gridObj(1)), path("out.obj"), "--to", "dual"}),
                 HasSubstr("quad.obj"), HasSubstr("boundary"));
}

TEST_F(ConvertTest, UnknownTargetIsRefusedWithAList) {
  EXPECT_REFUSED((std::vector<std::string>{"convert", file("cube.obj", cubeObj()), path("out.obj"), "--to", "bricks"}),
                 HasSubstr("dual, triangles"));
}

TEST_F(ConvertTest, MeansCarryAnyPrimvar) {
  Far::Polygons square;
  square.vertexCount = 4;
  square.addFace({0, 1, 2, 3});
  const auto topology = Far::Topology::create(square);
  ASSERT_TRUE(topology);
  const auto triangles = Far::triangulate(*topology);
  ASSERT_TRUE(triangles);
  const std::vector<double> uv{0, 0, 1, 0, 1, 1, 0, 1};
  EXPECT_THAT(Far::means(*triangles, uv, 2), testing::ElementsAre(0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5));
}

}  // namespace
}  // namespace honeycomb::Test
