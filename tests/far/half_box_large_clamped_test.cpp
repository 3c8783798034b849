#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "far/schemes/half_box.h"
#include "far/tables/level_step.h"
#include "tests/support/creased.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"
#include "tests/support/table_rows.h"

// Clamped half-box creases at a vertex of N faces: sides and corners of N points inside, whose rows read sums.
namespace honeycomb::Test {
namespace {

struct ClampedWheel {
  std::string name;
  Far::Topology control;
  std::vector<Far::Scheme> chain;
};

std::vector<ClampedWheel> clampedWheels(std::size_t n, Far::HalfBoxCorners corners) {
  const auto far = static_cast<std::int32_t>(1 + n / 2);
  const auto quarter = static_cast<std::int32_t>(1 + n / 4);
  const std::vector<Far::Crease> through{{1, 0, Far::kSharp}, {0, far, Far::kSharp}};
  std::vector<Far::Crease> three = through;
  three.push_back({0, quarter, Far::kSharp});
  Far::HalfBoxOptions options;
  options.boundary = Far::HalfBoxBoundary::clamped;
  options.corners = corners;
  std::vector<ClampedWheel> wheels;
  const auto add = [&](const std::string& name, const std::vector<Far::Crease>& creases) {
    const Far::Topology control = creased(wheel(n), creases);
    wheels.push_back({name, control, *Far::halfBox(control, 2, options)});
  };
  add("sides", through);
  add("a side and two corners", three);
  add("an end", {{1, 0, Far::kSharp}});
  return wheels;
}

/// The largest difference of a weight between two rows.
double rowDistance(StencilRow a, const StencilRow& b) {
  for (const auto& [point, weight] : b) a[point] -= weight;
  double largest = 0;
  for (const auto& entry : a) largest = std::max(largest, std::abs(entry.second));
  return largest;
}

/// The new points of a level whose rows aren't what the scheme writes down where no sums have names.
std::vector<std::int32_t> otherRows(const Far::Level& parent, const Far::Scheme& scheme, const Far::LevelTable& table) {
  const auto split = Far::splitFor(parent.topology, scheme).apply(parent.topology);
  const std::vector<StencilRow> rows = expandRows(table);
  std::vector<std::int32_t> other;
  for (std::size_t i = 0; i < split->otherPoints.size(); ++i) {
    Far::Row row;
    scheme.pointRow(parent.points(), split->otherPoints[i], row);
    StencilRow expected;
    for (const Far::Weight& entry : row) expected[entry.point] += entry.weight;
    const std::int32_t point = split->cornerPoints + static_cast<std::int32_t>(i);
    if (!(rowDistance(expected, at(rows, point)) < 1e-14)) other.push_back(point);
  }
  return other;
}

TEST(LargeClampedFaces, HaveTheRowsOfFacesThatAreReadCornerByCorner) {
  for (const std::size_t n : {140U, 141U}) {
    for (const auto corners : {Far::HalfBoxCorners::convex, Far::HalfBoxCorners::smooth}) {
      for (const ClampedWheel& c : clampedWheels(n, corners)) {
        const Far::Refinement refinement = refinedBy(c.control, c.chain);
        for (const std::int32_t k : {3, 4}) {
          SCOPED_TRACE(c.name + " of " + std::to_string(n) + ", level " + std::to_string(k));
          const Far::Level& level = refinement.level(k);
          if (corners == Far::HalfBoxCorners::convex || c.name == "sides") {
            EXPECT_GT(level.table.summed.rowCount(), static_cast<std::int32_t>(n / 2) - 2);
          }
          const std::vector<std::int32_t> other =
              otherRows(refinement.level(k - 1), at(c.chain, static_cast<std::int32_t>(k - 1)), level.table);
          EXPECT_EQ(other.size(), c.name == "an end" ? 1U : 0U) << "but for the barycentre at the end";
        }
      }
    }
  }
}

TEST(LargeClampedFaces, HaveTheEndOfACreaseInTheMiddleOfTheNewPointsRoundIt) {
  const PolyMesh mesh = wheel(100);
  const ClampedWheel c = clampedWheels(100, Far::HalfBoxCorners::convex).back();
  const Far::Refinement refinement = refinedBy(c.control, c.chain);
  const std::vector<Vec3> points = levelPoints<double>(refinement, 4, mesh.points);
  const Far::Topology& level = refinement.level(4).topology;
  std::int32_t large = 0;
  for (std::int32_t f = 0; f < level.faceCount(); ++f) {
    if (level.run(f).kind != Far::FaceKind::clampedCorner || level.sides(f) < 100) continue;
    const std::int32_t first = at(level.faceOffsets(), f);
    Vec3 sum{};
    for (std::int32_t h = first + 3; h < first + level.sides(f); ++h) sum = sum + at(points, level.vert(h));
    EXPECT_LT(distance((1.0 / (level.sides(f) - 3)) * sum, at(points, level.vert(first + 1))), 1e-13);
    ++large;
  }
  EXPECT_EQ(large, 1);
}

std::vector<std::int64_t> clampedBytes(std::size_t n, Far::HalfBoxCorners corners) {
  std::vector<std::int64_t> bytes;
  for (const ClampedWheel& c : clampedWheels(n, corners)) {
    bytes.push_back(refinedBy(c.control, c.chain, true).byteCount());
  }
  return bytes;
}

TEST(LargeClampedFaces, HaveTablesOfLinearSize) {
  for (const auto corners : {Far::HalfBoxCorners::convex, Far::HalfBoxCorners::smooth}) {
    const std::vector<std::int64_t> small = clampedBytes(150, corners);
    const std::vector<std::int64_t> large = clampedBytes(600, corners);
    ASSERT_EQ(small.size(), large.size());
    for (std::size_t i = 0; i < small.size(); ++i) {
      EXPECT_LT(static_cast<double>(large[i]), 4.2 * static_cast<double>(small[i])) << "case " << i;
    }
  }
}

}  // namespace
}  // namespace honeycomb::Test
