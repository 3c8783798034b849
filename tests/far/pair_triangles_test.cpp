#include "far/conversions/pair_triangles.h"

#include <gmock/gmock.h>

#include <array>
#include <vector>

#include "far/topology/topology.h"

namespace honeycomb::Test {
namespace {

using testing::ElementsAre;

/// Vertices of a grid of n x n unit squares in the plane.
std::vector<double> gridPoints(int n) {
  std::vector<double> points;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) points.insert(points.end(), {double(x), double(y), 0.0});
  return points;
}

/// The same squares cut into triangles, along one diagonal or the other by turns.
Far::Polygons cutGrid(int n) {
  Far::Polygons mesh;
  mesh.vertexCount = (n + 1) * (n + 1);
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const std::int32_t a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
      const bool other = (x * 7 + y * 3) % 5 < 2;
      mesh.addFace(other ? std::vector{a, b, d} : std::vector{a, b, c});
      mesh.addFace(other ? std::vector{b, c, d} : std::vector{a, c, d});
    }
  }
  return mesh;
}

TEST(PairTriangles, EverySquareOfACutGridComesBack) {
  const Far::TrianglePairing paired = Far::pairTriangles(cutGrid(6), gridPoints(6), {});
  EXPECT_EQ(paired.quads, 36);
  EXPECT_EQ(paired.polygons.faceCount(), 36);
  for (std::int64_t f = 0; f < 36; ++f) {
    const auto first = paired.polygons.indices.begin() + 4 * f;
    std::vector<std::int32_t> corners(first, first + 4);
    std::sort(corners.begin(), corners.end());
    EXPECT_THAT(corners, ElementsAre(corners[0], corners[0] + 1, corners[0] + 7, corners[0] + 8)) << f;
  }
  EXPECT_TRUE(Far::Topology::create(paired.polygons));
}

TEST(PairTriangles, CornersKeepWhatTheyWere) {
  Far::Polygons two;
  two.vertexCount = 4;
  two.addFace({0, 1, 2});
  two.addFace({0, 2, 3});
  const std::vector<double> square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const Far::TrianglePairing paired = Far::pairTriangles(two, square, std::vector<std::int32_t>{5, 6, 7, 5, 7, 8});
  EXPECT_THAT(paired.polygons.indices, ElementsAre(2, 3, 0, 1));
  EXPECT_THAT(paired.sourceCorners, ElementsAre(2, 5, 0, 1));
  EXPECT_THAT(paired.sourceFaces, ElementsAre(0));
}

class KeptEdge : public testing::Test {
 protected:
  KeptEdge() {
    two_.vertexCount = 4;
    two_.addFace({0, 1, 2});
    two_.addFace({0, 2, 3});
  }
  std::int64_t quads(const std::vector<double>& points, const std::vector<std::int32_t>& keys = {}) const {
    return Far::pairTriangles(two_, points, keys).quads;
  }
  Far::Polygons two_;
  std::vector<double> square_{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
};

TEST_F(KeptEdge, WhereTextureCoordinatesDiffer) {
  EXPECT_EQ(quads(square_), 1);
  EXPECT_EQ(quads(square_, {1, 2, 3, 1, 3, 4}), 1);
  EXPECT_EQ(quads(square_, {1, 2, 3, 9, 3, 4}), 0);
  EXPECT_EQ(quads(square_, {1, 2, 3, 1, 9, 4}), 0);
}

TEST_F(KeptEdge, WhereItIsCreased) {
  two_.creases = {{2, 0, 1.0}};
  EXPECT_EQ(quads(square_), 0);
}

TEST_F(KeptEdge, WhereTheQuadWouldBeBentSkewedOrNotConvex) {
  EXPECT_EQ(quads({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1}), 0);      // bent
  EXPECT_EQ(quads({0, 0, 0, 3, 1, 0, 5, 2, 0, 2, 1, 0}), 0);      // flat as a needle
  EXPECT_EQ(quads({0, 0, 0, 1, 0, 0, 0.3, 0.3, 0, 0, 1, 0}), 0);  // an arrow head
  EXPECT_EQ(quads({0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0}), 0);      // no area
}

// A tetrahedron pressed flat: two squares back to back, whose diagonals end at vertices with three edges.
TEST(PairTriangles, NoVertexInsideIsLeftWithTwoEdges) {
  Far::Polygons tetrahedron;
  tetrahedron.vertexCount = 4;
  for (const auto& loop : {std::vector{0, 2, 1}, std::vector{0, 1, 3}, std::vector{1, 2, 3}, std::vector{2, 0, 3}})
    tetrahedron.addFace(loop);
  const std::vector<double> flat{0, 0, 0, 1, 0, 0.01, 1, 1, 0, 0, 1, 0.01};
  EXPECT_EQ(Far::pairTriangles(tetrahedron, flat, {}).quads, 0);
}

}  // namespace
}  // namespace honeycomb::Test
