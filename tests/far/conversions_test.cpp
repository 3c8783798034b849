#include "far/conversions/conversions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "far/conversions/inverse_dual.h"
#include "tests/support/converted.h"
#include "tests/support/golden.h"
#include "tests/support/manifold_check.h"
#include "tests/support/mesh_compare.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;

struct Named {
  std::string folder;
  Result<Far::Conversion> (*convert)(const Far::Topology&);
};
Result<Far::Conversion> truncateByThirds(const Far::Topology& topology) {
  return Far::truncate(topology);
}
const std::vector<Named> kConversions{{"dual", Far::dual},
                                      {"triangulate", Far::triangulate},
                                      {"quads", Far::quads},
                                      {"trisect", truncateByThirds},
                                      {"hexagonal", Far::hexagonal}};

std::vector<ManifestLine> goldenConversions() {
  std::vector<ManifestLine> lines;
  for (const ManifestLine& line : readManifest()) {
    const GoldenMeshName name = splitGoldenName(line.file);
    const bool listed =
        std::any_of(kConversions.begin(), kConversions.end(), [&](const Named& n) { return n.folder == name.folder; });
    if (listed && name.level == 1) lines.push_back(line);
  }
  return lines;
}

class GoldenConversion : public testing::TestWithParam<ManifestLine> {};

TEST_P(GoldenConversion, IsTheSameMesh) {
  const GoldenMeshName name = splitGoldenName(GetParam().file);
  const auto conversion =
      std::find_if(kConversions.begin(), kConversions.end(), [&](const Named& n) { return n.folder == name.folder; });
  const PolyMesh source = readGoldenMesh(name.shape + ".obj");
  const PolyMesh mesh = converted(conversion->convert(toTopology(source)), source.points);
  const MeshMatch match = matchMeshes(readGoldenMesh(GetParam().file), mesh, 1e-12);
  EXPECT_TRUE(match.same) << match.why;
  const Far::Topology topology = toTopology(mesh);
  EXPECT_EQ(topology.vertexCount(), std::stoi(GetParam().vertices));
  EXPECT_EQ(topology.edgeCount(), std::stoi(GetParam().edges));
  EXPECT_EQ(topology.faceCount(), std::stoi(GetParam().faces));
  EXPECT_EQ(topology.eulerCharacteristic(), std::stoi(GetParam().euler));
  EXPECT_EQ(topology.boundaryEdgeCount(), std::stoi(GetParam().boundaryEdges));
}

std::string conversionName(const testing::TestParamInfo<ManifestLine>& info) {
  const GoldenMeshName name = splitGoldenName(info.param.file);
  return name.folder + "_" + name.shape;
}

INSTANTIATE_TEST_SUITE_P(Shapes, GoldenConversion, testing::ValuesIn(goldenConversions()), conversionName);

TEST(Conversions, HaveGoldenMeshesOfAllShapes) {
  EXPECT_EQ(goldenConversions().size(), 4U * 8U);
}

TEST(Conversions, RowsSumToOneAndNoWeightIsNegative) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Far::Topology topology = toTopology(randomMesh(seed).mesh);
    for (const Named& named : kConversions) {
      const auto conversion = named.convert(topology);
      if (!conversion) continue;
      const Far::WeightedRows& rows = conversion->rows;
      ASSERT_EQ(rows.offsets.size(), static_cast<std::size_t>(conversion->polygons.vertexCount) + 1);
      EXPECT_GE(*std::min_element(rows.weights.begin(), rows.weights.end()), 0) << named.folder << " of seed " << seed;
      const std::vector<double> ones(static_cast<std::size_t>(topology.vertexCount()), 1.0);
      const auto sums = Far::apply(*conversion, ones, 1);
      for (const double sum : *sums) ASSERT_NEAR(sum, 1, 1e-12) << named.folder;
    }
  }
}

