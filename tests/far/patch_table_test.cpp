#include "far/tables/patch_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/golden.h"
#include "tests/support/patch_surfaces.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

const std::vector<Far::Barycentric> kPlaces{{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.5, 0.3, 0.2},   {0.1, 0.15, 0.75},
                                            {0.21, 0.44, 0.35},          {0.05, 0.9, 0.05}, {0.62, 0.0, 0.38}};

class GoldenPatches : public testing::TestWithParam<const char*> {};

TEST_P(GoldenPatches, HaveTheirPositionsAndDerivatives) {
  const std::string name = std::string("halfbox-eval/") + GetParam();
  const PatchSurface surface(readGoldenMesh(name + "_control.obj"));
  const auto rows = readGoldenCsv(name + ".csv");
  ASSERT_GE(rows.size(), 24U);
  for (const auto& row : rows) {
    const std::int32_t patch = surface.table.patchOf(std::stoi(row[0]));
    // The file may begin with another of the vertex's faces: place[i] is the patch's corner in its face i.
    std::array<std::size_t, 3> place{};
    for (std::size_t i = 0; i < 3; ++i) place[i] = surface.cornerInFace(patch, std::stoul(row[1 + i]));
    Far::Barycentric u{};
    for (std::size_t i = 0; i < 3; ++i) u[place[i]] = std::stod(row[4 + i]);
    const Far::PatchPoint point = surface.at(patch, u);
    const auto expected = [&](std::size_t column) {
      return Vec3{std::stod(row[column]), std::stod(row[column + 1]), std::stod(row[column + 2])};
    };
    EXPECT_LT(distance(point.position, expected(7)), 1e-9) << "vertex " << row[0] << " at " << row[4];
    EXPECT_LT(distance(along(point, place[0], place[2]), expected(10)), 1e-9) << "vertex " << row[0];
    EXPECT_LT(distance(along(point, place[1], place[2]), expected(13)), 1e-9) << "vertex " << row[0];
  }
}

INSTANTIATE_TEST_SUITE_P(HalfBox, GoldenPatches,
                         testing::Values("tetrahedron", "cube", "dodecahedron", "hexprism", "honeycomb", "torus"));

TEST(PatchCentre, OfHexagonsHasTheExactStencil) {
  const Far::PatchFrameWeights weights = Far::patchCentreWeights({6, 6, 6});
  const double faceWeights[] = {2.0 / 81, 1.0 / 162, 2.0 / 81};
  ASSERT_EQ(weights.position.size(), 13U);
  EXPECT_NEAR(weights.position[0], 19.0 / 54, 1e-15);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(weights.position[i], 13.0 / 81, 1e-15);
  for (std::size_t i = 4; i < 13; ++i) EXPECT_NEAR(weights.position[i], faceWeights[(i - 4) % 3], 1e-15) << i;
}

TEST(PatchCentre, HasItsTangentsInTheOrderThatPointsOutward) {
  for (const PolyMesh& mesh : {tetrahedron(), cube(), prism(3), prism(7), dodecahedron()}) {
    const PatchSurface surface(mesh);
    const Vec3 middle = centroid(mesh.points);
    for (std::int32_t p = 0; p < surface.table.patchCount(); ++p) {
      const Far::PatchFrameWeights weights = Far::patchCentreWeights(surface.table.patch(p).sides());
      const Vec3 centre = surface.weighted(p, weights.position);
      const Vec3 normal = cross(surface.weighted(p, weights.tangent1), surface.weighted(p, weights.tangent2));
      EXPECT_LT(distance(centre, surface.at(p, kPlaces[0]).position), 1e-13);
      EXPECT_GT(dot(normal, centre - middle), 0) << "patch " << p << " of " << mesh.faces.size() << " faces";
    }
  }
}

class PatchSurfaces : public testing::TestWithParam<std::size_t> {
 protected:
  const PatchSurface surface_{threeValentMesh(GetParam())};
  std::int32_t patchCount() const { return surface_.table.patchCount(); }
};

