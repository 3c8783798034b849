#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>

#include "far/schemes/akleman.h"
#include "far/schemes/half_box.h"
#include "tests/support/clamped_reference.h"
#include "tests/support/honeycombs.h"
#include "tests/support/manifold_check.h"
#include "tests/support/mesh_compare.h"
#include "tests/support/random.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

Far::HalfBoxOptions clamped(Far::HalfBoxCorners corners = Far::HalfBoxCorners::convex) {
  Far::HalfBoxOptions options;
  options.conversion = Far::HalfBoxConversion::none;
  options.boundary = Far::HalfBoxBoundary::clamped;
  options.corners = corners;
  return options;
}

/// Levels: the mesh, its clamped structure, and `steps` steps more.
Far::Refinement clampedSteps(const PolyMesh& mesh, std::int32_t steps, const Far::HalfBoxOptions& options = clamped(),
                             bool limits = false) {
  const Far::Topology control = toTopology(mesh);
  const auto chain = Far::halfBox(control, steps, options);
  if (!chain) throw std::runtime_error(chain.error().message);
  auto refinement = Far::refine(control, *chain, {.limits = limits});
  if (!refinement) throw std::runtime_error(refinement.error().message);
  return std::move(*refinement);
}

char tagOf(Far::FaceKind kind) {
  switch (kind) {
    case Far::FaceKind::clampedSide:
      return 'B';
    case Far::FaceKind::clampedCorner:
      return 'C';
    case Far::FaceKind::clampedGap:
      return 'T';
    default:
      return 'I';
  }
}

/// The number of inside vertices of a face of the boundary.
std::size_t insideCount(char tag, std::size_t sides) {
  return sides - (tag == 'B' ? 2 : 3);
}

class RandomClamped : public testing::TestWithParam<Far::HalfBoxCorners> {};

TEST_P(RandomClamped, EqualsTheFormulasOnPolygons) {
  const bool smooth = GetParam() == Far::HalfBoxCorners::smooth;
  std::map<char, std::set<std::size_t>> seen;
  for (std::uint64_t seed = 1; seed <= 14; ++seed) {
    const PolyMesh mesh = randomThreeValent(seed);
    const Far::Refinement refinement = clampedSteps(mesh, 2, clamped(GetParam()));
    ClampedMesh reference = referenceClamp(mesh);
    for (std::size_t f = 0; f < reference.tags.size(); ++f) {
      if (reference.tags[f] == 'I' || reference.tags[f] == 'T') continue;
      seen[reference.tags[f]].insert(insideCount(reference.tags[f], reference.mesh.faces[f].size()));
    }
    for (std::int32_t level = 1; level <= 3; ++level) {
      if (level > 1) reference = referenceClampedStep(reference, smooth);
      const MeshMatch match = matchMeshes(reference.mesh, levelMesh(refinement, level, mesh.points), 1e-12);
      ASSERT_TRUE(match.same) << "seed " << seed << " level " << level << ": " << match.why;
      const Far::Topology& topology = refinement.level(level).topology;
      for (std::size_t f = 0; f < reference.tags.size(); ++f) {
        const auto face = static_cast<std::int32_t>(match.faceMap[f]);
        ASSERT_EQ(tagOf(topology.run(face).kind), reference.tags[f]) << "seed " << seed << " level " << level;
      }
    }
  }
  for (const std::size_t m : {1U, 2U, 3U, 4U, 5U, 6U}) EXPECT_TRUE(seen['C'].contains(m)) << "no corner with m = " << m;
  for (const std::size_t m : {2U, 3U, 4U}) EXPECT_TRUE(seen['B'].contains(m)) << "no side with m = " << m;
}

INSTANTIATE_TEST_SUITE_P(Corners, RandomClamped,
                         testing::Values(Far::HalfBoxCorners::convex, Far::HalfBoxCorners::smooth));

