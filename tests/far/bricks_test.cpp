#include "far/conversions/bricks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/support/converted.h"
#include "tests/support/manifold_check.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

/// Rings of n quads between two n-gons, or open.
PolyMesh cylinder(std::size_t n, std::size_t rings, bool caps) {
  PolyMesh mesh;
  for (std::size_t r = 0; r <= rings; ++r) {
    for (const Vec3& p : prism(n).points) {
      if (p[2] < 0) mesh.points.push_back({p[0], p[1], static_cast<double>(r)});
    }
  }
  for (std::size_t r = 0; r < rings; ++r) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      mesh.faces.push_back({r * n + i, r * n + j, (r + 1) * n + j, (r + 1) * n + i});
    }
  }
  Loop bottom, top;
  for (std::size_t i = 0; i < n && caps; ++i) {
    bottom.push_back(n - 1 - i);
    top.push_back(rings * n + i);
  }
  if (caps) mesh.faces.insert(mesh.faces.end(), {bottom, top});
  return mesh;
}

/// A prism whose caps are fans of triangles.
PolyMesh fanCappedPrism(std::size_t n) {
  PolyMesh mesh = prism(n);
  const Loop bottom = mesh.faces[n], top = mesh.faces[n + 1];
  mesh.faces.resize(n);
  for (const Loop& cap : {bottom, top}) {
    for (std::size_t i = 0; i < n; ++i) mesh.faces.push_back({cap[i], cap[(i + 1) % n], mesh.points.size()});
    mesh.points.push_back(centroid(corners(mesh, mesh.faces.size() - n)));
  }
  return mesh;
}

std::map<std::size_t, std::size_t> countSides(const PolyMesh& mesh) {
  std::map<std::size_t, std::size_t> counts;
  for (const Loop& loop : mesh.faces) ++counts[loop.size()];
  return counts;
}

PolyMesh laid(const PolyMesh& mesh, std::int32_t rows) {
  return converted(Far::bricks(toTopology(mesh), rows), mesh.points);
}

void expectSound(const PolyMesh& mesh, const PolyMesh& result, const std::string& what) {
  std::string why;
  EXPECT_TRUE(isManifold(result.faces, &why)) << what << ": " << why;
  EXPECT_EQ(eulerCharacteristic(result.faces), eulerCharacteristic(mesh.faces)) << what;
  EXPECT_EQ(boundaryEdgeCount(result.faces), boundaryEdgeCount(mesh.faces)) << what;
}

TEST(Bricks, OfAPrismAreCoursesOfHexagonsBetweenPentagons) {
  for (const std::size_t n : {3U, 5U, 6U, 24U}) {
    const PolyMesh mesh = prism(n);
    for (std::int32_t rows = 2; rows <= 7; ++rows) {
      const std::string what = std::to_string(n) + " sides, " + std::to_string(rows) + " rows";
      const PolyMesh result = laid(mesh, rows);
      const auto courses = static_cast<std::size_t>(rows);
      expectSound(mesh, result, what);
      EXPECT_TRUE(isThreeValent(result)) << what;
      EXPECT_EQ(result.points.size(), 2 * n * courses) << what;
      std::map<std::size_t, std::size_t> sides;
      sides[n] += 2;
      sides[5] += 2 * n;
      if (courses > 2) sides[6] += (courses - 2) * n;
      EXPECT_EQ(countSides(result), sides) << what;
    }
  }
}

TEST(Bricks, LieInTheirCoursesOnTheSidesOfThePrism) {
  const PolyMesh mesh = prism(6);
  for (const std::int32_t rows : {3, 4}) {
    const PolyMesh result = laid(mesh, rows);
    for (std::size_t v = 0; v < 12; ++v) EXPECT_EQ(result.points[v], mesh.points[v]);
    for (std::size_t v = 12; v < result.points.size(); ++v) {
      const Vec3& p = result.points[v];
      const double line = static_cast<double>(1 + (v - 12) / 12);
      EXPECT_NEAR(p[2], -1 + 2 * line / rows, 1e-12);
      // On one of the six sides, whose distance from the axis is sqrt(3)/2, and on its inner side of all others.
      double out = -1;
      for (std::size_t i = 0; i < 6; ++i) {
        const Vec3 middle = 0.5 * (mesh.points[i] + mesh.points[(i + 1) % 6]);
        out = std::max(out, (p[0] * middle[0] + p[1] * middle[1]) / std::hypot(middle[0], middle[1]));
      }
      EXPECT_NEAR(out, std::sqrt(3.0) / 2, 1e-12) << "vertex " << v;
    }
  }
}

TEST(Bricks, AreOffsetByHalfABrick) {
  const PolyMesh mesh = prism(4);
  const PolyMesh result = laid(mesh, 3);
  // Line 1 of three courses: slots over the columns and the middles between them, a third of the way up.
  for (std::size_t slot = 0; slot < 8; ++slot) {
    const std::size_t i = slot / 2, j = (i + slot % 2) % 4;
    const Vec3 low = 0.5 * (mesh.points[i] + mesh.points[j]), high = 0.5 * (mesh.points[4 + i] + mesh.points[4 + j]);
    const Vec3 expected = (2.0 / 3) * low + (1.0 / 3) * high;
    EXPECT_LT(distance(result.points[8 + slot], expected), 1e-12) << "slot " << slot;
  }
}