TEST_P(PatchSurfaces, KnowTheirControlPoints) {
  const Far::PatchTable& table = surface_.table;
  for (std::int32_t p = 0; p < patchCount(); ++p) {
    const Far::VertexPatch patch = table.patch(p);
    const std::vector<std::int32_t> points = table.controlPoints(p);
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < 3; ++i) {
      const Loop loop = surface_.loopFrom(patch.faces()[i], table.vertex(p));
      EXPECT_EQ(points[1 + i], static_cast<std::int32_t>(loop[1]));
      EXPECT_EQ(points[1 + (i + 1) % 3], static_cast<std::int32_t>(loop.back()));
      expected.insert(expected.end(), loop.begin() + 2, loop.end() - 1);
      EXPECT_EQ(table.neighbours(p)[i], table.patchOf(static_cast<std::int32_t>(loop.back())));
    }
    EXPECT_EQ(points[0], table.vertex(p));
    EXPECT_EQ(std::vector<std::size_t>(points.begin() + 4, points.end()), expected) << "patch " << p;
  }
}

TEST_P(PatchSurfaces, HaveTheirCornersAtTheCentroidsOfFaces) {
  for (std::int32_t p = 0; p < patchCount(); ++p) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t face = surface_.table.patch(p).faces()[i];
      const std::vector<Vec3> polygon = surface_.polygonFrom(face, surface_.table.vertex(p));
      Far::Barycentric corner{};
      corner[i] = 1;
      const Far::PatchPoint point = surface_.at(p, corner);
      EXPECT_LT(distance(point.position, centroid(polygon)), 1e-13);
      EXPECT_EQ(point.extraordinaryCorner, polygon.size() != 6);
      EXPECT_LT(distance(point.normal, unit(tangentNormal(polygon))), 1e-9) << "corner " << i << " of patch " << p;
    }
  }
}

TEST_P(PatchSurfaces, AreContinuouslyDifferentiableAcrossTheirEdges) {
  for (std::int32_t p = 0; p < patchCount(); ++p) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t q = surface_.table.neighbours(p)[i];
      if (q < 0) continue;
      const std::size_t next = (i + 1) % 3;
      const std::size_t opposite = (i + 2) % 3;
      const std::array<std::int32_t, 3> faces = surface_.table.patch(p).faces();
      const std::size_t qi = surface_.cornerIn(q, faces[i]);
      const std::size_t qNext = surface_.cornerIn(q, faces[next]);
      for (const double t : {0.001, 0.25, 0.4, 0.9}) {
        Far::Barycentric u{};
        Far::Barycentric w{};
        u[i] = w[qi] = 1 - t;
        u[next] = w[qNext] = t;
        const Far::PatchPoint a = surface_.at(p, u);
        const Far::PatchPoint b = surface_.at(q, w);
        EXPECT_LT(distance(a.position, b.position), 1e-13) << "patches " << p << " and " << q << " at " << t;
        EXPECT_LT(distance(along(a, next, i), along(b, qNext, qi)), 1e-12);
        // The neighbour's third corner is the reflection J_i + J_{i+1} - J_{i+2} of the patch's own.
        EXPECT_LT(distance(along(b, 3 - qi - qNext, qi), along(a, next, opposite)), 1e-12);
      }
    }
  }
}

TEST_P(PatchSurfaces, HaveTheDerivativesOfTheirPositions) {
  constexpr double kStep = 1e-4;
  for (std::int32_t p = 0; p < patchCount(); ++p) {
    for (const Far::Barycentric& u : {Far::Barycentric{0.45, 0.3, 0.25}, {0.2, 0.17, 0.63}, {0.61, 0.3, 0.09}}) {
      const auto moved = [&](double du, double dv) { return surface_.at(p, {u[0] + du, u[1] + dv, u[2] - du - dv}); };
      const auto slope = [&](double du, double dv, auto part) {
        return 0.5 / kStep * (moved(du, dv).*part - moved(-du, -dv).*part);
      };
      const Far::PatchPoint point = surface_.at(p, u);
      EXPECT_LT(distance(point.du, slope(kStep, 0, &Far::PatchPoint::position)), 1e-6) << "patch " << p;
      EXPECT_LT(distance(point.dv, slope(0, kStep, &Far::PatchPoint::position)), 1e-6) << "patch " << p;
      EXPECT_LT(distance(point.duu, slope(kStep, 0, &Far::PatchPoint::du)), 1e-6) << "patch " << p;
      EXPECT_LT(distance(point.duv, slope(0, kStep, &Far::PatchPoint::du)), 1e-6) << "patch " << p;
      EXPECT_LT(distance(point.dvv, slope(0, kStep, &Far::PatchPoint::dv)), 1e-6) << "patch " << p;
    }
  }
}