TEST(HalfBoxClamped, EqualsTheFormulasOnSidesOfEveryLength) {
  for (const std::size_t m : {2U, 3U, 4U, 5U, 7U}) {
    const PolyMesh mesh = flower(m, 2 * m);
    const Far::Refinement refinement = clampedSteps(mesh, 1);
    ClampedMesh reference = referenceClamp(mesh);
    bool found = false;
    for (std::size_t f = 0; f < reference.tags.size(); ++f) {
      found = found || (reference.tags[f] == 'B' && insideCount('B', reference.mesh.faces[f].size()) == m);
    }
    ASSERT_TRUE(found) << m;
    reference = referenceClampedStep(reference, false);
    const MeshMatch match = matchMeshes(reference.mesh, levelMesh(refinement, 2, mesh.points), 1e-13);
    EXPECT_TRUE(match.same) << "m = " << m << ": " << match.why;
  }
}

TEST(HalfBoxClamped, WeightsSumToOneAndAreNotNegative) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const auto corners : {Far::HalfBoxCorners::convex, Far::HalfBoxCorners::smooth}) {
      Far::HalfBoxOptions options = clamped(corners);
      options.tuning = Far::HalfBoxTuning::all;
      const Far::Refinement refinement = clampedSteps(randomThreeValent(seed), 2, options);
      for (std::int32_t level = 1; level <= 3; ++level) {
        for (const StencilRow& row : expandRows(refinement.level(level).table)) {
          double sum = 0;
          for (const auto& entry : row) {
            sum += entry.second;
            ASSERT_GE(entry.second, corners == Far::HalfBoxCorners::convex ? -1e-15 : -1.0) << "seed " << seed;
          }
          ASSERT_NEAR(sum, 1, 1e-12) << "seed " << seed << " level " << level;
        }
      }
    }
  }
}

TEST(HalfBoxClamped, KeepsManifoldEulerCharacteristicAndThreeEdges) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const PolyMesh mesh = randomThreeValent(seed);
    const Far::Refinement refinement = clampedSteps(mesh, 2);
    for (std::int32_t level = 1; level <= 3; ++level) {
      const Far::Topology& topology = refinement.level(level).topology;
      std::string why;
      ASSERT_TRUE(isManifold(toMesh(topology, {}).faces, &why)) << "seed " << seed << " level " << level << ": " << why;
      EXPECT_EQ(topology.eulerCharacteristic(), refinement.level(1).topology.eulerCharacteristic());
      for (std::int32_t v = 0; v < topology.vertexCount(); ++v) {
        std::int32_t gaps = 0;
        std::int32_t h = topology.outgoing(v);
        do {
          gaps += topology.run(topology.face(h)).kind == Far::FaceKind::clampedGap ? 1 : 0;
          h = topology.nextOutgoing(h);
        } while (h >= 0 && h != topology.outgoing(v));
        if (topology.onBoundary(v)) continue;
        ASSERT_EQ(topology.valence(v), 3 + gaps) << "seed " << seed << " vertex " << v;
      }
    }
  }
}

/// Inside, edges of that length and regular hexagons; on the boundary, the cubics between the centres of the hexagons
/// are straight, so R_f and L_g divide the way between them in three.
void expectHoneycomb(const Far::Topology& topology, const PolyMesh& mesh, double size) {
  for (std::int32_t h = 0; h < topology.halfEdgeCount(); ++h) {
    const double edge = distance(at(mesh.points, topology.dest(h)), at(mesh.points, topology.vert(h)));
    if (!topology.onBoundary(topology.vert(h)) && !topology.onBoundary(topology.dest(h))) {
      ASSERT_NEAR(edge, size, 7e-15);
    } else if (topology.twin(h) < 0 && topology.run(topology.face(h)).kind == Far::FaceKind::clampedGap) {
      ASSERT_NEAR(edge, size / std::numbers::sqrt3, 7e-15);
    }
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (topology.run(static_cast<std::int32_t>(f)).kind != Far::FaceKind::full) continue;
    const std::vector<Vec3> hexagon = corners(mesh, f);
    for (const Vec3& p : hexagon) {
      ASSERT_NEAR(distance(p, centroid(hexagon)), size, 7e-15);
      ASSERT_NEAR(p[2], 0, 7e-15);
    }
  }
}

