#include "far/schemes/creases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "far/schemes/akleman.h"
#include "far/schemes/doo_sabin.h"
#include "far/schemes/zhang_wang.h"
#include "tests/support/creased.h"
#include "tests/support/mesh_compare.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

enum class Family { akleman, zhangWang };

std::vector<Far::Scheme> chainOf(Family family, const Far::Topology& control, std::int32_t levels) {
  if (family == Family::zhangWang) {
    Far::ZhangWangOptions options;
    options.pull.rule = Far::CentralPull::Rule::kobbelt;
    options.boundary = Far::BoundaryRule::brick;
    options.unchecked = true;
    return *Far::zhangWang(control, levels, options);
  }
  return {static_cast<std::size_t>(levels), *Far::akleman({})};
}

Far::Refinement refinedFrom(const Far::Topology& control, Family family, std::int32_t levels) {
  return refinedBy(control, chainOf(family, control, levels));
}

/// The same loops on points that all coincide: such meshes match if their connectivity is the same.
PolyMesh withoutPoints(PolyMesh mesh) {
  for (Vec3& p : mesh.points) p = {0, 0, 0};
  return mesh;
}

TEST(Creases, SharpSidesKeepTheSamePoints) {
  for (const CreasedMesh& c : creasedMeshes(Far::kSharp)) {
    for (const Family family : {Family::akleman, Family::zhangWang}) {
      SCOPED_TRACE(c.name);
      const Far::Refinement refinement = refinedFrom(creased(c.mesh, c.creases), family, 4);
      for (std::int32_t k = 1; k <= 4; ++k) {
        EXPECT_FALSE(refinement.level(k).topology.creases().empty());
        EXPECT_EQ(sidesDiffer(refinement.level(k), levelPoints<double>(refinement, k, c.mesh.points)), "");
        EXPECT_EQ(sidesDiffer(refinement.level(k), levelPoints<float>(refinement, k, c.mesh.points)), "");
      }
    }
  }
}

TEST(Creases, ASharpLoopRefinesAsTheMeshCutOpenThere) {
  const PolyMesh whole = dodecahedron();
  const PolyMesh open = detached(whole, 4);
  for (const Family family : {Family::akleman, Family::zhangWang}) {
    const Far::Refinement sharp = refinedFrom(creased(whole, creasesRound(whole, 4, Far::kSharp)), family, 4);
    const Far::Refinement cut = refinedFrom(toTopology(open), family, 4);
    for (std::int32_t k = 1; k <= 4; ++k) {
      const MeshMatch match = matchMeshes(levelMesh(sharp, k, whole.points), levelMesh(cut, k, open.points), 1e-12);
      EXPECT_TRUE(match.same) << "level " << k << ": " << match.why;
    }
  }
}

TEST(Creases, ClosedMeshesHaveTheConnectivityWithoutCreases) {
  for (const double sharpness : {0.5, 1.0, 2.0, 2.5, 3.0}) {
    const auto closedAt = static_cast<std::int32_t>(std::ceil(sharpness));
    for (const CreasedMesh& c : creasedMeshes(sharpness)) {
      SCOPED_TRACE(c.name + ", sharpness " + std::to_string(sharpness));
      const Far::Refinement semi = refinedFrom(creased(c.mesh, c.creases), Family::akleman, 3);
      const Far::Refinement smooth = refinedFrom(toTopology(c.mesh), Family::akleman, 3);
      for (std::int32_t k = 1; k < closedAt; ++k) EXPECT_FALSE(semi.level(k).topology.creases().empty());
      for (std::int32_t k = closedAt; k <= 3; ++k) {
        EXPECT_TRUE(semi.level(k).topology.creases().empty());
        const MeshMatch match = matchMeshes(withoutPoints(levelMesh(semi, k, c.mesh.points)),
                                            withoutPoints(levelMesh(smooth, k, c.mesh.points)), 0);
        EXPECT_TRUE(match.same) << "level " << k << ": " << match.why;
      }
    }
  }
}

