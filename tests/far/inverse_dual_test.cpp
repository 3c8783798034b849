#include "far/conversions/inverse_dual.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "far/conversions/conversions.h"
#include "tests/support/converted.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;
using Matrix = std::vector<std::vector<double>>;

PolyMesh icosahedron() {
  const PolyMesh round = dodecahedron();
  return converted(Far::dual(toTopology(round)), round.points);
}

PolyMesh octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// Apexes 0 and 1 over a polygon of n corners.
PolyMesh doublePyramid(std::size_t n) {
  PolyMesh mesh{{{0, 0, 1}, {0, 0, -1}}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(n);
    mesh.points.push_back({std::cos(angle), std::sin(angle), 0});
    const std::size_t a = 2 + i, b = 2 + (i + 1) % n;
    mesh.faces.push_back({a, b, 0});
    mesh.faces.push_back({b, a, 1});
  }
  return mesh;
}

/// A torus of m x n quads, each cut in two.
PolyMesh triangleTorus(std::size_t m, std::size_t n) {
  PolyMesh mesh = torus(m, n);
  std::vector<Loop> triangles;
  for (const Loop& quad : mesh.faces) {
    triangles.push_back({quad[0], quad[1], quad[2]});
    triangles.push_back({quad[0], quad[2], quad[3]});
  }
  mesh.faces = triangles;
  return mesh;
}

/// Faces of a random closed mesh cut from their centres. The centres are one colour: never of full rank.
PolyMesh randomTriangles(std::uint64_t seed) {
  const PolyMesh mesh = randomMesh(seed, Border::closed).mesh;
  return converted(Far::triangulate(toTopology(mesh)), mesh.points);
}

std::size_t apex(const Loop& triangle, std::size_t a, std::size_t b) {
  return *std::find_if(triangle.begin(), triangle.end(), [&](std::size_t v) { return v != a && v != b; });
}

/// Flips edges at random, where that makes no edge between vertices that have one.
PolyMesh flipped(PolyMesh mesh, std::size_t flips, Random& random) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> faceOf;
  const auto enter = [&](std::size_t f) {
    const Loop& t = mesh.faces[f];
    for (std::size_t i = 0; i < 3; ++i) faceOf[{t[i], t[(i + 1) % 3]}] = f;
  };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) enter(f);
  for (std::size_t k = 0; k < flips; ++k) {
    const std::size_t f = random.below(mesh.faces.size()), i = random.below(3);
    const std::size_t a = mesh.faces[f][i], b = mesh.faces[f][(i + 1) % 3], g = faceOf.at({b, a});
    const std::size_t c = apex(mesh.faces[f], a, b), d = apex(mesh.faces[g], a, b);
    if (c == d || faceOf.contains({c, d}) || faceOf.contains({d, c})) continue;
    faceOf.erase({a, b});
    faceOf.erase({b, a});
    mesh.faces[f] = {c, a, d};
    mesh.faces[g] = {d, b, c};
    enter(f);
    enter(g);
  }
  return mesh;
}

PolyMesh moved(PolyMesh mesh, double amount) {
  Random random(11);
  for (Vec3& p : mesh.points) p = p + amount * Vec3{random.symmetric(), random.symmetric(), random.symmetric()};
  return mesh;
}

/// Which triangle (column) touches which vertex (row).
Matrix incidence(const PolyMesh& mesh) {
  Matrix matrix(mesh.points.size(), std::vector<double>(mesh.faces.size(), 0));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const std::size_t v : mesh.faces[f]) matrix[v][f] = 1;
  }
  return matrix;
}