TEST_P(PatchSurfaces, AreTheSameAfterAStepOfRefinement) {
  const HalfBoxStep step(surface_.mesh);
  const PatchSurface refined(step.mesh());
  for (std::int32_t p = 0; p < patchCount(); ++p) {
    const std::int32_t v = surface_.table.vertex(p);
    const std::array<std::int32_t, 3> faces = surface_.table.patch(p).faces();
    std::array<std::size_t, 3> own{};
    std::array<std::size_t, 3> edge{};  // the hexagons of the edges (v, w_i)
    for (std::size_t i = 0; i < 3; ++i) {
      own[i] = surface_.inputFace(faces[i]);
      edge[i] = step.edgeFace(static_cast<std::size_t>(v), at(surface_.table.controlPoints(p), 1 + i));
    }
    for (const Far::Barycentric& u : kPlaces) {
      std::size_t child = step.vertexPoint(static_cast<std::size_t>(v));
      std::array<std::size_t, 3> childFaces = edge;
      Far::Barycentric childU{1 - 2 * u[1], 1 - 2 * u[2], 1 - 2 * u[0]};
      for (std::size_t i = 0; i < 3; ++i) {
        if (u[i] < 0.5) continue;
        child = step.cornerPoint(own[i], static_cast<std::size_t>(v));
        childFaces = {own[i], edge[(i + 1) % 3], edge[i]};
        childU = {2 * u[i] - 1, 2 * u[(i + 1) % 3], 2 * u[(i + 2) % 3]};
      }
      const std::int32_t q = refined.table.patchOf(static_cast<std::int32_t>(child));
      ASSERT_GE(q, 0);
      Far::Barycentric w{};
      for (std::size_t i = 0; i < 3; ++i) w[refined.cornerInFace(q, childFaces[i])] = childU[i];
      const Far::PatchPoint a = surface_.at(p, u);
      const Far::PatchPoint b = refined.at(q, w);
      EXPECT_LT(distance(a.position, b.position), 1e-13) << "patch " << p;
      EXPECT_LT(distance(a.normal, b.normal), 1e-9) << "patch " << p;
    }
  }
}

TEST_P(PatchSurfaces, MeetInTheCentroidOfTheEdgesHexagon) {
  const HalfBoxStep step(surface_.mesh);
  for (std::int32_t p = 0; p < patchCount(); ++p) {
    const auto v = static_cast<std::size_t>(surface_.table.vertex(p));
    for (std::size_t i = 0; i < 3; ++i) {
      Far::Barycentric middle{0.5, 0.5, 0.5};
      middle[(i + 1) % 3] = 0;  // on the edge from corner i-1 to corner i, across (v, w_i)
      const std::size_t hexagon = step.edgeFace(v, at(surface_.table.controlPoints(p), 1 + i));
      EXPECT_LT(distance(surface_.at(p, middle).position, centroid(corners(step.mesh(), hexagon))), 1e-13);
    }
  }
}

