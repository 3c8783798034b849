#include <gtest/gtest.h>

#include <algorithm>

#include "far/schemes/zhang_wang.h"
#include "tests/support/creased.h"
#include "tests/support/refined.h"
#include "tests/support/scheme_list.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

constexpr std::size_t kSides = meshes(100000);

/// Both precisions of the last level, compared, and the double points.
std::vector<Vec3> pointsInBothPrecisions(const Far::Refinement& refinement, const std::vector<Vec3>& control) {
  const std::int32_t last = refinement.levelCount();
  auto exact = levelPoints<double>(refinement, last, control);
  const auto single = levelPoints<float>(refinement, last, control);
  double worst = 0;
  for (std::size_t v = 0; v < exact.size(); ++v) worst = std::max(worst, distance(exact[v], single[v]));
  EXPECT_LT(worst, 2e-6) << "largest distance of float points from double ones, on a model of unit size";
  return exact;
}

/// A table of linear size holds a small multiple of the corners.
void expectLinear(const Far::Refinement& refinement) {
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
    EXPECT_LT(refinement.level(k).table.byteCount(), std::int64_t{200} * refinement.level(k).topology.halfEdgeCount());
  }
}

TEST(LargeFaces, KeepTheTablesOfEverySchemeLinear) {
  for (const PolyMesh& mesh : {prism(kSides / 20), wheel(kSides / 20)}) {
    const Far::Topology control = toTopology(mesh);
    for (const ListedScheme& scheme : listedSchemes()) {
      const auto chain = scheme.chain(control, 2);
      if (!chain) continue;  // the half-box of a wheel: nothing is left of it
      SCOPED_TRACE(scheme.name);
      const auto refinement = Far::refine(control, *chain, {});
      ASSERT_TRUE(refinement) << refinement.error().message;
      expectLinear(*refinement);
    }
  }
}

/// Control points with a central control vertex behind them for each face of the mesh: its barycentre.
std::vector<Vec3> withBarycentres(const PolyMesh& mesh) {
  std::vector<Vec3> points = mesh.points;
  for (const Loop& loop : mesh.faces) {
    Vec3 sum{};
    for (const std::size_t v : loop) sum = sum + mesh.points[v];
    points.push_back((1.0 / static_cast<double>(loop.size())) * sum);
  }
  return points;
}

PolyMesh shaken(PolyMesh mesh, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : mesh.points) p = p + Vec3{0.5 * random.symmetric(), 0.5 * random.symmetric(), random.symmetric()};
  return mesh;
}

/// The points of a level of the chain for control points alone, against those for control points with their barycentres
/// as central control vertices, which no row of the first level has to make up for itself.
void expectBarycentresByThemselves(const PolyMesh& mesh, const Far::Topology& control,
                                   const Far::ZhangWangOptions& options) {
  const auto chain = Far::zhangWang(control, 2, options);
  ASSERT_TRUE(chain) << chain.error().message;
  const auto alone = Far::refine(control, *chain, {});
  const auto given = Far::refine(control, *chain, {.centralPoints = true});
  ASSERT_TRUE(alone && given);
  EXPECT_GT(alone->level(1).table.summed.rowCount(), 0);
  EXPECT_LT(given->level(1).table.summed.rowCount(), alone->level(1).table.summed.rowCount());
  for (const std::int32_t level : {1, 2}) {
    const auto points = levelPoints<double>(*alone, level, mesh.points);
    const auto expected = levelPoints<double>(*given, level, withBarycentres(mesh));
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_LT(distance(points[i], expected[i]), 1e-11) << "level " << level << ", point " << i;
    }
  }
}

TEST(LargeFaces, HaveTheirBarycentresForCentralControlVertices) {
  for (const PolyMesh& mesh : {prism(kSides), prism(70), pillow(70)}) {
    const PolyMesh rough = shaken(mesh, 3);
    ASSERT_NO_FATAL_FAILURE(expectBarycentresByThemselves(rough, toTopology(rough), {}));
  }
}

TEST(LargeFaces, HaveCentralControlVerticesCloseInFloat) {
  const PolyMesh mesh = prism(kSides);
  const auto chain = Far::zhangWang(toTopology(mesh), 2);
  ASSERT_TRUE(chain) << chain.error().message;
  const auto refinement = Far::refine(toTopology(mesh), *chain, {});
  ASSERT_TRUE(refinement) << refinement.error().message;
  pointsInBothPrecisions(*refinement, mesh.points);
}

TEST(LargeFaces, HaveTheirBarycentresBesideInterpolatedVertices) {
  const PolyMesh mesh = shaken(prism(300), 4);
  Far::ZhangWangOptions options;
  options.interpolatedVertices = {0, 7, 450};
  ASSERT_NO_FATAL_FAILURE(expectBarycentresByThemselves(mesh, toTopology(mesh), options));
}

