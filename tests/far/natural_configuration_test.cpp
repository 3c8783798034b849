#include "far/tables/natural_configuration.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "far/schemes/half_box.h"
#include "far/tables/patch_table.h"
#include "far/tables/refinement.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Test {
namespace {

/// A natural configuration and what a step of subdivision makes of it.
struct Stepped {
  Far::NaturalConfiguration start;
  Far::Refinement refinement;
  std::vector<double> points;  ///< of level 1

  const Far::Topology& topology(std::int32_t level) const { return refinement.level(level).topology; }
};

Stepped stepped(std::int32_t sides, double weight) {
  Far::NaturalConfiguration start = Far::naturalConfiguration(sides, weight).value();
  const Far::Topology control = Far::Topology::create(start.polygons).value();
  Far::HalfBoxOptions options;
  options.tunedWeights = {{sides, weight}};
  const Far::Scheme scheme = Far::halfBoxStep(options, true).value();
  Far::Refinement refinement = Far::refine(control, scheme, 1).value();
  std::vector<double> points(3 * static_cast<std::size_t>(refinement.last().pointCount()));
  Osd::SerialEvaluator evaluator;
  const auto done = evaluator.evaluate<double>(refinement, 1, {start.points, {}}, {points, {}});
  EXPECT_TRUE(done.has_value());
  return {std::move(start), std::move(refinement), std::move(points)};
}

/// The level's number of the caller's face 0, or of what became of it.
std::int32_t middleFace(const Stepped& mesh, std::int32_t level) {
  const Far::Topology& control = mesh.topology(0);
  for (std::int32_t f = 0; f < control.faceCount(); ++f) {
    if (control.inputFace(f) != 0) continue;
    if (level == 0) return f;
    const Far::Topology& refined = mesh.topology(1);
    for (std::int32_t g = 0; g < refined.faceCount(); ++g) {
      if (refined.parentKind(g) == Far::FaceParent::face && refined.parents()[static_cast<std::size_t>(g)] == f)
        return g;
    }
  }
  return -1;
}

/// The 4n vertices round a face, in the order of a natural configuration.
std::vector<std::int32_t> neighbourhood(const Far::Topology& topology, std::int32_t face) {
  const std::int32_t n = topology.sides(face);
  std::vector<std::int32_t> found(4 * static_cast<std::size_t>(n));
  const auto place = [&](std::int32_t i, std::int32_t k) -> std::int32_t& {
    return found[static_cast<std::size_t>(i * n + k % n)];
  };
  for (std::int32_t k = 0; k < n; ++k) {
    const std::int32_t h = topology.faceOffsets()[static_cast<std::size_t>(face)] + k;
    const std::int32_t out = topology.next(topology.twin(h));
    place(0, k) = topology.vert(h);
    place(1, k) = topology.dest(out);
    place(3, k) = topology.dest(topology.next(out));
    place(2, k + 1) = topology.dest(topology.next(topology.next(out)));
  }
  return found;
}

struct Case {
  std::int32_t sides;
  double weight;
};

class NaturalConfigurations : public testing::TestWithParam<Case> {};

TEST_P(NaturalConfigurations, AreHalvedByAStepOfTheTables) {
  const Stepped mesh = stepped(GetParam().sides, GetParam().weight);
  const auto before = neighbourhood(mesh.topology(0), middleFace(mesh, 0));
  const auto after = neighbourhood(mesh.topology(1), middleFace(mesh, 1));
  ASSERT_EQ(before.size(), after.size());
  double largest = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double old = mesh.start.points[3 * static_cast<std::size_t>(before[i]) + axis];
      const double now = mesh.points[3 * static_cast<std::size_t>(after[i]) + axis];
      EXPECT_NEAR(now, Far::kHalfBoxContraction * old, 1e-14) << "vertex " << before[i] << ", axis " << axis;
      largest = std::max(largest, std::abs(old));
    }
  }
  EXPECT_GE(largest, 1);
}

/// The patches of the characteristic ring: those of level 1 but the ones at the middle face's corners.
std::vector<std::int32_t> ringPatches(const Stepped& mesh, const Far::PatchTable& table) {
  std::vector<std::int32_t> ring;
  const std::int32_t middle = middleFace(mesh, 1);
  for (std::int32_t p = 0; p < table.patchCount(); ++p) {
    const auto faces = table.patch(p).faces();
    if (std::find(faces.begin(), faces.end(), middle) == faces.end()) ring.push_back(p);
  }
  return ring;
}