TEST(Conversions, CarryPrimvarsOfAnyLengthAsTheyCarryPositions) {
  const PolyMesh mesh = randomMesh(3).mesh;
  const Far::Topology topology = toTopology(mesh);
  std::vector<double> values;
  for (const Vec3& p : mesh.points) values.insert(values.end(), {p[2], 7.0, p[0], p[1], p[0]});
  for (const Named& named : kConversions) {
    const auto conversion = named.convert(topology);
    if (!conversion) continue;
    const PolyMesh expected = converted(conversion, mesh.points);
    const auto carried = Far::apply(*conversion, values, 5);
    ASSERT_TRUE(carried);
    ASSERT_EQ(carried->size(), 5 * expected.points.size());
    for (std::size_t v = 0; v < expected.points.size(); ++v) {
      const Vec3& p = expected.points[v];
      EXPECT_EQ((Vec3{(*carried)[5 * v + 2], (*carried)[5 * v + 3], (*carried)[5 * v]}), p) << named.folder;
      EXPECT_NEAR((*carried)[5 * v + 1], 7, 1e-12);
    }
  }
}

/// Does the row of a vertex read the source vertex, or, for a face, nothing but its corners?
bool comesFrom(const Far::WeightedRows& rows, std::size_t vertex, const Far::FaceSource& source, const PolyMesh& mesh) {
  const auto begin = rows.indices.begin() + at(rows.offsets, vertex);
  const auto end = rows.indices.begin() + at(rows.offsets, vertex + 1);
  if (source.kind == Far::FaceParent::vertex) return std::find(begin, end, source.element) != end;
  const Loop& face = at(mesh.faces, source.element);
  return std::all_of(begin, end, [&](std::int32_t v) {
    return std::find(face.begin(), face.end(), static_cast<std::size_t>(v)) != face.end();
  });
}

TEST(Conversions, FacesNameTheFaceOrVertexTheyAreMadeOf) {
  for (const std::uint64_t seed : {1U, 2U, 4U, 5U, 7U}) {
    const PolyMesh mesh = randomMesh(seed).mesh;
    for (const Named& named : kConversions) {
      const auto conversion = named.convert(toTopology(mesh));
      if (!conversion) continue;
      const PolyMesh result = converted(conversion, mesh.points);
      ASSERT_EQ(conversion->faceSources.size(), result.faces.size());
      for (std::size_t f = 0; f < result.faces.size(); ++f) {
        for (const std::size_t v : result.faces[f])
          ASSERT_TRUE(comesFrom(conversion->rows, v, conversion->faceSources[f], mesh))
              << named.folder << " of seed " << seed << ", face " << f << ", vertex " << v;
      }
    }
  }
}

TEST(Truncate, CutsEdgesAtTheRatio) {
  const PolyMesh mesh = cube();
  const auto conversion = Far::truncate(toTopology(mesh), 0.25);
  const PolyMesh cut = converted(conversion, mesh.points);
  ASSERT_EQ(cut.points.size(), 24U);
  // Vertex 0 is near the first corner of the first face, on the edge to the second.
  const Vec3 expected = 0.75 * mesh.points[mesh.faces[0][0]] + 0.25 * mesh.points[mesh.faces[0][1]];
  EXPECT_LT(distance(cut.points[0], expected), 1e-15);
  for (const Vec3& p : cut.points) {
    Vec3 sorted{std::abs(p[0]), std::abs(p[1]), std::abs(p[2])};
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, (Vec3{0.5, 1, 1}));
  }
  EXPECT_TRUE(isThreeValent(cut));
}

TEST(Truncate, RefusesRatiosThatMakePointsMeet) {
  const Far::Topology topology = toTopology(cube());
  for (const double ratio : {0.0, 0.5, -0.1, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const auto conversion = Far::truncate(topology, ratio);
    ASSERT_FALSE(conversion);
    EXPECT_EQ(conversion.error().code, ErrorCode::invalidOption);
    EXPECT_THAT(conversion.error().message, HasSubstr("(0, 1/2)"));
  }
}

TEST(Truncate, AndDualRefuseInsideVerticesOfTwoFaces) {
  for (const auto& conversion : {Far::dual(toTopology(pillow(5))), Far::truncate(toTopology(pillow(5)))}) {
    ASSERT_FALSE(conversion);
    EXPECT_EQ(conversion.error().code, ErrorCode::invalidMesh);
    EXPECT_EQ(conversion.error().element, 0);
    EXPECT_THAT(conversion.error().message, HasSubstr("vertex 0 (counted from 0) has 2 faces"));
  }
}

void expectHexagonal(const PolyMesh& mesh, const std::vector<std::size_t>& corners, const std::string& what) {
  const auto conversion = Far::hexagonal(toTopology(mesh, corners));
  const PolyMesh result = converted(conversion, mesh.points);
  std::string why;
  EXPECT_TRUE(isManifold(result.faces, &why)) << what << ": " << why;
  EXPECT_TRUE(isThreeValent(result)) << what;
  EXPECT_TRUE(Far::Topology::create(conversion->polygons)) << what;
}

TEST(Hexagonal, IsThreeValentForAnyMesh) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const RandomMesh random = randomMesh(seed);
    expectHexagonal(random.mesh, random.cornerTags, "seed " + std::to_string(seed));
    const auto triangles = Far::triangulate(toTopology(random.mesh));
    expectHexagonal(converted(triangles, random.mesh.points), {}, "triangles of seed " + std::to_string(seed));
  }
  for (const std::size_t n : {3U, 4U, 9U}) {
    expectHexagonal(fan(n), {}, "fan");
    expectHexagonal(wheel(n), {}, "wheel");
    expectHexagonal(pillow(n), {}, "pillow");
    expectHexagonal(grid(n, n), {}, "grid");
  }
}

