#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/refined.h"
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
