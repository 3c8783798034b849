// What holds of every scheme.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "far/schemes/akleman.h"
#include "far/schemes/half_box.h"
#include "far/schemes/zhang_wang.h"
#include "tests/support/golden.h"
#include "tests/support/manifold_check.h"
#include "tests/support/must.h"
#include "tests/support/refined.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

/// The chain of a listed scheme on a random mesh; where the scheme refuses vertices with two edges and there are some,
/// behind a step of honeycomb subdivision, which a chain may start with.
std::vector<Far::Scheme> chainOn(const ListedScheme& scheme, const Far::Topology& control, std::int32_t levels) {
  std::vector<Far::Scheme> chain;
  if (scheme.threeEdges && hasTwoValentVertex(control)) chain.push_back(*Far::akleman());
  const auto steps = must(scheme.chain(control, levels));
  chain.insert(chain.end(), steps.begin(), steps.end());
  return chain;
}

Far::Refinement refine(const Far::Topology& control, const std::vector<Far::Scheme>& chain, bool limits) {
  return must(Far::refine(control, chain, {.limits = limits}));
}

/// Calls body(refinement, random mesh) for every scheme on random meshes, closed and open.
template <class Body>
void onRandomMeshes(std::int32_t levels, bool limits, const Body& body) {
  for (const ListedScheme& scheme : listedSchemes()) {
    for (std::uint64_t seed = 0; seed < meshes(12); ++seed) {
      SCOPED_TRACE(scheme.name + ", seed " + std::to_string(seed));
      const RandomMesh random = randomMesh(seed);
      const Far::Topology control = toTopology(random.mesh);
      ASSERT_NO_FATAL_FAILURE(body(refine(control, chainOn(scheme, control, levels), limits), random));
    }
  }
}

TEST(Schemes, HaveConvexStencils) {
  onRandomMeshes(2, false, [](const Far::Refinement& refinement, const RandomMesh&) {
    for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
      for (const StencilRow& row : expandRows(refinement.level(k).table)) {
        double sum = 0;
        for (const auto& [point, weight] : row) {
          ASSERT_GE(weight, -1e-15);
          sum += weight;
        }
        ASSERT_NEAR(sum, 1, 1e-12) << "level " << k;
      }
    }
  });
}

TEST(Schemes, MakeManifoldsOfTheSameEulerCharacteristicAndKeepClosedMeshesClosed) {
  onRandomMeshes(2, false, [](const Far::Refinement& refinement, const RandomMesh& random) {
    const Far::Topology& control = refinement.level(0).topology;
    for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
      const Far::Topology& topology = refinement.level(k).topology;
      std::string why;
      ASSERT_TRUE(isManifold(toMesh(topology, levelPoints<double>(refinement, k, random.mesh.points)).faces, &why))
          << why;
      ASSERT_EQ(topology.eulerCharacteristic(), control.eulerCharacteristic()) << "level " << k;
      ASSERT_EQ(topology.closed(), control.closed());
    }
  });
}

TEST(Schemes, ArePredictedExactlyOnClosedMeshesAndBoundedOnOpenOnes) {
  for (const ListedScheme& scheme : listedSchemes()) {
    for (std::uint64_t seed = 0; seed < meshes(12); ++seed) {
      SCOPED_TRACE(scheme.name + ", seed " + std::to_string(seed));
      const Far::Topology control = toTopology(randomMesh(seed).mesh);
      const std::vector<Far::Scheme> chain = chainOn(scheme, control, 3);
      const auto predicted = Far::predict(control, chain);
      const Far::Refinement refinement = refine(control, chain, false);
      for (std::int32_t k = 0; k <= refinement.levelCount(); ++k) {
        const Far::LevelCounts& c = predicted[static_cast<std::size_t>(k)];
        const Far::Topology& t = refinement.level(k).topology;
        if (c.exact) {
          ASSERT_EQ(c.vertices, t.vertexCount());
          ASSERT_EQ(c.edges, t.edgeCount());
          ASSERT_EQ(c.faces, t.faceCount());
          ASSERT_EQ(c.halfEdges, t.halfEdgeCount());
          ASSERT_EQ(c.boundaryEdges, t.boundaryEdgeCount());
        } else {
          ASSERT_FALSE(control.closed());
          ASSERT_GE(c.vertices, t.vertexCount());
          ASSERT_GE(c.edges, t.edgeCount());
          ASSERT_GE(c.faces, t.faceCount());
          ASSERT_GE(c.halfEdges, t.halfEdgeCount());
          ASSERT_GE(c.boundaryEdges, t.boundaryEdgeCount());
        }
      }
    }
  }
}