TEST(Hexagonal, LeavesThreeValentMeshesAsTheyAre) {
  for (const PolyMesh& mesh : {dodecahedron(), prism(7), readGoldenMesh("honeycomb.obj")}) {
    const auto conversion = Far::hexagonal(toTopology(mesh));
    const PolyMesh result = converted(conversion, mesh.points);
    EXPECT_EQ(result.points, mesh.points);
    EXPECT_EQ(result.faces, mesh.faces);
  }
}

TEST(Hexagonal, TakesTheDualOfTriangles) {
  const PolyMesh round = dodecahedron();
  const PolyMesh icosahedron = converted(Far::dual(toTopology(round)), round.points);
  const PolyMesh result = converted(Far::hexagonal(toTopology(icosahedron)), icosahedron.points);
  EXPECT_EQ(result.points.size(), 20U);
  EXPECT_EQ(result.faces.size(), 12U);
}

TEST(Hexagonal, TakesAStepOfTheSchemeOtherwise) {
  const PolyMesh mesh = readGoldenMesh("torus.obj");
  const PolyMesh result = converted(Far::hexagonal(toTopology(mesh)), mesh.points);
  const MeshMatch match = matchMeshes(readGoldenMesh("akleman/torus_L1.obj"), result, 1e-12);
  EXPECT_TRUE(match.same) << match.why;
  const PolyMesh open = readGoldenMesh("grid.obj");
  const PolyMesh openResult = converted(Far::hexagonal(toTopology(open)), open.points);
  const MeshMatch openMatch = matchMeshes(readGoldenMesh("akleman/grid_L1.obj"), openResult, 1e-12);
  EXPECT_TRUE(openMatch.same) << openMatch.why;
}

TEST(Hexagonal, KeepsCornerTags) {
  const PolyMesh square = grid(3, 3);
  const auto conversion = Far::hexagonal(toTopology(square, {0, 3}));
  ASSERT_TRUE(conversion);
  ASSERT_EQ(conversion->polygons.corners.size(), 2U);
  const PolyMesh result = converted(conversion, square.points);
  EXPECT_EQ(at(result.points, conversion->polygons.corners[0]), square.points[0]);
  EXPECT_EQ(at(result.points, conversion->polygons.corners[1]), square.points[3]);
}

TEST(Hexagonal, RefusesRowsThatWouldFillMemory) {
  const auto conversion = Far::hexagonal(toTopology(pillow(9000)));
  ASSERT_FALSE(conversion);
  EXPECT_EQ(conversion.error().code, ErrorCode::tooLarge);
  EXPECT_THAT(conversion.error().message, HasSubstr("162000000 entries"));
}

TEST(Apply, RefusesValuesThatDontFit) {
  const auto conversion = Far::triangulate(toTopology(cube()));
  ASSERT_TRUE(conversion);
  const auto few = Far::apply(*conversion, std::vector<double>(23), 3);
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().code, ErrorCode::invalidOption);
  EXPECT_THAT(few.error().message, HasSubstr("give 24"));
  const auto none = Far::apply(*conversion, {}, 0);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::invalidOption);
}

}  // namespace
}  // namespace honeycomb::Test