TEST(Bricks, FillRingUponRing) {
  for (const bool caps : {true, false}) {
    for (const std::size_t rings : {2U, 3U}) {
      for (const std::int32_t rows : {1, 2, 3}) {
        const PolyMesh mesh = cylinder(8, rings, caps);
        const PolyMesh result = laid(mesh, rows);
        const std::string what = std::to_string(rings) + " rings, " + std::to_string(rows) + " rows";
        expectSound(mesh, result, what);
        EXPECT_TRUE(isThreeValent(result)) << what;
        const std::size_t courses = rings * static_cast<std::size_t>(rows);
        EXPECT_EQ(result.faces.size(), 8 * courses + (caps ? 2 : 0)) << what;
      }
    }
  }
}

TEST(Bricks, OfOneRowOnOneRingLeaveThePrism) {
  const PolyMesh mesh = prism(5);
  const PolyMesh result = laid(mesh, 1);
  EXPECT_EQ(result.points, mesh.points);
  EXPECT_EQ(countSides(result), countSides(mesh));
}

TEST(Bricks, KeepFanCapsAndLayACubeOnce) {
  expectSound(fanCappedPrism(7), laid(fanCappedPrism(7), 3), "fans");
  const PolyMesh result = laid(cube(), 4);
  expectSound(cube(), result, "cube");
  EXPECT_TRUE(isThreeValent(result));
  EXPECT_EQ(result.faces.size(), 2U + 16U);
}

TEST(Bricks, ComeFromTheQuadsTheyLieOn) {
  const PolyMesh mesh = cylinder(6, 2, true);
  const auto conversion = Far::bricks(toTopology(mesh), 3);
  ASSERT_TRUE(conversion);
  ASSERT_EQ(conversion->faceSources.size(), 2U + 36U);
  EXPECT_EQ(conversion->faceSources[0], (Far::FaceSource{Far::FaceParent::face, 12}));
  std::map<std::int32_t, int> bricksOf;
  for (std::size_t f = 2; f < conversion->faceSources.size(); ++f) ++bricksOf[conversion->faceSources[f].element];
  EXPECT_EQ(bricksOf.size(), 12U);
  for (const auto& [quad, bricks] : bricksOf) EXPECT_EQ(bricks, 3) << "quad " << quad;
}

TEST(Bricks, RowsSumToOneOverFourVerticesAtMost) {
  const PolyMesh mesh = cylinder(9, 2, true);
  const auto conversion = Far::bricks(toTopology(mesh), 5);
  ASSERT_TRUE(conversion);
  const Far::WeightedRows& rows = conversion->rows;
  for (std::size_t r = 0; r + 1 < rows.offsets.size(); ++r) EXPECT_LE(rows.offsets[r + 1] - rows.offsets[r], 4);
  EXPECT_GT(*std::min_element(rows.weights.begin(), rows.weights.end()), 0);
  const auto sums = Far::apply(*conversion, std::vector<double>(mesh.points.size(), 1.0), 1);
  for (const double sum : *sums) EXPECT_NEAR(sum, 1, 1e-14);
}

/// Largest less smallest distance from the axis in the middle of the refined prism.
double ripple(const PolyMesh& mesh) {
  const SchemeCase scheme = schemeCase(NamedTension::paper);
  double low = 2, high = 0;
  for (const Vec3& p : levelMesh(refined(mesh, scheme.scheme, 4), 4, mesh.points).points) {
    if (std::abs(p[2]) > 0.4) continue;
    low = std::min(low, std::hypot(p[0], p[1]));
    high = std::max(high, std::hypot(p[0], p[1]));
  }
  return high - low;
}

TEST(Bricks, CureThePrismsBumps) {
  const PolyMesh mesh = prism(24);
  const double plain = ripple(mesh);
  EXPECT_GT(plain, 0.05);
  for (const std::int32_t rows : {3, 4, 5}) EXPECT_LT(ripple(laid(mesh, rows)), plain / 10) << rows << " rows";
}

TEST(Bricks, RefuseMeshesWithoutACappedRing) {
  for (const PolyMesh& mesh : {tetrahedron(), dodecahedron(), torus(6, 5), grid(4, 4)}) {
    const auto conversion = Far::bricks(toTopology(mesh), 3);
    ASSERT_FALSE(conversion);
    EXPECT_EQ(conversion.error().code, ErrorCode::invalidMesh);
    EXPECT_THAT(conversion.error().message, HasSubstr("closed ring of quads"));
  }
}

TEST(Bricks, RefuseRowsOutOfRange) {
  for (const std::int32_t rows : {0, -1, 1001}) {
    const auto conversion = Far::bricks(toTopology(prism(6)), rows);
    ASSERT_FALSE(conversion);
    EXPECT_EQ(conversion.error().code, ErrorCode::invalidOption);
    EXPECT_THAT(conversion.error().message, HasSubstr("between 1 and 1000"));
  }
}

}  // namespace
}  // namespace honeycomb::Test