TEST(Creases, RowsAreConvexOnSharpAndOnClosingLevels) {
  for (const double sharpness : {0.3, 1.0, 1.5, 2.0, 2.75, 3.0, Far::kSharp}) {
    for (const CreasedMesh& c : creasedMeshes(sharpness)) {
      for (const Family family : {Family::akleman, Family::zhangWang}) {
        SCOPED_TRACE(c.name + ", sharpness " + std::to_string(sharpness));
        const Far::Refinement refinement = refinedFrom(creased(c.mesh, c.creases), family, 4);
        for (std::int32_t k = 1; k <= 4; ++k) {
          const Far::LevelTable& table = refinement.level(k).table;
          ASSERT_EQ(table.sourceCount, refinement.level(k - 1).pointCount());
          ASSERT_EQ(table.targetCount, refinement.level(k).pointCount());
          for (const StencilRow& row : expandRows(table)) {
            double sum = 0;
            for (const auto& [point, weight] : row) {
              sum += weight;
              ASSERT_GE(weight, -1e-15) << "level " << k;
              ASSERT_TRUE(point >= 0 && point < table.sourceCount);
            }
            ASSERT_NEAR(sum, 1, 1e-12) << "level " << k;
          }
        }
      }
    }
  }
}

TEST(Creases, SharpnessZeroIsNoCrease) {
  const PolyMesh mesh = cube();
  const Far::Refinement none = refinedFrom(creased(mesh, creasesRound(mesh, 0, 0)), Family::akleman, 3);
  const Far::Refinement smooth = refinedFrom(toTopology(mesh), Family::akleman, 3);
  EXPECT_EQ(levelPoints<double>(none, 3, mesh.points), levelPoints<double>(smooth, 3, mesh.points));
}

/// At the level of the last step points have the same numbers whatever the fraction.
TEST(Creases, FractionsLieBetweenTheWholeSteps) {
  for (const double whole : {0.0, 1.0, 2.0}) {
    const auto level = static_cast<std::int32_t>(whole) + 1;
    const auto pointsAt = [&](const CreasedMesh& c, Family family, double sharpness) {
      std::vector<Far::Crease> creases = c.creases;
      for (Far::Crease& crease : creases) crease.sharpness = sharpness;
      return levelPoints<double>(refinedFrom(creased(c.mesh, creases), family, level), level, c.mesh.points);
    };
    for (const CreasedMesh& c : creasedMeshes(1)) {
      for (const Family family : {Family::akleman, Family::zhangWang}) {
        const auto smooth = pointsAt(c, family, whole + 1e-14);
        const auto half = pointsAt(c, family, whole + 0.5);
        const auto sharp = pointsAt(c, family, whole + 1);
        double moved = 0;
        for (std::size_t v = 0; v < half.size(); ++v) {
          ASSERT_LT(distance(half[v], 0.5 * (smooth[v] + sharp[v])), 1e-12) << c.name << ", point " << v;
          moved = std::max(moved, distance(smooth[v], sharp[v]));
        }
        // Akleman's first step doesn't look over the edges, sharp or not.
        const bool moves = level > 1 || family == Family::zhangWang;
        EXPECT_EQ(moved > 1e-3, moves) << c.name << ", level " << level << ": " << moved;
      }
    }
  }
}

TEST(Creases, JustPastAWholeSharpnessTheSurfaceIsThatOfTheWholeSharpness) {
  for (const double whole : {1.0, 2.0}) {
    for (const CreasedMesh& c : creasedMeshes(whole)) {
      std::vector<Far::Crease> more = c.creases;
      for (Far::Crease& crease : more) crease.sharpness += 1e-13;
      for (const Family family : {Family::akleman, Family::zhangWang}) {
        const auto level = static_cast<std::int32_t>(whole) + 1;
        const Far::Refinement a = refinedFrom(creased(c.mesh, c.creases), family, level);
        const Far::Refinement b = refinedFrom(creased(c.mesh, more), family, level);
        const MeshMatch match =
            matchMeshes(levelMesh(a, level, c.mesh.points), levelMesh(b, level, c.mesh.points), 1e-11);
        EXPECT_TRUE(match.same) << c.name << ": " << match.why;
      }
    }
  }
}

