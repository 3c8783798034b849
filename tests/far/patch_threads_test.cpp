#include <gtest/gtest.h>

#include "far/base/parallel.h"
#include "tests/support/patch_surfaces.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

/// Everything that a patch table computes in parallel.
struct PatchArrays {
  explicit PatchArrays(const PolyMesh& mesh) : surface(mesh) {
    cut = *surface.table.tessellate(3);
    stencils = *surface.table.limitStencils(cut.samples);
    bezierStencils = *surface.table.bezierStencils();
    bezier = surface.bezierPoints();
  }
  PatchSurface surface;
  Far::Tessellation cut;
  Far::LimitStencils stencils;
  Far::LevelTable bezierStencils;
  std::vector<double> bezier;
};

void expectSame(const Far::LevelTable& a, const Far::LevelTable& b) {
  EXPECT_EQ(a.indices, b.indices);
  EXPECT_EQ(a.weights, b.weights);
  EXPECT_EQ(a.weightsSingle, b.weightsSingle);
  EXPECT_EQ(a.loose.outputs, b.loose.outputs);
  EXPECT_EQ(a.loose.offsets, b.loose.offsets);
  EXPECT_EQ(a.summed.rows.outputs, b.summed.rows.outputs);
  EXPECT_EQ(a.summed.rows.offsets, b.summed.rows.offsets);
  EXPECT_EQ(a.summed.shareOffsets, b.summed.shareOffsets);
  EXPECT_EQ(a.summed.faces, b.summed.faces);
}

TEST(PatchThreads, OneAndTwoBuildTheSameArrays) {
  PolyMesh mesh = prism(70);
  for (int k = 0; k < 3; ++k) mesh = HalfBoxStep(mesh).mesh();
  const auto build = [&mesh](int threads) {
    const Parallel::ThreadLimit limit(threads);
    return PatchArrays(mesh);
  };
  const PatchArrays one = build(1);
  const PatchArrays two = build(2);
  ASSERT_GT(one.surface.table.patchCount(), Parallel::kGrain);
  ASSERT_GT(one.stencils.positions.summed.rowCount(), 0);
  for (std::int32_t p = 0; p < one.surface.table.patchCount(); ++p) {
    ASSERT_EQ(one.surface.table.vertex(p), two.surface.table.vertex(p));
  }
  EXPECT_EQ(one.cut.polygons.indices, two.cut.polygons.indices);
  EXPECT_EQ(one.cut.polygons.faceOffsets, two.cut.polygons.faceOffsets);
  for (std::size_t i = 0; i < one.cut.samples.size(); ++i) {
    ASSERT_EQ(one.cut.samples[i].patch, two.cut.samples[i].patch);
    ASSERT_EQ(one.cut.samples[i].barycentric, two.cut.samples[i].barycentric);
  }
  expectSame(one.stencils.positions, two.stencils.positions);
  expectSame(one.stencils.du, two.stencils.du);
  expectSame(one.stencils.dv, two.stencils.dv);
  expectSame(one.bezierStencils, two.bezierStencils);
  EXPECT_EQ(one.bezier, two.bezier);
}

}  // namespace
}  // namespace honeycomb::Test
