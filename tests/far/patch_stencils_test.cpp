#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/support/manifold_check.h"
#include "tests/support/patch_surfaces.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

const std::vector<Far::Barycentric> kSamplePlaces{
    {1.0 / 3, 1.0 / 3, 1.0 / 3}, {1, 0, 0}, {0, 0, 1}, {0.02, 0.93, 0.05}, {0.25, 0.5, 0.25}};

std::vector<Far::PatchSample> everywhere(const Far::PatchTable& table) {
  std::vector<Far::PatchSample> samples;
  for (std::int32_t p = 0; p < table.patchCount(); ++p) {
    for (const Far::Barycentric& u : kSamplePlaces) samples.push_back({p, u});
  }
  return samples;
}

double sum(const StencilRow& row) {
  double total = 0;
  for (const auto& entry : row) total += entry.second;
  return total;
}

class PatchStencils : public testing::TestWithParam<std::size_t> {
 protected:
  const PatchSurface surface_{threeValentMesh(GetParam())};
};

TEST_P(PatchStencils, GiveWhatEvaluationGives) {
  const std::vector<Far::PatchSample> samples = everywhere(surface_.table);
  const auto stencils = surface_.table.limitStencils(samples);
  ASSERT_TRUE(stencils.has_value());
  EXPECT_EQ(stencils->positions.sourceCount, static_cast<std::int32_t>(surface_.mesh.points.size()));
  const auto positions = expandRows(stencils->positions);
  const auto du = expandRows(stencils->du);
  const auto dv = expandRows(stencils->dv);
  ASSERT_EQ(positions.size(), samples.size());
  const auto limits = applyRows(positions, surface_.mesh.points);
  const auto alongU = applyRows(du, surface_.mesh.points);
  const auto alongV = applyRows(dv, surface_.mesh.points);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_NEAR(sum(positions[i]), 1, 1e-13);
    EXPECT_NEAR(sum(du[i]), 0, 1e-12);
    EXPECT_NEAR(sum(dv[i]), 0, 1e-12);
    const Far::PatchPoint point = surface_.at(samples[i].patch, samples[i].barycentric);
    EXPECT_LT(distance(limits[i], point.position), 1e-12) << "sample " << i;
    EXPECT_LT(distance(alongU[i], point.du), 1e-11) << "sample " << i;
    EXPECT_LT(distance(alongV[i], point.dv), 1e-11) << "sample " << i;
  }
}

TEST_P(PatchStencils, HoldNoZeroWeights) {
  const auto stencils = surface_.table.limitStencils(everywhere(surface_.table));
  for (const Far::LevelTable* table : {&stencils->positions, &stencils->du, &stencils->dv}) {
    EXPECT_EQ(std::count(table->weights.begin(), table->weights.end(), 0.0), 0);
    for (std::size_t i = 0; i < table->weights.size(); ++i) {
      ASSERT_EQ(table->weightsSingle[i], static_cast<float>(table->weights[i]));
    }
  }
}

/// The vertices of the triangles of patch p lie at the patch's own grid points (row r, column c), all of them are met,
/// and the triangles are the grid's, counter-clockwise.
void expectGridOf(const PatchSurface& surface, const Far::Tessellation& cut, const std::vector<Vec3>& points,
                  std::int32_t p, std::int32_t pieces) {
  const std::int64_t perPatch = std::int64_t{3} * pieces * pieces;
  const auto begin = cut.polygons.indices.begin() + p * perPatch;
  const std::set<std::int32_t> used(begin, begin + perPatch);
  std::map<std::int32_t, std::array<std::int32_t, 2>> places;
  for (std::int32_t r = 0; r <= pieces; ++r) {
    for (std::int32_t c = 0; c <= r; ++c) {
      const double k = pieces;
      const Vec3 q = surface.at(p, {(k - r) / k, (r - c) / k, c / k}).position;
      const auto same = [&](std::int32_t v) { return distance(at(points, v), q) < 1e-12; };
      const auto vertex = std::find_if(used.begin(), used.end(), same);
      ASSERT_NE(vertex, used.end()) << "row " << r << ", column " << c << " of patch " << p;
      places[*vertex] = {r, c};
    }
  }
  ASSERT_EQ(places.size(), used.size());
  for (auto corner = begin; corner != begin + perPatch; corner += 3) {
    const auto [a, b, c] = std::array{places[corner[0]], places[corner[1]], places[corner[2]]};
    EXPECT_EQ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 1) << "a triangle of patch " << p;
  }
}

std::vector<Loop> loops(const Far::Polygons& polygons) {
  std::vector<Loop> result;
  for (std::size_t i = 0; i < polygons.indices.size(); i += 3) {
    result.emplace_back(polygons.indices.begin() + static_cast<std::ptrdiff_t>(i),
                        polygons.indices.begin() + static_cast<std::ptrdiff_t>(i + 3));
  }
  return result;
}