/// How often the outer border of the patches goes round the origin.
double winding(const Stepped& mesh, const Far::PatchTable& table, std::span<const std::int32_t> ring) {
  constexpr int kPieces = 16;
  double turned = 0;
  for (const std::int32_t p : ring) {
    const auto neighbours = table.neighbours(p);
    for (std::size_t i = 0; i < 3; ++i) {
      if (neighbours[i] >= 0) continue;
      double last = 0;
      for (int s = 0; s <= kPieces; ++s) {
        Far::Barycentric u{};
        u[(i + 1) % 3] = static_cast<double>(s) / kPieces;
        u[i] = 1 - u[(i + 1) % 3];
        const auto position = table.evaluate<double>(p, u, mesh.points)->position;
        const double angle = std::atan2(position[1], position[0]);
        if (s > 0) turned += std::remainder(angle - last, 2 * std::numbers::pi);
        last = angle;
      }
    }
  }
  return turned / (2 * std::numbers::pi);
}

TEST_P(NaturalConfigurations, HaveCharacteristicMapsThatAreRegularAndGoRoundOnce) {
  const Stepped mesh = stepped(GetParam().sides, GetParam().weight);
  const Far::PatchTable table = Far::PatchTable::build(mesh.topology(1)).value();
  const std::vector<std::int32_t> ring = ringPatches(mesh, table);
  ASSERT_EQ(ring.size(), 3 * static_cast<std::size_t>(GetParam().sides));
  constexpr int kPieces = 6;
  for (const std::int32_t p : ring) {
    for (int i = 0; i <= kPieces; ++i) {
      for (int j = 0; i + j <= kPieces; ++j) {
        const double u = static_cast<double>(i) / kPieces;
        const double v = static_cast<double>(j) / kPieces;
        const auto point = table.evaluate<double>(p, {u, v, 1 - u - v}, mesh.points).value();
        EXPECT_GT(point.du[0] * point.dv[1] - point.du[1] * point.dv[0], 1e-4)
            << "patch " << p << " at " << u << ' ' << v;
      }
    }
  }
  EXPECT_NEAR(winding(mesh, table, ring), 1, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(HalfBox, NaturalConfigurations,
                         testing::Values(Case{3, 0.25}, Case{4, 0.25}, Case{5, 0.25}, Case{6, 0.25}, Case{7, 0.25},
                                         Case{8, 0.25}, Case{12, 0.25}, Case{3, 0.45}, Case{4, 0.35}),
                         [](const auto& tested) {
                           return std::to_string(tested.param.sides) + (tested.param.weight == 0.25 ? "" : "tuned");
                         });

TEST(NaturalConfiguration, HasCoincidingVerticesForTrianglesAndQuadsUnlessTuned) {
  const auto distance = [](const Far::NaturalConfiguration& c, std::size_t a, std::size_t b) {
    return std::hypot(c.points[3 * a] - c.points[3 * b], c.points[3 * a + 1] - c.points[3 * b + 1]);
  };
  const auto triangle = Far::naturalConfiguration(3).value();
  EXPECT_NEAR(distance(triangle, 3, 4), 0, 1e-15);
  EXPECT_NEAR(distance(triangle, 4, 5), 0, 1e-15);
  const auto quad = Far::naturalConfiguration(4).value();
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(distance(quad, k, 4 + k), 0, 1e-15);
  EXPECT_GT(distance(Far::naturalConfiguration(3, 0.45).value(), 3, 4), 0.1);
  EXPECT_GT(distance(Far::naturalConfiguration(4, 0.35).value(), 0, 4), 0.1);
}

TEST(NaturalConfiguration, RefusesWhatIsOutOfRange) {
  EXPECT_EQ(Far::naturalConfiguration(2).error().code, ErrorCode::invalidOption);
  EXPECT_EQ(Far::naturalConfiguration(Far::kMostConfigurationSides + 1).error().code, ErrorCode::invalidOption);
  EXPECT_EQ(Far::naturalConfiguration(5, 0.6).error().code, ErrorCode::invalidOption);
  EXPECT_EQ(Far::naturalConfiguration(5, std::nan("")).error().code, ErrorCode::invalidOption);
}

}  // namespace
}  // namespace honeycomb::Test