/// The face that each face of the level before becomes.
std::vector<std::int32_t> faceFaces(const Far::Topology& parent, const Far::Topology& child) {
  std::vector<std::int32_t> faces(static_cast<std::size_t>(parent.faceCount()), -1);
  for (std::int32_t f = 0; f < child.faceCount(); ++f) {
    if (child.parentKind(f) == Far::FaceParent::face) at(faces, at(child.parents(), f)) = f;
  }
  return faces;
}

TEST(Schemes, KeepLimitsOfFacesWhereTheyAre) {
  for (const ListedScheme& scheme : listedSchemes()) {
    for (std::uint64_t seed = 0; seed < meshes(12); seed += 2) {  // closed: at a border faces change their shape
      SCOPED_TRACE(scheme.name + ", seed " + std::to_string(seed));
      const RandomMesh random = randomMesh(seed);
      const Far::Topology control = toTopology(random.mesh);
      const Far::Refinement shallow = refine(control, chainOn(scheme, control, 2), true);
      const Far::Refinement deep = refine(control, chainOn(scheme, control, 3), true);
      const std::int32_t last = shallow.levelCount();
      const Limits before = faceLimits<double>(shallow, levelPoints<double>(shallow, last, random.mesh.points));
      const Limits after = faceLimits<double>(deep, levelPoints<double>(deep, last + 1, random.mesh.points));
      const auto images = faceFaces(shallow.last().topology, deep.last().topology);
      for (std::size_t f = 0; f < images.size(); ++f) {
        if (images[f] < 0) continue;
        ASSERT_LT(distance(before.positions[f], at(after.positions, images[f])), 1e-12) << "face " << f;
        // Rounding turns the normals of faces that are all but a point.
        ASSERT_LT(distance(before.normals[f], at(after.normals, images[f])), 1e-6) << "face " << f;
      }
    }
  }
}

/// First row of the matrix of a face in a table: the weights of the corners of `face` in its first corner point.
std::vector<double> faceRow(const Far::Refinement& refinement, std::int32_t level, std::int32_t face) {
  const Far::Topology& parent = refinement.level(level - 1).topology;
  const Far::Topology& child = refinement.level(level).topology;
  const std::int32_t image = at(faceFaces(parent, child), face);
  const StencilRow row = at(expandRows(refinement.level(level).table), child.vert(at(child.faceOffsets(), image)));
  std::vector<double> weights;
  for (std::int32_t h = at(parent.faceOffsets(), face); h < at(parent.faceOffsets(), face + 1); ++h) {
    const auto entry = row.find(parent.vert(h));
    weights.push_back(entry == row.end() ? 0 : entry->second);
  }
  return weights;
}

/// |lambda_j| of the circulant with that first row; the central control vertex is in none but lambda_0.
double eigenvalue(const std::vector<double>& row, int j) {
  std::complex<double> sum = 0;
  for (std::size_t k = 0; k < row.size(); ++k) {
    sum +=
        row[k] * std::polar(1.0, 2 * std::numbers::pi * j * static_cast<double>(k) / static_cast<double>(row.size()));
  }
  return std::abs(sum);
}

