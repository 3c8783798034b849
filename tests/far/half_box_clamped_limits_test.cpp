#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "far/schemes/half_box.h"
#include "tests/support/honeycombs.h"
#include "tests/support/random.h"
#include "tests/support/refined.h"

namespace honeycomb::Test {
namespace {

/// A level of the half-box scheme on a clamped boundary with its limits.
struct ClampedStep {
  ClampedStep(const PolyMesh& mesh, std::int32_t steps, Far::HalfBoxCorners corners)
      : refinement(refine(mesh, steps, corners)), points(levelPoints<double>(refinement, steps + 1, mesh.points)) {}

  static Far::Refinement refine(const PolyMesh& mesh, std::int32_t steps, Far::HalfBoxCorners corners) {
    Far::HalfBoxOptions options;
    options.conversion = Far::HalfBoxConversion::none;
    options.boundary = Far::HalfBoxBoundary::clamped;
    options.corners = corners;
    const Far::Topology control = toTopology(mesh);
    const auto chain = Far::halfBox(control, steps, options);
    if (!chain) throw std::runtime_error(chain.error().message);
    auto refinement = Far::refine(control, *chain, {.limits = true});
    if (!refinement) throw std::runtime_error(refinement.error().message);
    return std::move(*refinement);
  }
  const Far::Topology& topology() const { return refinement.last().topology; }