TEST(LargeFaces, HaveTheirBarycentresBesideCreases) {
  const PolyMesh mesh = shaken(prism(90), 5);
  Far::ZhangWangOptions options;
  options.boundary = Far::BoundaryRule::brick;
  options.unchecked = true;
  for (const double sharpness : {0.5, 1.0, 1.5, 10.0}) {
    SCOPED_TRACE(testing::Message() << "sharpness " << sharpness);
    // Round one of the large faces, whose rows change, while those of vertices far from it read its sum as before; and
    // round a small face beside both.
    for (const std::size_t face : {std::size_t{0}, std::size_t{5}}) {
      const Far::Topology control = creased(mesh, creasesRound(mesh, face, sharpness));
      ASSERT_NO_FATAL_FAILURE(expectBarycentresByThemselves(mesh, control, options));
    }
  }
}

TEST(LargeFaces, OfAPrismAreEvaluatedInLinearSpaceAndCloseInFloat) {
  PolyMesh mesh = prism(kSides);
  Random random(5);
  for (Vec3& p : mesh.points) p = p + Vec3{0.1 * random.symmetric(), 0.1 * random.symmetric(), 0};
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 2);
  expectLinear(refinement);
  pointsInBothPrecisions(refinement, mesh.points);
}

TEST(LargeFaces, OfAPrismFollowTheFormula) {
  PolyMesh mesh = prism(kSides);
  Random random(6);
  for (Vec3& p : mesh.points) p = p + Vec3{random.symmetric(), random.symmetric(), random.symmetric()};
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 1);
  const auto points = levelPoints<double>(refinement, 1, mesh.points);
  const Far::Topology& control = refinement.level(0).topology;
  const auto c = closedFormula(paperTension(kSides), 0.5, kSides);
  for (std::int32_t f = 0; f < control.faceCount(); ++f) {
    if (control.sides(f) != static_cast<std::int32_t>(kSides)) continue;
    const std::int32_t first = at(control.faceOffsets(), f);
    for (std::size_t i = 0; i < kSides; i += 9973) {
      Vec3 expected{};
      for (std::size_t k = 0; k < kSides; ++k) {
        expected = expected + c[k] * at(mesh.points, control.vert(first + static_cast<std::int32_t>((i + k) % kSides)));
      }
      ASSERT_LT(distance(points[static_cast<std::size_t>(first) + i], expected), 1e-12) << "corner point " << i;
    }
  }
}

TEST(LargeFaces, OfABoundaryVertexOfThatValence) {
  const PolyMesh mesh = fan(kSides);
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 3);
  const Far::Topology& t = refinement.level(1).topology;
  std::int32_t largest = 0;
  for (const Far::FaceRun& run : t.runs()) largest = std::max(largest, run.sides);
  EXPECT_EQ(largest, static_cast<std::int32_t>(2 * kSides + 2));
  expectLinear(refinement);
  pointsInBothPrecisions(refinement, mesh.points);
}

TEST(LargeFaces, OfAnInnerVertexOfThatValence) {
  const PolyMesh mesh = wheel(kSides);
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::sqrt3).scheme, 2);
  expectLinear(refinement);
  pointsInBothPrecisions(refinement, mesh.points);
}

TEST(LargeFaces, HaveLimitsAndNormals) {
  const PolyMesh mesh = prism(kSides);
  const Far::Refinement refinement = refined(mesh, schemeCase(NamedTension::paper).scheme, 1, {}, true);
  const auto points = levelPoints<double>(refinement, 1, mesh.points);
  const Limits exact = faceLimits<double>(refinement, points);
  const Limits single = faceLimits<float>(refinement, points);
  const Far::Topology& t = refinement.level(1).topology;
  int caps = 0;
  for (std::int32_t f = 0; f < t.faceCount(); ++f) {
    if (t.sides(f) != static_cast<std::int32_t>(kSides)) continue;
    ++caps;
    const double z = at(exact.positions, f)[2];
    EXPECT_LT(distance(at(exact.positions, f), {0, 0, z < 0 ? -1.0 : 1.0}), 1e-12);
    EXPECT_LT(distance(at(exact.normals, f), {0, 0, z < 0 ? -1.0 : 1.0}), 1e-12);
    // 391 block sums are added one after the other, so float may be off by some hundred roundings.
    EXPECT_LT(distance(at(single.positions, f), at(exact.positions, f)), 1e-5);
    EXPECT_LT(distance(at(single.normals, f), at(exact.normals, f)), 2e-6);
  }
  EXPECT_EQ(caps, 2);
}

}  // namespace
}  // namespace honeycomb::Test