TEST(Schemes, ContractFacesByTheirSubdominantEigenvalue) {
  // Level 2, where the half-box steps and central control vertices are what they are from then on.
  const auto contraction = [](const char* shape, const std::string& name, std::int32_t sides) {
    for (const ListedScheme& scheme : listedSchemes()) {
      if (scheme.name != name) continue;
      const Far::Refinement refinement = refinedBy(scheme, toTopology(readGoldenMesh(shape)), 2);
      const Far::Topology& level = refinement.level(refinement.levelCount() - 1).topology;
      for (std::int32_t f = 0; f < level.faceCount(); ++f) {
        if (level.sides(f) == sides) return eigenvalue(faceRow(refinement, refinement.levelCount(), f), 1);
      }
    }
    return 0.0;
  };
  const std::array shapes{std::pair{"cube.obj", 4}, std::pair{"dodecahedron.obj", 5}, std::pair{"hexprism.obj", 6}};
  const std::array akleman{.51518, .56631, .59289}, zhangWang{.47140, .53934, .57735};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto [shape, sides] = shapes[i];
    SCOPED_TRACE(shape);
    EXPECT_NEAR(contraction(shape, "akleman brick", sides), akleman[i], 1e-5);
    EXPECT_NEAR(contraction(shape, "zhang-wang eq16", sides), zhangWang[i], 1e-5);
    EXPECT_NEAR(contraction(shape, "half-box", sides), 0.5, 1e-14);
    EXPECT_NEAR(contraction(shape, "doo-sabin", sides), 0.5, 1e-14);
    EXPECT_NEAR(contraction(shape, "centroid", sides), 0.5, 1e-14);
    // In the midpoint method all new points of a face are middles of its edges.
    EXPECT_NEAR(contraction(shape, "midpoint", sides), std::cos(std::numbers::pi / sides), 1e-14);
  }
}

/// Calls body(sides, first row) for a face of each side count that level 1 of a listed scheme has.
template <class Body>
void forFaceMatrices(const std::string& name, const PolyMesh& mesh, const Body& body) {
  for (const ListedScheme& scheme : listedSchemes()) {
    if (scheme.name != name) continue;
    const Far::Refinement refinement = refinedBy(scheme, toTopology(mesh), 2);
    const std::int32_t last = refinement.levelCount();
    for (const Far::FaceRun& run : refinement.level(last - 1).topology.runs()) {
      body(run.sides, faceRow(refinement, last, run.firstFace));
    }
  }
}

TEST(Schemes, HaveTheSpectraOfTheirFaceMatrices) {
  int matrices = 0;
  for (const std::size_t n : {3U, 4U, 5U, 7U, 8U, 11U}) {
    // lambda_j = (a + (N-5) q)((1-t) + t w^j) for j = 1, N-1, (a - 5 q)(..) otherwise, q = (1-a)/(3N-5), t = 1/2.
    forFaceMatrices("akleman brick", prism(n), [&](std::int32_t sides, const std::vector<double>& row) {
      const double a = 0.45 + 1.25 / sides, q = (1 - a) / (3 * sides - 5);
      for (int j = 1; j < sides; ++j) {
        const double hat = j == 1 || j == sides - 1 ? a + (sides - 5) * q : a - 5 * q;
        EXPECT_NEAR(eigenvalue(row, j), std::abs(hat * std::cos(std::numbers::pi * j / sides)), 1e-14) << sides;
      }
      ++matrices;
    });
    // 1/2, 1/2 and 1/4, of hexagons also the ineffective 1/2 in the block j = 3.
    forFaceMatrices("half-box", prism(n), [&](std::int32_t sides, const std::vector<double>& row) {
      for (int j = 1; j < sides; ++j) {
        const bool half = j == 1 || j == sides - 1 || (sides == 6 && j == 3);
        EXPECT_NEAR(eigenvalue(row, j), half ? 0.5 : 0.25, 1e-14) << sides << ", j = " << j;
      }
      ++matrices;
    });
    forFaceMatrices("centroid", prism(n), [&](std::int32_t sides, const std::vector<double>& row) {
      for (int j = 1; j < sides; ++j) EXPECT_NEAR(eigenvalue(row, j), 0.5, 1e-14) << sides;
      ++matrices;
    });
  }
  EXPECT_GE(matrices, 36);
}