TEST(HalfBoxClamped, IsLinearlyPreciseOnPlanarHoneycombs) {
  for (const auto rule : {Far::HalfBoxCorners::convex, Far::HalfBoxCorners::smooth}) {
    for (const PolyMesh& mesh : honeycombPatches()) {
      const Far::Refinement refinement = clampedSteps(mesh, 3, clamped(rule));
      for (std::int32_t level = 1; level <= 4; ++level) {
        expectHoneycomb(refinement.level(level).topology, levelMesh(refinement, level, mesh.points),
                        std::pow(0.5, level - 1));
      }
    }
  }
}

/// The Bezier points of the natural boundary after k steps are those of the clamped one.
TEST(HalfBoxClamped, HasTheCurveOfTheNaturalBoundary) {
  for (PolyMesh mesh : honeycombPatches()) {
    Random random(7);
    for (Vec3& p : mesh.points) p[2] = random.symmetric();
    const Far::Topology control = toTopology(mesh);
    const Far::Refinement refinement = clampedSteps(mesh, 3);
    for (std::int32_t steps = 1; steps <= 3; ++steps) {
      auto chain = Far::halfBox(control, steps, {.conversion = Far::HalfBoxConversion::none});
      ASSERT_TRUE(chain);
      chain->push_back(Far::clampStep());
      const auto natural = Far::refine(control, *chain);
      ASSERT_TRUE(natural) << natural.error().message;
      const auto curve = [&](const Far::Refinement& r) {
        std::vector<Vec3> points;
        const std::vector<Vec3> all = levelPoints<double>(r, steps + 1, mesh.points);
        for (const std::int32_t h : r.level(steps + 1).topology.boundary()) {
          points.push_back(at(all, r.level(steps + 1).topology.vert(h)));
        }
        return points;
      };
      const std::vector<Vec3> clampedCurve = curve(refinement);
      const std::vector<Vec3> naturalCurve = curve(*natural);
      ASSERT_EQ(clampedCurve.size(), naturalCurve.size());
      for (const Vec3& p : clampedCurve) {
        double nearest = 1;
        for (const Vec3& q : naturalCurve) nearest = std::min(nearest, distance(p, q));
        ASSERT_LT(nearest, 4e-15) << "after " << steps << " steps";
      }
    }
  }
}

TEST(HalfBoxClamped, LeavesClosedMeshesToTheOrdinaryScheme) {
  const Far::Topology control = toTopology(dodecahedron());
  const auto chain = Far::halfBox(control, 2, clamped());
  ASSERT_TRUE(chain);
  ASSERT_EQ(chain->size(), 2U);
  EXPECT_EQ(chain->front().split.name, Far::halfBox(control, 1)->front().split.name);
}

TEST(HalfBoxClamped, CountsAreExactFromTheClampedLevelOnAndBoundsBefore) {
  const PolyMesh mesh = randomThreeValent(3);
  const Far::Refinement refinement = clampedSteps(mesh, 2);
  const auto chain = *Far::halfBox(toTopology(mesh), 2, clamped());
  const auto bounds = Far::predict(refinement.level(0).topology, chain);
  const auto exact = Far::predict(refinement.level(1).topology, std::span(chain).subspan(1));
  for (std::int32_t level = 0; level <= 3; ++level) {
    const Far::Topology& topology = refinement.level(level).topology;
    EXPECT_EQ(at(bounds, level).exact, level == 0);
    EXPECT_GE(at(bounds, level).vertices, topology.vertexCount());
    EXPECT_GE(at(bounds, level).edges, topology.edgeCount());
    EXPECT_GE(at(bounds, level).faces, topology.faceCount());
    EXPECT_GE(at(bounds, level).halfEdges, topology.halfEdgeCount());
    EXPECT_GE(at(bounds, level).boundaryEdges, topology.boundaryEdgeCount());
    if (level == 0) continue;
    EXPECT_TRUE(at(exact, level - 1).exact);
    EXPECT_EQ(at(exact, level - 1).vertices, topology.vertexCount());
    EXPECT_EQ(at(exact, level - 1).edges, topology.edgeCount());
    EXPECT_EQ(at(exact, level - 1).faces, topology.faceCount());
    EXPECT_EQ(at(exact, level - 1).halfEdges, topology.halfEdgeCount());
    EXPECT_EQ(at(exact, level - 1).boundaryEdges, topology.boundaryEdgeCount());
  }
}

