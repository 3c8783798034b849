#include "far/tables/bounds.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/support/random_mesh.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

TEST(Bounds, BoxHoldsThePointsAndNothingMore) {
  const std::vector<float> points{1, 2, 3, -4, 5, 0, 7, -8, 9};
  const Far::Box<float> box = Far::bounds<float>(points);
  EXPECT_EQ(box.low, (std::array<float, 3>{-4, -8, 0}));
  EXPECT_EQ(box.high, (std::array<float, 3>{7, 5, 9}));
}

TEST(Bounds, StrideSkipsOtherNumbersAndTheTail) {
  const std::vector<double> points{1, 1, 1, 99, 2, 2, 2, 99, 500, 500};
  const Far::Box<double> box = Far::bounds<double>(points, 4);
  EXPECT_EQ(box.low, (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(box.high, (std::array<double, 3>{2, 2, 2}));
}

TEST(Bounds, NothingIsEmptyAndNotANumberIsPassedOver) {
  EXPECT_TRUE(Far::bounds<float>(std::vector<float>{}).empty());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Far::Box<float> box = Far::bounds<float>(std::vector<float>{1, nan, 3, 2, 5, 1});
  EXPECT_EQ(box.low, (std::array<float, 3>{1, 5, 1}));
}

TEST(Bounds, ManyPointsInPieces) {
  std::vector<float> points(3 * 200'000, 0.5F);
  points[3 * 150'000 + 1] = -2;
  points[3 * 199'999 + 2] = 3;
  const Far::Box<float> box = Far::bounds<float>(points);
  EXPECT_EQ(box.low, (std::array<float, 3>{0.5F, -2, 0.5F}));
  EXPECT_EQ(box.high, (std::array<float, 3>{0.5F, 0.5F, 3}));
}

TEST(Bounds, ControlBoxHoldsEveryLevelWhereWeightsAreConvex) {
  std::uint64_t convex = 0;
  for (std::uint64_t seed = 0; seed < meshes(50); ++seed) {
    const RandomMesh random = randomMesh(seed);
    const Far::Refinement refinement = refined(random, schemeCase(NamedTension::paper).scheme, 3);
    if (!Far::isConvex(refinement)) continue;
    ++convex;
    const auto box = Far::bounds<double>(pack<double>(random.mesh.points));
    const auto fine = Far::bounds<double>(pack<double>(levelPoints<double>(refinement, 3, random.mesh.points)));
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_GE(fine.low[c], box.low[c] - 1e-12) << "seed " << seed;
      EXPECT_LE(fine.high[c], box.high[c] + 1e-12) << "seed " << seed;
    }
  }
  EXPECT_GT(convex, meshes(50) / 2) << "the property was hardly looked at";
}

TEST(Bounds, ConvexityIsDeniedWhereAMirroredFaceHasNegativeWeights) {
  EXPECT_TRUE(Far::isConvex(refined(grid(4, 4), schemeCase(NamedTension::paper).scheme, 3)));
  EXPECT_FALSE(Far::isConvex(refined(grid(4, 4), schemeCase(0.05, ReferenceBoundary::brick, 1.0).scheme, 3)));
  EXPECT_TRUE(Far::isConvex(refined(cube(), schemeCase(0.05, ReferenceBoundary::brick, 1.0).scheme, 3)));
}

}  // namespace
}  // namespace honeycomb::Test
