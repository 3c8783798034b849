#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "far/schemes/akleman.h"
#include "far/schemes/zhang_wang.h"
#include "far/tables/level_rows.h"
#include "tests/support/creased.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

// Many creases that end at one face or vertex of N sides.
namespace honeycomb::Test {
namespace {

std::vector<std::vector<Far::Scheme>> creasingChains(const Far::Topology& control, std::int32_t levels) {
  Far::ZhangWangOptions options;
  options.boundary = Far::BoundaryRule::brick;
  options.unchecked = true;
  return {{static_cast<std::size_t>(levels), *Far::akleman({})}, *Far::zhangWang(control, levels, options)};
}

/// The mesh so irregular that no sum of a face vanishes.
std::vector<Vec3> roughPoints(const PolyMesh& mesh) {
  Random random(17);
  std::vector<Vec3> points = mesh.points;
  for (Vec3& p : points) p = p + Vec3{random.symmetric(), random.symmetric(), random.symmetric()};
  return points;
}

std::int64_t tableBytes(const Far::Refinement& refinement) {
  std::int64_t total = 0;
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) total += refinement.level(k).table.byteCount();
  return total;
}

std::vector<std::int64_t> bytesWithCreases(std::size_t n, double sharpness) {
  std::vector<std::int64_t> bytes;
  for (const CreasedMesh& c : meetingCreases(n, sharpness)) {
    const Far::Topology control = creased(c.mesh, c.creases);
    for (const auto& chain : creasingChains(control, 3)) bytes.push_back(tableBytes(refinedBy(control, chain)));
  }
  return bytes;
}

TEST(LargeFacesWithCreases, HaveTablesOfLinearSize) {
  for (const double sharpness : {0.5, 1.5, 2.0, 10.0}) {
    const std::vector<std::int64_t> small = bytesWithCreases(100, sharpness);
    const std::vector<std::int64_t> large = bytesWithCreases(400, sharpness);
    ASSERT_EQ(small.size(), large.size());
    for (std::size_t i = 0; i < small.size(); ++i) {
      EXPECT_LT(large[i], 4.2 * static_cast<double>(small[i])) << "sharpness " << sharpness << ", case " << i;
    }
  }
}

/// The points of the level at which creases of that sharpness are closed.
std::vector<Vec3> closingPoints(const CreasedMesh& c, std::size_t family, std::int32_t level) {
  const Far::Topology control = creased(c.mesh, c.creases);
  return levelPoints<double>(refinedBy(control, creasingChains(control, level)[family]), level, roughPoints(c.mesh));
}

TEST(LargeFacesWithCreases, CloseHalfWayBetweenSmoothAndSharp) {
  constexpr double kHardlyLeft = 1e-10;
  for (const std::int32_t level : {1, 2}) {
    const auto halfWay = meetingCreases(80, level - 0.5);
    const auto smooth = meetingCreases(80, level - 1 + kHardlyLeft);
    const auto sharp = meetingCreases(80, level);
    for (std::size_t i = 0; i < halfWay.size(); ++i) {
      for (const std::size_t family : {std::size_t{0}, std::size_t{1}}) {
        SCOPED_TRACE(testing::Message() << halfWay[i].name << ", level " << level << ", chain " << family);
        const auto points = closingPoints(halfWay[i], family, level);
        const auto a = closingPoints(smooth[i], family, level);
        const auto b = closingPoints(sharp[i], family, level);
        ASSERT_EQ(points.size(), a.size());
        ASSERT_EQ(points.size(), b.size());
        for (std::size_t v = 0; v < points.size(); ++v) {
          ASSERT_LT(distance(points[v], 0.5 * (a[v] + b[v])), 1e-8) << "point " << v;
        }
      }
    }
  }
}

TEST(LargeFacesWithCreases, HaveTheirEndsInTheMiddleOfTheNewPointsRoundThem) {
  for (const std::size_t family : {std::size_t{0}, std::size_t{1}}) {
    const CreasedMesh c = meetingCreases(80, 10).front();
    const Far::Topology control = creased(c.mesh, c.creases);
    const Far::Refinement refinement = refinedBy(control, creasingChains(control, 1)[family]);
    const auto points = levelPoints<double>(refinement, 1, roughPoints(c.mesh));
    const Far::Topology& child = refinement.level(1).topology;
    std::int32_t ends = 0;
    for (const Far::CreaseEdge& crease : child.creases()) {
      if (child.next(crease.halfEdge) != crease.mate && child.next(crease.mate) != crease.halfEdge) continue;
      const std::int32_t into = child.next(crease.halfEdge) == crease.mate ? crease.halfEdge : crease.mate;
      const std::int32_t face = child.face(into);
      const std::int32_t first = at(child.faceOffsets(), face);
      Vec3 sum{};
      for (std::int32_t h = first + 3; h < first + child.sides(face); ++h) sum = sum + at(points, child.vert(h));
      EXPECT_LT(distance((1.0 / (child.sides(face) - 3)) * sum, at(points, child.dest(into))), 1e-13);
      ++ends;
    }
    EXPECT_EQ(ends, 160);
  }
}

using DenseRow = std::map<std::int32_t, double>;

void expectSameRow(const Far::LevelRows& rows, std::int32_t output) {
  DenseRow whole;
  rows.visit(output, [&](std::int32_t point, double weight) { whole[point] += weight; });
  DenseRow parts;
  std::int32_t calls = 0;
  const auto take = [&](std::int32_t point, double weight) {
    parts[point] += weight;
    ++calls;
  };
  rows.visitApart(output, take, [&](const Far::LevelRows::Sum& sum, double share) {
    ++calls;
    rows.visitSum(sum, [&](std::int32_t point, double weight) { parts[point] += share * weight; });
  });
  ASSERT_EQ(whole.size(), parts.size()) << "output " << output;
  for (const auto& entry : whole) ASSERT_NEAR(entry.second, parts[entry.first], 1e-15) << "output " << output;
  ASSERT_LE(calls, 40) << "output " << output << " is spelled out";
}

TEST(LargeFacesWithCreases, GiveTheirRowsInFewPartsThatAddUp) {
  for (const CreasedMesh& c : meetingCreases(90, 1.5)) {
    const Far::Topology control = creased(c.mesh, c.creases);
    for (const auto& chain : creasingChains(control, 2)) {
      const Far::Refinement refinement = refinedBy(control, chain);
      for (const std::int32_t level : {1, 2}) {
        const Far::LevelRows rows(refinement.level(level).table);
        for (std::int32_t output = 0; output < refinement.level(level).topology.vertexCount(); ++output) {
          ASSERT_NO_FATAL_FAILURE(expectSameRow(rows, output)) << c.name << ", level " << level;
        }
      }
    }
  }
}

}  // namespace
}  // namespace honeycomb::Test