TEST_P(PatchSurfaces, ApproachTheTangentPlaneOfExtraordinaryCorners) {
  for (std::int32_t p = 0; p < patchCount(); ++p) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t face = surface_.table.patch(p).faces()[i];
      Far::Barycentric corner{};
      corner[i] = 1;
      const Far::PatchPoint limit = surface_.at(p, corner);
      for (const double d : {0x1p-20, 0x1p-45}) {
        Far::Barycentric u{d, d, d};
        u[i] = 1 - 2 * d;
        const Far::PatchPoint near = surface_.at(p, u);
        // Relative to how flat the corner's frame is: random control polygons can be nearly singular there.
        const std::vector<Vec3> polygon = surface_.polygonFrom(face, surface_.table.vertex(p));
        const double flatness = length(tangentNormal(polygon));
        EXPECT_LT(distance(near.normal, limit.normal), 4e3 * d / flatness + 1e-9) << "patch " << p << " at " << d;
        EXPECT_FALSE(near.extraordinaryCorner);
      }
    }
  }
}

TEST_P(PatchSurfaces, AreCubicsWhereAllFacesAreHexagons) {
  const std::vector<double> bezier = surface_.bezierPoints();
  ASSERT_EQ(bezier.size(), 30 * surface_.table.regularPatches().size());
  for (std::size_t r = 0; r < surface_.table.regularPatches().size(); ++r) {
    const std::int32_t p = surface_.table.regularPatches()[r];
    EXPECT_TRUE(surface_.table.regular(p));
    for (const Far::Barycentric& u : kPlaces) {
      EXPECT_LT(distance(bernstein(bezier, r, u), surface_.at(p, u).position), 1e-13) << "patch " << p;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ThreeValent, PatchSurfaces, testing::Range<std::size_t>(0, kThreeValentMeshes));

/// The Bezier point of a patch with these exponents of (u_0, u_1, u_2).
Vec3 bezierPoint(const std::vector<double>& bezier, std::size_t patch, std::array<std::size_t, 3> exponents) {
  const std::size_t row = 3 - exponents[0];
  const std::size_t first = 30 * patch + 3 * (row * (row + 1) / 2 + exponents[2]);
  return {bezier[first], bezier[first + 1], bezier[first + 2]};
}

TEST(BezierPoints, OfNeighboursMakeParallelograms) {
  const PatchSurface surface(threeValentMesh(kHoneycombMesh));
  const std::vector<double> bezier = surface.bezierPoints();
  const auto regular = surface.table.regularPatches();
  std::size_t pairs = 0;
  for (std::size_t r = 0; r < regular.size(); ++r) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto other = std::find(regular.begin(), regular.end(), surface.table.neighbours(regular[r])[i]);
      if (other == regular.end()) continue;
      ++pairs;
      const auto q = static_cast<std::size_t>(other - regular.begin());
      const std::array<std::int32_t, 3> faces = surface.table.patch(regular[r]).faces();
      const std::array<std::size_t, 2> own{i, (i + 1) % 3};
      const std::array<std::size_t, 2> others{surface.cornerIn(*other, faces[own[0]]),
                                              surface.cornerIn(*other, faces[own[1]])};
      // Row `depth` from the common edge, k of the way from corner i to corner i+1.
      const auto point = [&](std::size_t patch, const std::array<std::size_t, 2>& ends, std::size_t depth,
                             std::size_t k) {
        std::array<std::size_t, 3> exponents{depth, depth, depth};
        exponents[ends[0]] = 3 - depth - k;
        exponents[ends[1]] = k;
        return bezierPoint(bezier, patch, exponents);
      };
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 d = point(r, own, 0, k) + point(r, own, 0, k + 1) - point(r, own, 1, k);
        EXPECT_LT(distance(point(q, others, 1, k), d), 1e-14);
      }
    }
  }
  EXPECT_GT(pairs, 30U);
}

TEST(BezierPoints, AreThoseOfTheirStencils) {
  const PatchSurface surface(threeValentMesh(kHoneycombMesh));
  const auto table = surface.table.bezierStencils();
  ASSERT_TRUE(table.has_value());
  const std::vector<Vec3> points = applyRows(expandRows(*table), surface.mesh.points);
  const std::vector<double> bezier = surface.bezierPoints();
  ASSERT_EQ(3 * points.size(), bezier.size());
  EXPECT_EQ(table->weights.size(), 46 * surface.table.regularPatches().size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT(distance(points[i], {bezier[3 * i], bezier[3 * i + 1], bezier[3 * i + 2]}), 1e-14);
  }
}