TEST(ZhangWang, HasTheSpectrumOfEquation9) {
  // One step on [corners | central]: 1 and b - a (the central vertex and the mean), b (1 + w^j)/2 otherwise.
  const Far::ZhangWangOptions options;
  const Far::Topology control = toTopology(readGoldenMesh("hexprism.obj"));
  const auto chain = Far::zhangWang(control, 2, options);
  ASSERT_TRUE(chain.has_value());
  const Far::Refinement refinement = std::move(*Far::refine(control, *chain));
  const Far::Topology& parent = refinement.level(1).topology;
  const Far::Topology& child = refinement.level(2).topology;
  const auto rows = expandRows(refinement.level(2).table);
  const auto images = faceFaces(parent, child);
  for (std::int32_t f = 0; f < parent.faceCount(); ++f) {
    const std::int32_t n = parent.sides(f);
    const std::vector<double> corners = faceRow(refinement, 2, f);
    for (int j = 1; j < n; ++j) {
      EXPECT_NEAR(eigenvalue(corners, j), 2.0 / 3 * std::abs(std::cos(std::numbers::pi * j / n)), 1e-14);
    }
    const StencilRow& central = at(rows, child.vertexCount() + at(images, f));
    const double kept = central.at(parent.vertexCount() + f);
    EXPECT_NEAR(kept, 1 - options.pull.at(n), 1e-15);
    // The block of the means: p' = b p + (1-b) q, q' = a p + (1-a) q, with trace 1 + (b - a).
    EXPECT_NEAR(options.spread + kept, 1 + (2.0 / 3 - options.pull.at(n)), 1e-14);
  }
}

TEST(ZhangWang, PassesThroughBarycentresAndInterpolatedVertices) {
  const PolyMesh mesh = readGoldenMesh("mixed.obj");
  const Far::Topology control = toTopology(mesh);
  Far::ZhangWangOptions options;
  for (std::int32_t v = 0; v < control.vertexCount(); v += 3) options.interpolatedVertices.push_back(v);
  const auto chain = Far::zhangWang(control, 1, options);
  ASSERT_TRUE(chain.has_value());
  const Far::Refinement refinement = std::move(*Far::refine(control, *chain, {.limits = true}));
  const Limits limits = faceLimits<double>(refinement, levelPoints<double>(refinement, 1, mesh.points));
  const Far::Topology& level = refinement.level(1).topology;
  for (std::int32_t f = 0; f < level.faceCount(); ++f) {
    const std::int32_t parent = at(level.parents(), f);
    if (level.parentKind(f) == Far::FaceParent::face) {
      const Vec3 centre = centroid(corners(mesh, static_cast<std::size_t>(control.inputFace(parent))));
      ASSERT_LT(distance(at(limits.positions, f), centre), 1e-12);
    } else if (parent % 3 == 0) {
      ASSERT_LT(distance(at(limits.positions, f), at(mesh.points, parent)), 1e-12) << "vertex " << parent;
    }
  }
}

TEST(ZhangWang, RefusesWeightsWithoutATangentPlaneUnlessForced) {
  const Far::Topology control = toTopology(readGoldenMesh("tetrahedron.obj"));
  Far::ZhangWangOptions options;
  options.pull = {Far::CentralPull::Rule::constant, 0.25};  // satisfies eq 12 as printed
  const auto refused = Far::zhangWang(control, 1, options);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("faces of 3 sides would have no tangent plane"), std::string::npos)
      << refused.error().message;
  options.unchecked = true;
  EXPECT_TRUE(Far::zhangWang(control, 1, options).has_value());
}

TEST(ZhangWang, RefusesWeightsWithoutATangentPlaneInTheFacesThatEq16MakesOnTheBoundary) {
  const Far::Topology hexagons = toTopology(readGoldenMesh("honeycomb.obj"));
  Far::ZhangWangOptions options;
  options.pull = {Far::CentralPull::Rule::constant, 0.1};  // enough for 6 sides, not for 5
  options.boundary = Far::BoundaryRule::eq16;
  const auto refused = Far::zhangWang(hexagons, 1, options);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("faces of 5 sides would have no tangent plane"), std::string::npos)
      << refused.error().message;
  options.boundary = Far::BoundaryRule::drop;
  EXPECT_TRUE(Far::zhangWang(hexagons, 1, options).has_value());
}