/// Brings a matrix to reduced row echelon form; the columns of its pivots.
std::vector<std::size_t> reduce(Matrix& m) {
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < m[0].size() && pivots.size() < m.size(); ++column) {
    const std::size_t row = pivots.size();
    std::size_t best = row;
    for (std::size_t r = row; r < m.size(); ++r) {
      if (std::abs(m[r][column]) > std::abs(m[best][column])) best = r;
    }
    if (std::abs(m[best][column]) < 1e-9) continue;
    std::swap(m[row], m[best]);
    pivots.push_back(column);
    const double pivot = m[row][column];
    for (double& x : m[row]) x /= pivot;
    for (std::size_t r = 0; r < m.size(); ++r) {
      if (r == row || m[r][column] == 0) continue;
      const double factor = m[r][column];
      for (std::size_t c = 0; c < m[r].size(); ++c) m[r][c] -= factor * m[row][c];
    }
  }
  return pivots;
}

bool hasFullRank(const PolyMesh& mesh) {
  Matrix matrix = incidence(mesh);
  return reduce(matrix).size() == matrix.size();
}

/// A basis of the corrections that move no centroid.
Matrix freeCorrections(const PolyMesh& mesh) {
  Matrix reduced = incidence(mesh);
  const std::vector<std::size_t> pivots = reduce(reduced);
  Matrix basis;
  for (std::size_t free = 0, next = 0; free < mesh.faces.size(); ++free) {
    if (next < pivots.size() && pivots[next] == free) {
      ++next;
      continue;
    }
    std::vector<double> vector(mesh.faces.size(), 0);
    vector[free] = 1;
    for (std::size_t r = 0; r < pivots.size(); ++r) vector[pivots[r]] = -reduced[r][free];
    basis.push_back(vector);
  }
  return basis;
}

/// The inverse dual's faces have the triangle mesh's vertices as centroids, in their order.
void expectInterpolation(const PolyMesh& mesh, const std::string& what) {
  const PolyMesh result = converted(Far::inverseDual(toTopology(mesh)), mesh.points);
  ASSERT_EQ(result.faces.size(), mesh.points.size()) << what;
  EXPECT_TRUE(isThreeValent(result)) << what;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_LT(distance(centroid(corners(result, v)), mesh.points[v]), 1e-9) << what << ", vertex " << v;
}

void expectNoSolution(const PolyMesh& mesh, const std::string& what) {
  const auto conversion = Far::inverseDual(toTopology(mesh));
  ASSERT_TRUE(conversion) << what;
  const auto points = Far::apply(*conversion, pack<double>(mesh.points), 3);
  ASSERT_FALSE(points) << what;
  EXPECT_EQ(points.error().code, ErrorCode::invalidPositions) << what;
  EXPECT_THAT(points.error().message, HasSubstr("there is no inverse dual")) << what;
}

TEST(InverseDual, PassesThroughTheVertices) {
  expectInterpolation(tetrahedron(), "tetrahedron");
  expectInterpolation(icosahedron(), "icosahedron");
  expectInterpolation(moved(icosahedron(), 0.2), "moved icosahedron");
  expectInterpolation(triangleTorus(4, 5), "torus");
  expectInterpolation(moved(triangleTorus(20, 31), 0.05), "large torus");
}

TEST(InverseDual, OfRandomMeshesExistsWhereTheIncidenceHasFullRank) {
  Random random(5);
  int solved = 0, singular = 0;
  for (std::uint64_t seed = 0; seed < 60; seed += 2) {
    const PolyMesh cut = randomTriangles(seed);
    if (cut.faces.size() > 160) continue;
    const std::string what = "seed " + std::to_string(seed);
    expectInterpolation(cut, what + " with faces cut from their centres, which balances the colours");
    const PolyMesh mesh = moved(flipped(cut, random.below(20), random), 0.1);
    const auto sound = Far::inverseDual(toTopology(mesh));
    if (!sound) continue;  // a flip took a vertex's third triangle
    const bool full = hasFullRank(mesh);
    ++(full ? solved : singular);
    if (full) expectInterpolation(mesh, what);
    if (!full) expectNoSolution(mesh, what);
  }
  EXPECT_GE(solved, 3);
  EXPECT_GE(singular, 1);
}