TEST(PatchPoints, AreReadWithTheirStrideInSingleOrDouble) {
  const PatchSurface surface(cube());
  std::vector<float> wide(8 * 5 - 2, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t v = 0; v < 8; ++v) {
    for (std::size_t i = 0; i < 3; ++i) wide[5 * v + i] = static_cast<float>(surface.mesh.points[v][i]);
  }
  const auto point = surface.table.evaluate<float>(3, {0.2, 0.3, 0.5}, wide, 5);
  ASSERT_TRUE(point.has_value());
  EXPECT_LT(distance(point->position, surface.at(3, {0.2, 0.3, 0.5}).position), 1e-6);
}

TEST(PatchErrors, NameThePlaceAndTheRemedy) {
  const PatchSurface surface(cube());
  const auto error = [&](std::int32_t patch, const Far::Barycentric& u, std::size_t numbers = 24, int stride = 3) {
    const std::vector<double> points(numbers, 0.0);
    const auto result = surface.table.evaluate<double>(patch, u, points, stride);
    if (result) return std::string("none");
    EXPECT_EQ(result.error().code, ErrorCode::invalidOption);
    return result.error().message;
  };
  EXPECT_EQ(error(8, {1, 0, 0}), "there is no patch 8: the surface has 8 patches, counted from 0");
  EXPECT_EQ(error(-1, {1, 0, 0}), "there is no patch -1: the surface has 8 patches, counted from 0");
  EXPECT_EQ(
      error(2, {0.5, 0.75, -0.25}),
      "(0.5, 0.75, -0.25) is outside the triangle of patch 2; barycentric coordinates are at least 0 and sum to 1");
  EXPECT_EQ(error(0, {0.5, 0.25, 0.5}),
            "(0.5, 0.25, 0.5) is outside the triangle of patch 0; barycentric coordinates are at least 0 and sum to 1");
  EXPECT_EQ(error(0, {std::nan(""), 0.5, 0.5}),
            "(nan, 0.5, 0.5) is outside the triangle of patch 0; barycentric coordinates are at least 0 and sum to 1");
  EXPECT_EQ(error(0, {1, 0, 0}, 23), "23 numbers are too few for 8 control points with stride 3; give at least 24");
  EXPECT_EQ(error(0, {1, 0, 0}, 24, 2), "the points' stride is 2; it must be at least 3, for x y z");
  EXPECT_EQ(error(0, {1 + 5e-13, -5e-13, 0}), "none");
  EXPECT_NE(error(0, {1 + 2e-12, -2e-12, 0}), "none");
  EXPECT_FALSE(surface.table.bezierPoints<double>({}).has_value());
}

TEST(PatchErrors, NameTheFirstVertexThatIsNotThreeValent) {
  const auto error = [](const PolyMesh& mesh) { return Far::PatchTable::build(toTopology(mesh)).error(); };
  EXPECT_EQ(error(torus(4, 4)).code, ErrorCode::invalidMesh);
  EXPECT_EQ(error(torus(4, 4)).element, 0);
  EXPECT_EQ(error(torus(4, 4)).message,
            "vertex 0 (counted from 0) has 4 edges, and half-box splines need three (two or three on a boundary); "
            "convert the mesh first");
  EXPECT_EQ(error(fan(5)).element, 0);
  EXPECT_EQ(error(pillow(5)).element, 0);
}

TEST(PatchTables, OfMeshesWithoutInsideVerticesAreEmpty) {
  const PatchSurface surface(grid(1, 1));
  EXPECT_EQ(surface.table.patchCount(), 0);
  EXPECT_EQ(surface.table.tessellate(3)->polygons.faceCount(), 0);
  EXPECT_EQ(surface.table.limitStencils({})->positions.targetCount, 0);
}

}  // namespace
}  // namespace honeycomb::Test
