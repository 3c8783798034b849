#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/golden.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

/// Calls check(refinement, random mesh) for random meshes under every boundary rule, two levels each.
template <class Check>
void forRandomMeshes(const Check& check) {
  for (const auto boundary : {ReferenceBoundary::brick, ReferenceBoundary::eq16, ReferenceBoundary::drop}) {
    const SchemeCase scheme = schemeCase(NamedTension::paper, boundary);
    for (std::uint64_t seed = 0; seed < meshes(200); ++seed) {
      SCOPED_TRACE(scheme.name + ", seed " + std::to_string(seed));
      const RandomMesh random = randomMesh(seed);
      const auto reference = referenceLevel(random.mesh, {}, scheme.reference, 1);
      if (reference.mesh.faces.empty()) continue;  // `drop` leaves nothing of it
      const std::int32_t levels = boundary == ReferenceBoundary::drop ? 1 : 2;
      check(refined(random, scheme.scheme, levels), random);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(Stencils, AddUpToOne) {
  forRandomMeshes([](const Far::Refinement& refinement, const RandomMesh&) {
    for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
      const Far::LevelTable& table = refinement.level(k).table;
      ASSERT_EQ(table.sourceCount, refinement.level(k - 1).topology.vertexCount());
      ASSERT_EQ(table.targetCount, refinement.level(k).topology.vertexCount());
      const auto rows = expandRows(table);
      for (std::size_t r = 0; r < rows.size(); ++r) {
        double sum = 0;
        for (const auto& [point, weight] : rows[r]) sum += weight;
        ASSERT_NEAR(sum, 1, 1e-12) << "level " << k << ", point " << r << " (0: no row or two rows write it)";
      }
    }
  });
}

TEST(Stencils, ArePositiveForThePapersTension) {
  forRandomMeshes([](const Far::Refinement& refinement, const RandomMesh&) {
    for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
      const auto rows = expandRows(refinement.level(k).table);
      for (std::size_t r = 0; r < rows.size(); ++r) {
        for (const auto& [point, weight] : rows[r]) {
          ASSERT_GE(weight, -1e-15) << "level " << k << ", point " << r << ", source " << point;
        }
      }
    }
  });
}

TEST(Stencils, KeepWeightsInBothPrecisions) {
  forRandomMeshes([](const Far::Refinement& refinement, const RandomMesh&) {
    for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
      const Far::LevelTable& table = refinement.level(k).table;
      ASSERT_EQ(table.weights.size(), table.weightsSingle.size());
      for (std::size_t i = 0; i < table.weights.size(); ++i) {
        ASSERT_EQ(table.weightsSingle[i], static_cast<float>(table.weights[i]));
      }
    }
  });
}

TEST(Stencils, CommuteWithAffineMaps) {
  const auto map = [](const Vec3& p) {
    return Vec3{0.4 * p[0] - 0.5 * p[1] + 0.3, 0.2 * p[0] + 0.3 * p[1] - 0.4 * p[2] - 0.1,
                0.6 * p[2] + 0.1 * p[0] + 0.2};
  };
  forRandomMeshes([&map](const Far::Refinement& refinement, const RandomMesh& random) {
    std::vector<Vec3> moved;
    for (const Vec3& p : random.mesh.points) moved.push_back(map(p));
    const std::int32_t last = refinement.levelCount();
    const auto before = levelPoints<double>(refinement, last, random.mesh.points);
    const auto after = levelPoints<double>(refinement, last, moved);
    for (std::size_t v = 0; v < before.size(); ++v) ASSERT_LT(distance(map(before[v]), after[v]), 5e-15) << v;
  });
}

TEST(Stencils, StayInTheConvexHull) {
  forRandomMeshes([](const Far::Refinement& refinement, const RandomMesh& random) {
    const auto points = levelPoints<double>(refinement, refinement.levelCount(), random.mesh.points);
    Random directions(7);
    for (int i = 0; i < 20; ++i) {
      const Vec3 d{directions.symmetric(), directions.symmetric(), directions.symmetric()};
      double reach = -HUGE_VAL;
      for (const Vec3& p : random.mesh.points) reach = std::max(reach, dot(p, d));
      for (const Vec3& p : points) ASSERT_LE(dot(p, d), reach + 1e-14);
    }
  });
}

TEST(Stencils, OfWholeFacesAreThePapersFormula) {
  for (const std::size_t sides : {3U, 4U, 5U, 6U, 7U, 12U, 64U, 65U, 130U}) {
    for (const auto& [scheme, tension] : {std::pair{schemeCase(NamedTension::paper), paperTension(sides)},
                                          std::pair{schemeCase(NamedTension::sqrt3), sqrt3Tension(sides)},
                                          std::pair{schemeCase(0.6, ReferenceBoundary::brick, 0.25), 0.6}}) {
      const Far::CirculantRule rule = scheme.scheme.faceRule(static_cast<std::int32_t>(sides));
      const auto row = Far::firstRow(rule, static_cast<std::int32_t>(sides));
      const auto expected = closedFormula(tension, scheme.reference.edgeParameter, sides);
      ASSERT_EQ(row.size(), sides);
      for (std::size_t k = 0; k < sides; ++k) EXPECT_NEAR(row[k], expected[k], 1e-15) << scheme.name << " " << sides;
    }
  }
}

TEST(Stencils, OfARegularHexagonWithTheSqrt3TensionAreTheKnownFractions) {
  // On the mid-points of the hexagon's edges the weights are (23, 4, 2, 1, 2, 4)/36.
  const std::vector<double> onEdges = {23, 4, 2, 1, 2, 4};
  const auto row = Far::firstRow(schemeCase(NamedTension::sqrt3).scheme.faceRule(6), 6);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(row[k], (onEdges[k] + onEdges[(k + 5) % 6]) / 72, 1e-15);
}

}  // namespace
}  // namespace honeycomb::Test