TEST(HalfBoxClamped, FacesKnowWhatTheyCameFrom) {
  const PolyMesh mesh = honeycombPatches().front();
  const Far::Refinement refinement = clampedSteps(mesh, 1);
  const Far::Topology& first = refinement.level(1).topology;
  const std::vector<Far::Origin> origins = refinement.faceOrigins(1);
  const std::vector<Far::Origin> later = refinement.faceOrigins(2);
  for (std::int32_t f = 0; f < first.faceCount(); ++f) {
    const bool gap = first.run(f).kind == Far::FaceKind::clampedGap;
    EXPECT_EQ(at(origins, f).vertex, gap);
    EXPECT_EQ(at(origins, f).level, gap ? 1 : 0);
  }
  const Far::Topology& second = refinement.level(2).topology;
  for (std::int32_t f = 0; f < second.faceCount(); ++f) {
    if (second.parentKind(f) != Far::FaceParent::face) continue;
    EXPECT_EQ(at(later, f), at(origins, second.parents()[static_cast<std::size_t>(f)]));
  }
}

TEST(HalfBoxClamped, CanBeFollowedByAnotherScheme) {
  const PolyMesh mesh = honeycombPatches().front();
  const Far::Topology control = toTopology(mesh);
  const auto refinement =
      Far::refine(control, std::vector<Far::Scheme>{Far::clampStep(), *Far::akleman(), *Far::akleman()});
  ASSERT_TRUE(refinement) << refinement.error().message;
  EXPECT_TRUE(isManifold(toMesh(refinement->last().topology, {}).faces));
  EXPECT_EQ(refinement->last().topology.eulerCharacteristic(), 1);
  for (const StencilRow& row : expandRows(refinement->level(2).table)) {
    double sum = 0;
    for (const auto& entry : row) sum += entry.second;
    ASSERT_NEAR(sum, 1, 1e-12);
  }
}

TEST(HalfBoxClamped, RefusesWhatHasNoClampedBoundary) {
  const auto fourValent = Far::halfBox(toTopology(grid(3, 3)), 1, clamped());
  ASSERT_FALSE(fourValent);
  EXPECT_EQ(fourValent.error().code, ErrorCode::invalidMesh);
  EXPECT_NE(fourValent.error().message.find("edges"), std::string::npos) << fourValent.error().message;

  const Far::Topology alone = toTopology({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}});
  const auto nothing = Far::refine(alone, *Far::halfBox(alone, 1, clamped()));
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, ErrorCode::invalidMesh);
  EXPECT_NE(nothing.error().message.find("larger mesh"), std::string::npos) << nothing.error().message;

  Far::HalfBoxOptions heavy = clamped();
  heavy.tunedWeights = {{4, 0.7}};
  const auto weight = Far::halfBox(toTopology(honeycombPatches().front()), 1, heavy);
  ASSERT_FALSE(weight);
  EXPECT_EQ(weight.error().code, ErrorCode::invalidOption);

  const auto unclamped = Far::refine(toTopology(honeycombPatches().front()), *Far::halfBoxStep(clamped(), false), 1);
  ASSERT_FALSE(unclamped);
  EXPECT_NE(unclamped.error().message.find("clamp step"), std::string::npos) << unclamped.error().message;
}

}  // namespace
}  // namespace honeycomb::Test
