#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/golden.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

/// Calls check(parent polygon, child polygon) for every whole face of levels 0 .. L-1 and the face it becomes.
template <class Check>
void forFaceFaces(const Far::Refinement& refinement, const std::vector<Vec3>& control, const Check& check) {
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
    const PolyMesh before = levelMesh(refinement, k - 1, control);
    const PolyMesh after = levelMesh(refinement, k, control);
    std::vector<bool> whole(before.faces.size(), false);
    for (const Far::FaceRun& run : refinement.level(k - 1).topology.runs()) {
      for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
        whole[static_cast<std::size_t>(f)] = run.kind == Far::FaceKind::full;
      }
    }
    const Far::Topology& t = refinement.level(k).topology;
    for (const Far::FaceRun& run : t.runs()) {
      for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
        const auto parent = static_cast<std::size_t>(at(t.parents(), f));
        if (run.parent != Far::FaceParent::face || !whole[parent]) continue;
        check(corners(before, parent), corners(after, static_cast<std::size_t>(f)));
      }
    }
  }
}

TEST(Geometry, FaceFacesKeepTheCentroid) {
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomMesh random = randomMesh(seed);
    std::size_t compared = 0;
    forFaceFaces(refined(random, schemeCase(NamedTension::paper).scheme, 2), random.mesh.points,
                 [&compared](const auto& parent, const auto& child) {
                   EXPECT_LT(distance(centroid(parent), centroid(child)), 2e-15);
                   ++compared;
                 });
    ASSERT_GE(compared, random.mesh.faces.size());
  }
}

TEST(Geometry, FaceFacesKeepTheNormal) {
  for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomMesh random = randomMesh(seed);
    forFaceFaces(refined(random, schemeCase(NamedTension::sqrt3).scheme, 2), random.mesh.points,
                 [](const auto& parent, const auto& child) {
                   const Vec3 before = tangentNormal(parent);
                   const Vec3 after = tangentNormal(child);
                   if (length(after) < 1e-4) return;  // the rounding of the points would show
                   EXPECT_LT(distance(unit(before), unit(after)), 1e-9);
                 });
  }
}

TEST(Geometry, FacesContractByTheSubdominantEigenvalue) {
  const std::vector<std::pair<std::size_t, double>> known = {{4, 0.51518}, {5, 0.56631}, {6, 0.59289}};
  for (const auto& [sides, lambda] : known) {
    const PolyMesh control = prism(sides);
    const Far::Refinement refinement = refined(control, schemeCase(NamedTension::paper).scheme, 3);
    int compared = 0;
    forFaceFaces(refinement, control.points, [&compared, n = sides, factor = lambda](const auto& p, const auto& c) {
      const Vec3 middle = centroid(p);
      const bool cap =
          p.size() == n && std::hypot(middle[0], middle[1]) < 1e-9 && std::abs(std::abs(middle[2]) - 1) < 1e-9;
      if (!cap) return;  // only the regular polygons of the prism's ends
      const double before = distance(p[0], middle);
      const double after = distance(c[0], centroid(c));
      EXPECT_NEAR(after / before, factor, 5e-6) << n << " sides";
      ++compared;
    });
    EXPECT_EQ(compared, 6) << sides << " sides";
  }
}

TEST(Geometry, RegularPolygonsContractByOneOverSqrt3WithTheSqrt3Tension) {
  for (const std::size_t sides : {4U, 5U, 6U, 7U, 9U, 20U, 64U, 65U, 200U}) {
    const PolyMesh control = prism(sides);
    const PolyMesh after = levelMesh(refined(control, schemeCase(NamedTension::sqrt3).scheme, 1), 1, control.points);
    int caps = 0;
    for (std::size_t f = 0; f < after.faces.size(); ++f) {
      const auto polygon = corners(after, f);
      if (polygon.size() != sides || std::abs(std::abs(centroid(polygon)[2]) - 1) > 1e-9) continue;
      ++caps;
      for (const Vec3& p : polygon) EXPECT_NEAR(distance(p, centroid(polygon)), 1 / std::numbers::sqrt3, 1e-12);
    }
    EXPECT_EQ(caps, 2) << sides << " sides";
  }
}

/// honeycomb.obj laid flat: regular hexagons of side 1.
PolyMesh flatHoneycomb() {
  PolyMesh mesh = readGoldenMesh("honeycomb.obj");
  for (Vec3& p : mesh.points) p[2] = 0;
  return mesh;
}

TEST(Geometry, Sqrt3TensionReproducesThePlanarHoneycomb) {
  const PolyMesh control = flatHoneycomb();
  const Far::Refinement refinement = refined(control, schemeCase(NamedTension::sqrt3).scheme, 3);
  // Every point of a whole hexagon lies on the next lattice: new faces between them are regular, 1/sqrt 3 as large.
  double side = 1;
  std::size_t regular = 0;
  for (std::int32_t k = 1; k <= 3; ++k) {
    side /= std::numbers::sqrt3;
    const PolyMesh mesh = levelMesh(refinement, k, control.points);
    regular = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const auto polygon = corners(mesh, f);
      double worst = 0;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        worst = std::max(worst, std::abs(distance(polygon[i], polygon[(i + 1) % polygon.size()]) - side));
        worst = std::max(worst, std::abs(distance(polygon[i], centroid(polygon)) - side));
      }
      regular += polygon.size() == 6 && worst < 1e-13 ? 1 : 0;
      if (k == 1 && f < control.faces.size()) {
        EXPECT_LT(worst, 1e-13) << "face-face " << f;
      }
    }
    EXPECT_GE(regular, at(std::vector<std::size_t>{0, 43, 73, 180}, k)) << "level " << k;
  }
}

TEST(Geometry, BrickKeepsAPlanarMeshPlanar) {
  const PolyMesh control = flatHoneycomb();
  const Far::Refinement refinement = refined(control, schemeCase(NamedTension::sqrt3).scheme, 4);
  for (std::int32_t k = 1; k <= 4; ++k) {
    for (const Vec3& p : levelPoints<double>(refinement, k, control.points)) ASSERT_EQ(p[2], 0) << "level " << k;
  }
}

TEST(Geometry, CornerTagsKeepTheRectangleOfAGrid) {
  const PolyMesh control = grid(4, 3);
  const std::vector<std::size_t> tags = {0, 3, 16, 19};
  const Far::Refinement refinement = refined(control, schemeCase(NamedTension::paper).scheme, 4, tags);
  for (std::int32_t k = 1; k <= 4; ++k) {
    const Far::Topology& t = refinement.level(k).topology;
    const auto points = levelPoints<double>(refinement, k, control.points);
    int cornersFound = 0;
    for (const std::int32_t h : t.boundary()) {
      const Vec3& p = at(points, t.vert(h));
      const double off = std::min({std::abs(p[0]), std::abs(p[0] - 4), std::abs(p[1]), std::abs(p[1] - 3)});
      EXPECT_LT(off, 1e-14) << "level " << k;
      cornersFound += t.vertexTag(t.vert(h)) == Far::VertexTag::fixedCorner ? 1 : 0;
    }
    EXPECT_EQ(cornersFound, 4) << "level " << k;
    for (const Vec3& p : points) {
      EXPECT_TRUE(p[0] >= -1e-14 && p[0] <= 4 + 1e-14 && p[1] >= -1e-14 && p[1] <= 3 + 1e-14);
    }
  }
}

}  // namespace
}  // namespace honeycomb::Test