TEST(Creases, EachSharpnessOfAMeshEndsAtItsOwnLevel) {
  const PolyMesh mesh = prism(7);
  std::vector<Far::Crease> creases;
  double next = 1.5;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.faces[f].size() != 7) continue;
    for (const Far::Crease& crease : creasesRound(mesh, f, next)) creases.push_back(crease);
    next = 3;
  }
  const Far::Refinement refinement = refinedFrom(creased(mesh, creases), Family::zhangWang, 4);
  const auto sides = [&](std::int32_t k, double sharpness) {
    const auto all = refinement.level(k).topology.creases();
    return std::count_if(all.begin(), all.end(),
                         [&](const Far::CreaseEdge& c) { return c.sharpness == sharpness - k; });
  };
  EXPECT_EQ(sides(1, 1.5), 7);
  EXPECT_EQ(sides(1, 3), 7);
  EXPECT_EQ(sides(2, 1.5), 0);
  EXPECT_EQ(sides(2, 3), 14);
  EXPECT_TRUE(refinement.level(3).topology.closed());
  EXPECT_EQ(refinement.level(3).topology.vertexCount(), 42 * 9);
}

TEST(Creases, ACubeWithSharpEdgesStaysACube) {
  const PolyMesh mesh = cube();
  const Far::Refinement refinement =
      refinedFrom(creased(mesh, creasesEverywhere(mesh, Far::kSharp)), Family::akleman, 4);
  const std::vector<Vec3> points = levelPoints<double>(refinement, 4, mesh.points);
  double side = 0;
  for (const Vec3& p : mesh.points) side = std::max(side, std::abs(p[0]));
  for (const Vec3& p : points) {
    const double outmost = std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    EXPECT_NEAR(outmost, side, 1e-12);
  }
  for (const Vec3& corner : mesh.points) EXPECT_EQ(std::count(points.begin(), points.end(), corner), 3);
}

TEST(Creases, ATaggedCornerOnACreaseStaysWhileItIsSharp) {
  const PolyMesh mesh = cube();
  const std::size_t corner = mesh.faces[0][0];
  const auto copies = [&](const std::vector<std::size_t>& tags, std::int32_t k) {
    const Far::Refinement refinement = refinedFrom(creased(mesh, creasesRound(mesh, 0, 2), tags), Family::akleman, 3);
    const std::vector<Vec3> points = levelPoints<double>(refinement, k, mesh.points);
    return std::count(points.begin(), points.end(), mesh.points[corner]);
  };
  EXPECT_EQ(copies({corner}, 1), 2);
  EXPECT_EQ(copies({}, 1), 0);
  EXPECT_EQ(copies({corner}, 2), 0);
}

/// It lies in the middle of the new points of the face round it.
TEST(Creases, AnEndInsideTheMeshFollowsTheSurface) {
  const PolyMesh mesh = torus(5, 6);
  for (const Family family : {Family::akleman, Family::zhangWang}) {
    const Far::Refinement refinement = refinedFrom(creased(mesh, {{0, 1, Far::kSharp}}), family, 3);
    for (std::int32_t k = 1; k <= 3; ++k) {
      const std::vector<Vec3> points = levelPoints<double>(refinement, k, mesh.points);
      const Far::Topology& topology = refinement.level(k).topology;
      int ends = 0;
      for (std::int32_t f = 0; f < topology.faceCount(); ++f) {
        if (topology.run(f).kind != Far::FaceKind::corner) continue;
        std::vector<Vec3> face;
        const std::int32_t first = at(topology.faceOffsets(), f);
        for (std::int32_t h = first; h < first + topology.sides(f); ++h) face.push_back(at(points, topology.vert(h)));
        const Vec3 end = face[1];
        face.erase(face.begin(), face.begin() + 3);
        EXPECT_LT(distance(end, centroid(face)), 1e-14) << "level " << k;
        ++ends;
      }
      EXPECT_EQ(ends, 2) << "level " << k;
    }
  }
}

TEST(Creases, CantHaveInterpolatedVerticesOnThem) {
  Far::ZhangWangOptions options;
  options.interpolatedVertices = {3};
  options.unchecked = true;
  const auto chain = Far::zhangWang(creased(cube(), creasesEverywhere(cube(), 2)), 2, options);
  ASSERT_FALSE(chain.has_value());
  EXPECT_THAT(chain.error().message, AllOf(HasSubstr("vertex 3"), HasSubstr("crease")));
}

TEST(Creases, RefinedFacesAndVerticesNameTheirOrigins) {
  const PolyMesh mesh = dodecahedron();
  const Far::Refinement refinement = refinedFrom(creased(mesh, creasesRound(mesh, 2, 2.5)), Family::akleman, 4);
  for (std::int32_t k = 1; k <= 4; ++k) {
    std::vector<int> ofFace(12), ofVertex(20);
    for (const Far::Origin& origin : refinement.faceOrigins(k)) ++at(origin.vertex ? ofVertex : ofFace, origin.element);
    EXPECT_EQ(std::count(ofFace.begin(), ofFace.end(), 0), 0) << "level " << k;
    EXPECT_EQ(std::count(ofVertex.begin(), ofVertex.end(), 0), 0) << "level " << k;
  }
}