TEST(ZhangWang, ReadsCentralControlVerticesInTheCallersOrderOfFaces) {
  // A pentagonal prism given with its pentagons first: the product sorts quads before them.
  const PolyMesh mesh = prism(5);
  const Far::Topology control = toTopology(mesh);
  const auto chain = Far::zhangWang(control, 1, {});
  ASSERT_TRUE(chain.has_value());
  const Far::Refinement given = std::move(*Far::refine(control, *chain, {.centralPoints = true}));
  const Far::Refinement barycentres = std::move(*Far::refine(control, *chain));
  std::vector<Vec3> points = mesh.points;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) points.push_back(centroid(corners(mesh, f)));
  const auto expected = levelPoints<double>(barycentres, 1, mesh.points),
             actual = levelPoints<double>(given, 1, points);
  ASSERT_EQ(expected.size(), actual.size());
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_LT(distance(expected[i], actual[i]), 1e-14) << i;
}

/// Lengths of the edges between inside vertices of a level lie this far apart, relatively.
double edgeSpread(const Far::Refinement& refinement, const std::vector<Vec3>& control) {
  const Far::Topology& topology = refinement.last().topology;
  const std::vector<Vec3> points = levelPoints<double>(refinement, refinement.levelCount(), control);
  std::vector<std::uint8_t> inside(points.size(), 1);  // in no face at the boundary
  for (std::int32_t f = 0; f < topology.faceCount(); ++f) {
    const std::int32_t first = at(topology.faceOffsets(), f), end = at(topology.faceOffsets(), f + 1);
    bool border = topology.sides(f) != 6;
    for (std::int32_t h = first; h < end; ++h) border = border || topology.onBoundary(topology.vert(h));
    for (std::int32_t h = first; h < end && border; ++h) at(inside, topology.vert(h)) = 0;
  }
  double low = 1e300, high = 0;
  for (std::int32_t h = 0; h < topology.halfEdgeCount(); ++h) {
    if (at(inside, topology.vert(h)) == 0 || at(inside, topology.dest(h)) == 0) continue;
    const double length = distance(at(points, topology.vert(h)), at(points, topology.dest(h)));
    low = std::min(low, length);
    high = std::max(high, length);
  }
  return high / low - 1;
}

TEST(Schemes, WithLinearPrecisionKeepAHoneycombRegular) {
  const PolyMesh mesh = honeycomb(6);
  const Far::Topology control = toTopology(mesh);
  const auto halfBox = Far::halfBox(control, 2);
  ASSERT_TRUE(halfBox.has_value());
  EXPECT_LT(edgeSpread(std::move(*Far::refine(control, *halfBox)), mesh.points), 1e-13);
  const auto sqrt3 = Far::akleman({.tension = {.rule = Far::Tension::Rule::sqrt3}});
  ASSERT_TRUE(sqrt3.has_value());
  EXPECT_LT(edgeSpread(std::move(*Far::refine(control, *sqrt3, 2)), mesh.points), 1e-13);
  const auto paper = Far::akleman();
  ASSERT_TRUE(paper.has_value());
  EXPECT_GT(edgeSpread(std::move(*Far::refine(control, *paper, 2)), mesh.points), 0.01) << "the paper's a(6) has none";
}

TEST(Schemes, RefuseVerticesThatWouldBecomeFacesOfTwoSides) {
  const Far::Topology control = toTopology(pillow(5));
  for (const ListedScheme& scheme : listedSchemes()) {
    SCOPED_TRACE(scheme.name);
    const auto chain = scheme.chain(control, 1);
    ASSERT_TRUE(chain.has_value());
    const auto refined = Far::refine(control, *chain);
    ASSERT_EQ(refined.has_value(), !scheme.threeEdges);
    if (refined) continue;
    EXPECT_EQ(refined.error().message,
              "vertex 0 (counted from 0) has 2 faces round it, too few to become a face; dissolve it");
    EXPECT_EQ(refined.error().element, 0);
  }
}

}  // namespace
}  // namespace honeycomb::Test
