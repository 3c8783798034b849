#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "far/schemes/half_box.h"
#include "tests/support/creased.h"
#include "tests/support/manifold_check.h"
#include "tests/support/mesh_compare.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::vector<Far::Scheme> clampedChain(const Far::Topology& control, std::int32_t levels) {
  Far::HalfBoxOptions options;
  options.boundary = Far::HalfBoxBoundary::clamped;
  return *Far::halfBox(control, levels, options);
}

TEST(HalfBoxCreases, SidesKeepTheSamePoints) {
  for (const CreasedMesh& c : creasedMeshes(Far::kSharp)) {
    SCOPED_TRACE(c.name);
    const Far::Topology control = creased(c.mesh, c.creases);
    const Far::Refinement refinement = refinedBy(control, clampedChain(control, 3));
    ASSERT_EQ(refinement.levelCount(), 5);
    for (std::int32_t k = 1; k <= 5; ++k) {
      EXPECT_FALSE(refinement.level(k).topology.creases().empty());
      EXPECT_EQ(sidesDiffer(refinement.level(k), levelPoints<double>(refinement, k, c.mesh.points)), "");
      EXPECT_EQ(sidesDiffer(refinement.level(k), levelPoints<float>(refinement, k, c.mesh.points)), "");
      std::string why;
      EXPECT_TRUE(isManifold(levelMesh(refinement, k, c.mesh.points).faces, &why)) << "level " << k << ": " << why;
    }
  }
}

TEST(HalfBoxCreases, RowsAreConvex) {
  for (const CreasedMesh& c : creasedMeshes(Far::kSharp)) {
    SCOPED_TRACE(c.name);
    const Far::Topology control = creased(c.mesh, c.creases);
    const std::vector<Far::Scheme> chain = clampedChain(control, 2);
    const Far::Refinement refinement = refinedBy(control, chain);
    const auto predicted = Far::predict(control, chain);
    for (std::int32_t k = 1; k <= 4; ++k) {
      EXPECT_TRUE(at(predicted, k).exact);
      EXPECT_EQ(at(predicted, k).halfEdges, refinement.level(k).topology.halfEdgeCount()) << "level " << k;
      EXPECT_EQ(at(predicted, k).vertices, refinement.level(k).topology.vertexCount()) << "level " << k;
      for (const StencilRow& row : expandRows(refinement.level(k).table)) {
        double sum = 0;
        for (const auto& [point, weight] : row) {
          sum += weight;
          ASSERT_GE(weight, -1e-15) << "level " << k;
        }
        ASSERT_NEAR(sum, 1, 1e-12) << "level " << k;
      }
    }
  }
}

/// The curve has a joint at each vertex v_i of the crease, (v_{i-1} + 2 v_i + v_{i+1})/4, halfway between the middles
/// of its edges. It is on all levels behind the clamp step, as the middle of L and R.
TEST(HalfBoxCreases, TheCurveOfACreaseIsTheSplineOfItsVertices) {
  const PolyMesh mesh = cube();
  const Far::Topology control = creased(mesh, creasesRound(mesh, 0, Far::kSharp));
  const Far::Refinement refinement = refinedBy(control, clampedChain(control, 3));
  std::vector<Vec3> joints;
  const Loop& loop = mesh.faces[0];
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& v = mesh.points[loop[i]];
    joints.push_back(0.25 * (mesh.points[loop[(i + 3) % 4]] + 2 * v + mesh.points[loop[(i + 1) % 4]]));
  }
  for (std::int32_t k = 2; k <= 5; ++k) {
    const std::vector<Vec3> points = levelPoints<double>(refinement, k, mesh.points);
    const Far::Topology& topology = refinement.level(k).topology;
    for (const Vec3& joint : joints) {
      double nearest = 1;
      for (const Far::FaceRun& run : topology.runs()) {
        if (run.kind != Far::FaceKind::clampedSide) continue;
        for (std::int32_t f = run.firstFace; f < run.firstFace + run.faceCount; ++f) {
          const std::int32_t cut = at(topology.faceOffsets(), f);
          const Vec3 middle = 0.5 * (at(points, topology.vert(cut)) + at(points, topology.dest(cut)));
          nearest = std::min(nearest, distance(middle, joint));
        }
      }
      EXPECT_LT(nearest, 1e-14) << "level " << k;
    }
  }
}

TEST(HalfBoxCreases, ACubeWithSharpEdgesStaysACube) {
  const PolyMesh mesh = cube();
  const Far::Topology control = creased(mesh, creasesEverywhere(mesh, Far::kSharp));
  const Far::Refinement refinement = refinedBy(control, clampedChain(control, 3));
  const std::vector<Vec3> points = levelPoints<double>(refinement, 5, mesh.points);
  const double side = std::abs(mesh.points[0][0]);
  for (const Vec3& p : points) {
    EXPECT_NEAR(std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}), side, 1e-12);
  }
  for (const Vec3& corner : mesh.points) EXPECT_EQ(std::count(points.begin(), points.end(), corner), 3);
}

TEST(HalfBoxCreases, LimitsAgreeOnBothSides) {
  const PolyMesh mesh = dodecahedron();
  const Far::Topology control = creased(mesh, creasesRound(mesh, 5, Far::kSharp));
  const Far::Refinement refinement = refinedBy(control, clampedChain(control, 2), true);
  const Limits limits = vertexLimits<double>(refinement, levelPoints<double>(refinement, 4, mesh.points));
  for (const Far::CreaseEdge& crease : refinement.last().topology.creases()) {
    const Far::Topology& topology = refinement.last().topology;
    const Vec3& here = at(limits.positions, topology.vert(crease.halfEdge));
    EXPECT_LT(distance(here, at(limits.positions, topology.dest(crease.mate))), 1e-12);
  }
}

TEST(HalfBoxCreases, RefusalsSayWhatToDo) {
  const auto message = [](const PolyMesh& mesh, double sharpness, const Far::HalfBoxOptions& options) {
    const Far::Topology control = creased(mesh, {{5, 6, sharpness}});
    const auto chain = Far::halfBox(control, 2, options);
    return chain ? std::string() : chain.error().message;
  };
  Far::HalfBoxOptions options;
  EXPECT_THAT(message(torus(4, 4), 2.5, options), AllOf(HasSubstr("vertices 5 and 6"), HasSubstr("become smooth")));
  EXPECT_THAT(message(grid(3, 3), Far::kSharp, options), AllOf(HasSubstr("vertices 5 and 6"), HasSubstr("clamped")));
  options.conversion = Far::HalfBoxConversion::trisect;
  EXPECT_THAT(message(torus(4, 4), Far::kSharp, options), HasSubstr("akleman conversion"));
}

}  // namespace
}  // namespace honeycomb::Test