TEST(Creases, PredictionsAreExactOrBounds) {
  for (const double sharpness : {0.5, 2.0, Far::kSharp}) {
    for (const CreasedMesh& c : creasedMeshes(sharpness)) {
      const Far::Topology control = creased(c.mesh, c.creases);
      const Far::Refinement refinement = refinedFrom(control, Family::akleman, 4);
      const auto predicted = Far::predict(control, chainOf(Family::akleman, control, 4));
      for (std::int32_t k = 0; k <= 4; ++k) {
        const Far::Topology& level = refinement.level(k).topology;
        EXPECT_TRUE(at(predicted, k).exact) << c.name << ", level " << k;
        EXPECT_EQ(at(predicted, k).vertices, level.vertexCount()) << c.name << ", level " << k;
        EXPECT_EQ(at(predicted, k).halfEdges, level.halfEdgeCount()) << c.name << ", level " << k;
        EXPECT_EQ(at(predicted, k).faces, level.faceCount()) << c.name << ", level " << k;
      }
    }
  }
}

std::string refusal(const PolyMesh& mesh, const std::vector<Far::Crease>& creases) {
  Far::Polygons polygons = toPolygons(mesh);
  polygons.creases = creases;
  const Result<Far::Topology> topology = Far::Topology::create(polygons);
  return topology ? "" : topology.error().message;
}

TEST(Creases, AreRefusedWithBothVertices) {
  const double nan = std::nan("");
  EXPECT_THAT(refusal(grid(2, 2), {{0, 4, 1}}), AllOf(HasSubstr("vertices 0 and 4"), HasSubstr("no edge")));
  EXPECT_THAT(refusal(grid(2, 2), {{4, 99, 1}}), AllOf(HasSubstr("vertices 4 and 99"), HasSubstr("no edge")));
  for (const double sharpness : {-0.5, nan, HUGE_VAL}) {
    EXPECT_THAT(refusal(grid(2, 2), {{4, 1, sharpness}}), AllOf(HasSubstr("vertices 1 and 4"), HasSubstr("0 to 10")));
  }
  EXPECT_THAT(refusal(grid(2, 2), {{1, 4, 1}, {4, 1, 2}}), AllOf(HasSubstr("vertices 1 and 4"), HasSubstr("two")));
  EXPECT_EQ(refusal(grid(2, 2), {{1, 4, 1}, {4, 1, 1}, {0, 1, 3}}), "");
}

TEST(Creases, OnABoundarySayNothing) {
  EXPECT_TRUE(creased(grid(2, 2), {{0, 1, 3}}).creases().empty());
}

TEST(Creases, SchemesWithoutARuleSaySo) {
  const PolyMesh mesh = torus(4, 4);
  const Far::Topology control = creased(mesh, {{1, 2, 3}});
  const auto message = [](const Far::Topology& topology, const std::vector<Far::Scheme>& chain) {
    const auto refinement = Far::refine(topology, chain, {});
    return refinement ? std::string() : refinement.error().message;
  };
  const Far::Scheme dooSabin = Far::dooSabin();
  EXPECT_THAT(message(control, {dooSabin}), AllOf(HasSubstr("doo-sabin"), HasSubstr("vertices 1 and 2")));
  const Far::Scheme honeycomb = *Far::akleman({});
  EXPECT_THAT(message(control, {honeycomb, honeycomb, dooSabin}), HasSubstr("doo-sabin"));
  EXPECT_EQ(message(control, {honeycomb, honeycomb, honeycomb, dooSabin}), "");
  Far::AklemanOptions options;
  options.boundary = Far::BoundaryRule::eq16;
  const Far::Scheme eq16 = *Far::akleman(options);
  EXPECT_EQ(message(control, {eq16, eq16, eq16, eq16}), "");
  EXPECT_THAT(message(creased(grid(3, 3), {{5, 6, 1}}), {eq16}), HasSubstr("brick"));
}

}  // namespace
}  // namespace honeycomb::Test