TEST(InverseDual, OfThreeColouredMeshesExistsOnlyWhereTheColoursBalance) {
  EXPECT_FALSE(hasFullRank(octahedron()));
  EXPECT_FALSE(hasFullRank(triangleTorus(6, 9)));
  expectInterpolation(octahedron(), "octahedron");
  expectNoSolution(moved(octahedron(), 0.01), "moved octahedron");
  expectNoSolution(moved(triangleTorus(6, 9), 0.01), "moved torus");
}

TEST(InverseDual, OfOddDoublePyramidsExistsOnlyWhereApexesAndCornersBalance) {
  for (const std::size_t n : {3U, 5U, 7U}) {
    PolyMesh mesh = doublePyramid(n);
    EXPECT_FALSE(hasFullRank(mesh));
    expectInterpolation(mesh, "double pyramid");
    mesh.points[0][2] += 0.1;
    expectNoSolution(mesh, "lopsided double pyramid");
  }
}

TEST(InverseDual, TakesTheSmallestCorrection) {
  for (const PolyMesh& mesh : {moved(icosahedron(), 0.2), octahedron(), triangleTorus(4, 5), doublePyramid(5)}) {
    const PolyMesh result = converted(Far::inverseDual(toTopology(mesh)), mesh.points);
    const Matrix freedoms = freeCorrections(mesh);
    EXPECT_GT(freedoms.size(), 0U);
    for (const std::vector<double>& freedom : freedoms) {
      Vec3 product{};
      for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        product = product + freedom[f] * (result.points[f] - centroid(corners(mesh, f)));
      EXPECT_LT(length(product), 1e-9);
    }
  }
}

TEST(InverseDual, CarriesPrimvarsByTheSameMap) {
  const PolyMesh mesh = moved(icosahedron(), 0.2);
  const auto conversion = Far::inverseDual(toTopology(mesh));
  const PolyMesh result = converted(conversion, mesh.points);
  std::vector<double> values;
  for (const Vec3& p : mesh.points) values.insert(values.end(), {1, 2 * p[0] - p[2] + 5});
  const auto carried = Far::apply(*conversion, values, 2);
  ASSERT_TRUE(carried);
  for (std::size_t v = 0; v < result.points.size(); ++v) {
    EXPECT_NEAR((*carried)[2 * v], 1, 1e-12);
    EXPECT_NEAR((*carried)[2 * v + 1], 2 * result.points[v][0] - result.points[v][2] + 5, 1e-9);
  }
}

TEST(InverseDual, NamesTheVertexOfEachFace) {
  const auto conversion = Far::inverseDual(toTopology(icosahedron()));
  ASSERT_TRUE(conversion);
  for (std::int32_t v = 0; v < 12; ++v)
    EXPECT_EQ(at(conversion->faceSources, v), (Far::FaceSource{Far::FaceParent::vertex, v}));
}

TEST(InverseDual, RefusesWhatIsNotAClosedMeshOfTriangles) {
  const auto refused = [](const PolyMesh& mesh, std::int64_t element, const std::string& fragment) {
    const auto conversion = Far::inverseDual(toTopology(mesh));
    ASSERT_FALSE(conversion);
    EXPECT_EQ(conversion.error().code, ErrorCode::invalidMesh);
    EXPECT_EQ(conversion.error().element, element);
    EXPECT_THAT(conversion.error().message, HasSubstr(fragment));
  };
  refused(prism(3), 0, "face 0 (counted from 0) has 4 sides");
  refused(wheel(5), 1, "is on a boundary");
  refused(pillow(3), 0, "vertex 0 (counted from 0) has 2 faces");
}

TEST(InverseDual, RefusesValuesThatAreNotFinite) {
  PolyMesh mesh = icosahedron();
  const auto conversion = Far::inverseDual(toTopology(mesh));
  mesh.points[4][1] = std::numeric_limits<double>::infinity();
  const auto points = Far::apply(*conversion, pack<double>(mesh.points), 3);
  ASSERT_FALSE(points);
  EXPECT_EQ(points.error().code, ErrorCode::invalidPositions);
}

}  // namespace
}  // namespace honeycomb::Test