TEST_P(PatchStencils, TessellateIntoASharedManifold) {
  constexpr std::int32_t kPieces = 3;
  const auto cut = surface_.table.tessellate(kPieces);
  ASSERT_TRUE(cut.has_value());
  std::string why;
  ASSERT_TRUE(isManifold(loops(cut->polygons), &why)) << why;
  EXPECT_TRUE(Far::Topology::create(cut->polygons).has_value());
  EXPECT_EQ(cut->polygons.faceCount(), std::int64_t{kPieces} * kPieces * surface_.table.patchCount());
  EXPECT_EQ(at(cut->polygons.faceOffsets, cut->polygons.faceCount()), 3 * cut->polygons.faceCount());
  EXPECT_EQ(static_cast<std::size_t>(cut->polygons.vertexCount), cut->samples.size());

  std::size_t border = 0;
  for (std::int32_t p = 0; p < surface_.table.patchCount(); ++p) {
    for (const std::int32_t q : surface_.table.neighbours(p)) border += q < 0 ? 1 : 0;
  }
  EXPECT_EQ(boundaryEdgeCount(loops(cut->polygons)), border * kPieces);
  if (border == 0) {
    EXPECT_EQ(eulerCharacteristic(loops(cut->polygons)), eulerCharacteristic(surface_.mesh.faces));
  }

  const auto stencils = surface_.table.limitStencils(cut->samples);
  const std::vector<Vec3> points = applyRows(expandRows(stencils->positions), surface_.mesh.points);
  for (std::int32_t p = 0; p < surface_.table.patchCount(); ++p) expectGridOf(surface_, *cut, points, p, kPieces);
}

INSTANTIATE_TEST_SUITE_P(ThreeValent, PatchStencils, testing::Range<std::size_t>(0, kThreeValentMeshes));

/// Six times the signed volume inside a closed mesh.
double volume(const PolyMesh& mesh) {
  double total = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<Vec3> c = corners(mesh, f);
    for (std::size_t k = 1; k + 1 < c.size(); ++k) total += dot(c[0], cross(c[k], c[k + 1]));
  }
  return total;
}

TEST(Tessellation, IsTurnedOutwardAndShrinksNoFurtherThanTheSurface) {
  const PatchSurface surface(cube());
  double last = 0;
  for (const std::int32_t pieces : {1, 2, 8, 64}) {
    const auto cut = surface.table.tessellate(pieces);
    const auto stencils = surface.table.limitStencils(cut->samples);
    const double inside =
        volume({applyRows(expandRows(stencils->positions), surface.mesh.points), loops(cut->polygons)});
    EXPECT_GT(inside, last) << pieces << " pieces: a convex surface holds more the finer it is cut";
    EXPECT_LT(inside, volume(surface.mesh));
    last = inside;
  }
}

TEST(Tessellation, IntoOnePieceIsTheDual) {
  const PatchSurface surface(cube());
  const auto cut = surface.table.tessellate(1);
  EXPECT_EQ(cut->polygons.vertexCount, 6);
  EXPECT_EQ(cut->polygons.faceCount(), 8);
  EXPECT_TRUE(isManifold(loops(cut->polygons)));
}

TEST(Tessellation, OfAHoneycombPatchIsADisc) {
  const auto cut = PatchSurface(threeValentMesh(kHoneycombMesh)).table.tessellate(4);
  EXPECT_EQ(eulerCharacteristic(loops(cut->polygons)), 1);
}

TEST(Tessellation, SeparatesSheetsThatTouchInAPoint) {
  // An octagon with two inside vertices that aren't next to each other (0 and 4): the surface is two patches that meet
  // in the octagon's centroid only.
  PolyMesh mesh;
  mesh.points.resize(14);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const double angle = static_cast<double>(i) * 0.7853981633974483;
    const double radius = i < 8 ? 1 : 2;
    mesh.points[i] = {radius * std::cos(angle), radius * std::sin(angle), 0.1 * static_cast<double>(i % 3)};
  }
  mesh.faces = {{0, 1, 2, 3, 4, 5, 6, 7}, {0, 8, 9, 1}, {0, 7, 10, 8}, {4, 11, 12, 5}, {4, 3, 13, 11}};
  const PatchSurface surface(mesh);
  ASSERT_EQ(surface.table.patchCount(), 2);
  const auto cut = surface.table.tessellate(2);
  EXPECT_EQ(cut->polygons.vertexCount, 12);
  std::string why;
  EXPECT_TRUE(isManifold(loops(cut->polygons), &why)) << why;
}

TEST(PatchStencilErrors, NameTheSampleAndTheLimit) {
  const PatchSurface surface(cube());
  const auto result = surface.table.limitStencils(std::vector<Far::PatchSample>{{0, {1, 0, 0}}, {1, {1, 1, 0}}});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::invalidOption);
  EXPECT_EQ(result.error().element, 1);
  EXPECT_EQ(
      result.error().message,
      "sample 1: (1, 1, 0) is outside the triangle of patch 1; barycentric coordinates are at least 0 and sum to 1");
  for (const std::int32_t pieces : {0, -3, 65}) {
    const auto cut = surface.table.tessellate(pieces);
    ASSERT_FALSE(cut.has_value());
    EXPECT_EQ(cut.error().code, ErrorCode::invalidOption);
    EXPECT_EQ(cut.error().message,
              "patches can't be cut into " + std::to_string(pieces) + " pieces an edge; take 1 to 64");
  }
}

}  // namespace
}  // namespace honeycomb::Test
