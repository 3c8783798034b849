#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "far/tables/patch_rows.h"
#include "osd/cpu_evaluator.h"
#include "tests/support/patch_surfaces.h"
#include "tests/support/shapes.h"

// Half-box patches next to faces of many sides, of which rows read sums.
namespace honeycomb::Test {
namespace {

std::vector<Far::PatchSample> samplesOf(const Far::PatchTable& table) {
  std::vector<Far::PatchSample> samples;
  for (std::int32_t p = 0; p < table.patchCount(); ++p) {
    samples.push_back({p, {0.2, 0.3, 0.5}});
    for (std::size_t i = 0; i < 3; ++i) {
      Far::Barycentric corner{};
      corner[i] = 1;
      Far::Barycentric near{0.01, 0.01, 0.01};
      near[i] = 0.98;
      samples.insert(samples.end(), {{p, corner}, {p, near}});
    }
  }
  return samples;
}

/// Of a table's rows, the `count` from the first on, applied to points of which no sum vanishes.
std::vector<Vec3> appliedRows(const Far::LevelTable& table, std::size_t first, std::size_t count,
                              const std::vector<Vec3>& points) {
  std::vector<double> source;
  for (const Vec3& p : points) source.insert(source.end(), p.begin(), p.end());
  std::vector<double> target(3 * static_cast<std::size_t>(table.targetCount));
  Osd::SerialEvaluator evaluator;
  const Osd::BufferDescriptor desc{0, 3, 3};
  EXPECT_TRUE((evaluator.evaluate<double>(table, {source, desc}, {target, desc}).has_value()));
  std::vector<Vec3> rows;
  for (std::size_t i = first; i < first + count; ++i)
    rows.push_back({target[3 * i], target[3 * i + 1], target[3 * i + 2]});
  return rows;
}

PolyMesh roughPrism(std::size_t n) {
  PolyMesh mesh = prism(n);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const auto t = static_cast<double>(i);
    mesh.points[i] = mesh.points[i] + Vec3{0.2 * std::sin(3 * t), 0.3 * std::cos(5 * t), 0.1 * std::sin(7 * t)};
  }
  return mesh;
}

TEST(PatchesOfLargeFaces, HaveStencilsThatGiveWhatEvaluationGives) {
  for (const std::size_t n : {64U, 65U, 300U}) {
    SCOPED_TRACE(n);
    const PatchSurface surface(roughPrism(n));
    const std::vector<Far::PatchSample> samples = samplesOf(surface.table);
    const auto stencils = surface.table.limitStencils(samples);
    const auto frames = surface.table.limitFrames(samples);
    ASSERT_TRUE(stencils.has_value() && frames.has_value());
    EXPECT_EQ(stencils->positions.projected.size(), n > 64 ? 6U : 0U) << "mean, cosine and sine of two faces";
    const std::array<const Far::LevelTable*, 3> tables{&stencils->positions, &stencils->du, &stencils->dv};
    for (std::size_t part = 0; part < 3; ++part) {
      const auto apart = appliedRows(*tables[part], 0, samples.size(), surface.mesh.points);
      const auto stacked = appliedRows(*frames, part * samples.size(), samples.size(), surface.mesh.points);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const Far::PatchPoint point = surface.at(samples[i].patch, samples[i].barycentric);
        const Vec3 expected = std::array{point.position, point.du, point.dv}[part];
        ASSERT_LT(distance(apart[i], expected), 1e-10) << "sample " << i << ", part " << part;
        ASSERT_EQ(apart[i], stacked[i]) << "sample " << i << ", part " << part;
      }
    }
  }
}

TEST(PatchesOfLargeFaces, HaveStencilsWhoseWeightsSumUp) {
  const PatchSurface surface(prism(70));
  const std::vector<Far::PatchSample> samples = samplesOf(surface.table);
  const auto rows = expandRows(*surface.table.limitFrames(samples));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double sum = 0;
    for (const auto& entry : rows[i]) sum += entry.second;
    ASSERT_NEAR(sum, i < samples.size() ? 1 : 0, 1e-11) << "row " << i;
  }
}

std::int64_t stencilBytes(std::size_t n) {
  const PatchSurface surface(prism(n));
  return surface.table.limitFrames(surface.table.tessellate(3)->samples)->byteCount();
}

TEST(PatchesOfLargeFaces, HaveStencilsOfLinearSize) {
  EXPECT_LT(static_cast<double>(stencilBytes(400)), 4.2 * static_cast<double>(stencilBytes(100)));
}

TEST(PatchesOfLargeFaces, AreEvaluatedInLinearTime) {
  constexpr std::size_t kManySides = 40000;
  const PatchSurface surface(prism(kManySides));
  const std::array<std::int32_t, 3> sides = surface.table.patch(7).sides();
  Far::Barycentric inLargeFace{};
  inLargeFace[static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin())] = 1;
  const Vec3 capCentre{0, 0, surface.mesh.points[static_cast<std::size_t>(surface.table.vertex(7))][2]};
  EXPECT_LT(distance(surface.at(7, inLargeFace).position, capCentre), 1e-12);
  const std::vector<Far::PatchSample> many(60000, {7, {0.3, 0.3, 0.4}});
  const auto stencils = surface.table.limitStencils(many);
  ASSERT_TRUE(stencils.has_value());
  EXPECT_LT(stencils->positions.byteCount(), 100 * (kManySides + many.size()) * sizeof(double));
  const auto limits = appliedRows(stencils->positions, 0, many.size(), surface.mesh.points);
  EXPECT_LT(distance(limits.back(), surface.at(7, many[0].barycentric).position), 1e-12);
}

TEST(PatchesOfLargeFaces, CountTheirWeightsBeforeTheyAreWritten) {
  const PatchSurface surface(prism(100));
  Far::PatchWeights wide;
  wide.points.resize(1U << 20U, 0);
  wide.weights.resize(1U << 20U, 1.0);
  wide.shares = {{0, 1, 1, 1}};
  const std::vector<Far::PlacedPatchRow> rows(2048, {0, &wide});
  const std::int32_t face = surface.table.patch(0).faces()[0];
  const auto table = Far::patchRowTable(surface.table, rows);
  ASSERT_FALSE(table.has_value());
  EXPECT_EQ(table.error().code, ErrorCode::tooLarge);
  const std::int64_t weights = 2048 * ((std::int64_t{1} << 20) + 3) + 3 * (surface.table.topology().sides(face) + 2);
  EXPECT_EQ(table.error().message, "the stencils of 2048 points of the surface hold " + std::to_string(weights) +
                                       " weights, more than 2^31 - 1; take fewer points at a time");
}

}  // namespace
}  // namespace honeycomb::Test
