#include "far/schemes/half_box.h"

#include <gtest/gtest.h>

#include <string>

#include "far/tables/patch_table.h"
#include "tests/support/golden.h"
#include "tests/support/refined.h"

namespace honeycomb::Test {
namespace {

TEST(HalfBox, VertexLimitsAreThePatchCentres) {
  for (const char* shape : {"cube.obj", "dodecahedron.obj", "honeycomb.obj"}) {
    SCOPED_TRACE(shape);
    const PolyMesh mesh = readGoldenMesh(shape);
    const Far::Topology control = toTopology(mesh);
    const auto chain = Far::halfBox(control, 1);
    ASSERT_TRUE(chain.has_value());
    const Far::Refinement refinement = std::move(*Far::refine(control, *chain, {.limits = true}));
    const std::vector<Vec3> points = levelPoints<double>(refinement, refinement.levelCount(), mesh.points);
    const Limits limits = vertexLimits<double>(refinement, points);
    const auto patches = Far::PatchTable::build(refinement.last().topology);
    ASSERT_TRUE(patches.has_value()) << patches.error().message;
    const std::vector<double> numbers = pack<double>(points);
    for (std::int32_t p = 0; p < patches->patchCount(); ++p) {
      const auto centre = patches->evaluate<double>(p, {1.0 / 3, 1.0 / 3, 1.0 / 3}, numbers, 3);
      ASSERT_TRUE(centre.has_value());
      const std::int32_t v = patches->vertex(p);
      ASSERT_LT(distance(at(limits.positions, v), centre->position), 1e-12) << "vertex " << v;
      ASSERT_LT(distance(at(limits.normals, v), centre->normal), 1e-10) << "vertex " << v;
    }
  }
}

TEST(HalfBox, NamesTheVertexThatHasNotThreeEdges) {
  Far::HalfBoxOptions options;
  options.conversion = Far::HalfBoxConversion::none;
  const auto refused = Far::halfBox(toTopology(readGoldenMesh("torus.obj")), 1, options);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().element, 0);
  EXPECT_NE(refused.error().message.find("vertex 0 (counted from 0) has 4 edges"), std::string::npos)
      << refused.error().message;
}

std::string dualError(std::int32_t vertices, const std::vector<std::vector<std::int32_t>>& faces) {
  Far::Polygons polygons;
  polygons.vertexCount = vertices;
  for (const auto& face : faces) polygons.addFace(face);
  const auto control = Far::Topology::create(polygons);
  if (!control) return control.error().message;
  const auto chain = Far::halfBox(*control, 1, {.conversion = Far::HalfBoxConversion::dual});
  if (!chain) return chain.error().message;
  const auto refined = Far::refine(*control, *chain);
  return refined ? "" : refined.error().message;
}

TEST(HalfBox, RefusesDualsThatAreNoMeshes) {
  EXPECT_EQ(dualError(4, {{0, 1, 2}, {0, 2, 3}}),
            "every vertex is on a boundary, so the dual has no faces; give a larger mesh or convert it otherwise");
  // Two inside vertices (0 and 2) across a quad.
  EXPECT_EQ(dualError(6, {{0, 1, 2, 3}, {0, 3, 4}, {0, 4, 1}, {2, 1, 5}, {2, 5, 3}}),
            "face 0 (counted from 0) has vertices inside the mesh that lie apart, so the dual would have a bow-tie "
            "there; split the face or convert otherwise");
  EXPECT_EQ(dualError(4, {{0, 1, 2, 3}, {3, 2, 1, 0}}),
            "vertex 0 (counted from 0) has 2 faces round it, too few to become a face; dissolve it");
}

}  // namespace
}  // namespace honeycomb::Test