  Far::Refinement refinement;
  std::vector<Vec3> points;
};

PolyMesh withRandomHeights(PolyMesh mesh) {
  Random random(11);
  for (Vec3& p : mesh.points) p[2] = 0.4 * random.symmetric();
  return mesh;
}

std::vector<PolyMesh> clampedMeshes() {
  std::vector<PolyMesh> all;
  for (const PolyMesh& mesh : honeycombPatches()) all.push_back(withRandomHeights(mesh));
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) all.push_back(randomThreeValent(seed));
  for (const std::size_t m : {2U, 3U, 4U, 5U, 7U}) all.push_back(flower(m, 2 * m));
  return all;
}

/// The normal of a face of that kind is that of the limit surface.
bool hasTangentPlane(const Far::FaceRun& run, Far::HalfBoxCorners corners) {
  if (run.kind != Far::FaceKind::clampedCorner) return run.kind != Far::FaceKind::clampedGap;
  const std::int32_t m = run.sides - 3;
  return m < 3 || (m > 3 && corners == Far::HalfBoxCorners::smooth);
}

class ClampedLimits : public testing::TestWithParam<Far::HalfBoxCorners> {};

void expectFaceLimitsStay(const PolyMesh& mesh, Far::HalfBoxCorners corners, double tolerance) {
  const ClampedStep before(mesh, 1, corners), after(mesh, 2, corners);
  const Limits limits = faceLimits<double>(before.refinement, before.points);
  const Limits later = faceLimits<double>(after.refinement, after.points);
  for (std::int32_t f = 0; f < after.topology().faceCount(); ++f) {
    if (after.topology().parentKind(f) != Far::FaceParent::face) continue;
    const std::int32_t parent = at(after.topology().parents(), f);
    ASSERT_LT(distance(at(later.positions, f), at(limits.positions, parent)), tolerance) << "face " << parent;
    if (!hasTangentPlane(before.topology().run(parent), corners)) continue;
    ASSERT_LT(distance(at(later.normals, f), at(limits.normals, parent)), 1e-9) << "face " << parent;
  }
}

TEST_P(ClampedLimits, OfFacesStayUnderRefinement) {
  for (const PolyMesh& mesh : clampedMeshes()) expectFaceLimitsStay(mesh, GetParam(), 1e-13);
}

/// Sides of an even and an odd number of vertices inside, and a corner, whose points read sums.
TEST_P(ClampedLimits, OfLargeFacesStayUnderRefinement) {
  for (const PolyMesh& mesh : {flower(70, 140), flower(71, 142), flower(70, 100)}) {
    expectFaceLimitsStay(mesh, GetParam(), 1e-12);
  }
}

TEST_P(ClampedLimits, OfVerticesInsideStayUnderRefinement) {
  for (const PolyMesh& mesh : clampedMeshes()) {
    const ClampedStep before(mesh, 1, GetParam()), after(mesh, 2, GetParam());
    const Limits limits = vertexLimits<double>(before.refinement, before.points);
    const Limits later = vertexLimits<double>(after.refinement, after.points);
    // New places of vertices follow the corner points of whole faces.
    std::int32_t place = 0;
    for (const Far::FaceRun& run : before.topology().runs()) {
      if (run.kind == Far::FaceKind::full) place += run.sides * run.faceCount;
    }
    for (std::int32_t v = 0; v < before.topology().vertexCount(); ++v) {
      if (before.topology().onBoundary(v)) continue;
      ASSERT_LT(distance(at(later.positions, place), at(limits.positions, v)), 1e-13) << "vertex " << v;
      ASSERT_LT(distance(at(later.normals, place), at(limits.normals, v)), 1e-9) << "vertex " << v;
      ++place;
    }
  }
}

/// R_f and L_g stand for the points at 1/3 and 2/3 of the curve from one face to the next, a gap for its middle: in
/// half of it, those of the points that the next step puts there.
TEST_P(ClampedLimits, OfTheBoundaryLieOnItsCurve) {
  for (const PolyMesh& mesh : clampedMeshes()) {
    const ClampedStep before(mesh, 1, GetParam()), after(mesh, 2, GetParam());
    const Limits vertices = vertexLimits<double>(before.refinement, before.points);
    const Limits later = vertexLimits<double>(after.refinement, after.points);
    for (std::int32_t v = 0; v < before.topology().vertexCount(); ++v) {
      if (!before.topology().onBoundary(v)) continue;
      double nearest = 10;
      for (const std::int32_t b : after.topology().boundary()) {
        nearest = std::min(nearest, distance(at(later.positions, after.topology().vert(b)), at(vertices.positions, v)));
      }
      ASSERT_LT(nearest, 1e-13) << "vertex " << v;
    }
    const Limits faces = faceLimits<double>(before.refinement, before.points);
    const Limits laterFaces = faceLimits<double>(after.refinement, after.points);
    for (std::int32_t f = 0; f < after.topology().faceCount(); ++f) {
      const Far::FaceRun& run = after.topology().run(f);
      if (run.kind != Far::FaceKind::clampedSide || run.parent != Far::FaceParent::edge) continue;
      const std::int32_t gap = before.topology().face(at(after.topology().parents(), f));
      ASSERT_LT(distance(at(laterFaces.positions, f), at(faces.positions, gap)), 1e-13) << "face " << gap;
    }
  }
}

/// The largest angle in degrees between the normal at a boundary face and those in the middle of the patches round it.
double largestAngle(const ClampedStep& step, Far::HalfBoxCorners corners) {
  const Limits faces = faceLimits<double>(step.refinement, step.points);
  const Limits vertices = vertexLimits<double>(step.refinement, step.points);
  const Far::Topology& topology = step.topology();
  double largest = 0;
  for (const Far::FaceRun& run : topology.runs()) {
    if (run.kind == Far::FaceKind::full || !hasTangentPlane(run, corners)) continue;
    for (std::int32_t h = run.firstHalfEdge; h < run.firstHalfEdge + run.faceCount * run.sides; ++h) {
      if (topology.onBoundary(topology.vert(h))) continue;
      const double cosine = dot(at(faces.normals, topology.face(h)), at(vertices.normals, topology.vert(h)));
      largest = std::max(largest, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
    }
  }
  return largest;
}

bool hasConcaveCorner(const Far::Topology& topology) {
  const auto runs = topology.runs();
  return std::any_of(runs.begin(), runs.end(), [](const Far::FaceRun& run) {
    return run.kind == Far::FaceKind::clampedCorner && run.sides - 3 > 3;
  });
}

/// At smooth boundaries and at corners with a tangent plane the normals converge; beside a corner without one they
/// don't.
TEST_P(ClampedLimits, AreWhereTheNormalsOfPatchesGo) {
  for (const PolyMesh& flat : honeycombPatches()) {
    const PolyMesh mesh = withRandomHeights(flat);
    double angle = largestAngle(ClampedStep(mesh, 2, GetParam()), GetParam());
    if (GetParam() == Far::HalfBoxCorners::convex && hasConcaveCorner(ClampedStep(mesh, 1, GetParam()).topology()))
      continue;
    for (std::int32_t steps = 3; steps <= 4; ++steps) {
      const double next = largestAngle(ClampedStep(mesh, steps, GetParam()), GetParam());
      EXPECT_LT(next, 0.7 * angle) << "after " << steps << " steps";
      angle = next;
    }
  }
}

TEST_P(ClampedLimits, HaveUpwardNormalsOnAWavyHoneycomb) {
  for (const PolyMesh& flat : honeycombPatches()) {
    PolyMesh mesh = flat;
    for (Vec3& p : mesh.points) p[2] = 0.2 * std::sin(p[0] + 2 * p[1]);
    const ClampedStep step(mesh, 1, GetParam());
    for (const Limits& limits :
         {faceLimits<double>(step.refinement, step.points), vertexLimits<double>(step.refinement, step.points)}) {
      for (const Vec3& normal : limits.normals) {
        ASSERT_NEAR(length(normal), 1, 1e-12);
        ASSERT_GT(normal[2], 0.7);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corners, ClampedLimits,
                         testing::Values(Far::HalfBoxCorners::convex, Far::HalfBoxCorners::smooth));

}  // namespace
}  // namespace honeycomb::Test
