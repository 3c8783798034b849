#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "far/schemes/akleman.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

/// Refused as an option out of range, in one line with the offending number in it.
void expectRefused(const Far::AklemanOptions& options, double value) {
  const auto scheme = Far::akleman(options);
  ASSERT_FALSE(scheme.has_value()) << value;
  EXPECT_EQ(scheme.error().code, ErrorCode::invalidOption);
  EXPECT_FALSE(scheme.error().message.empty());
  EXPECT_EQ(scheme.error().message.find('\n'), std::string::npos);
}

Far::Tension constant(double value) {
  return {.rule = Far::Tension::Rule::constant, .value = value};
}

TEST(AklemanOptions, TensionIsBetweenZeroAndOne) {
  for (const double value : {0.0, 1.0, -0.5, 1.5, kNaN, kInfinity, -kInfinity}) {
    Far::AklemanOptions options;
    options.tension = constant(value);
    ASSERT_NO_FATAL_FAILURE(expectRefused(options, value));
    options.tension = {.rule = Far::Tension::Rule::paper, .bySides = {{5, value}}};
    ASSERT_NO_FATAL_FAILURE(expectRefused(options, value));
  }
  for (const double value : {1e-9, 0.5, 1 - 1e-9}) {
    Far::AklemanOptions options;
    options.tension = constant(value);
    EXPECT_TRUE(Far::akleman(options).has_value()) << value;
  }
}

TEST(AklemanOptions, EdgeParameterIsFromZeroToOne) {
  for (const double value : {-1e-9, 1 + 1e-9, -1.0, 2.0, kNaN, kInfinity}) {
    Far::AklemanOptions options;
    options.edgeParameter = value;
    ASSERT_NO_FATAL_FAILURE(expectRefused(options, value));
  }
  for (const double value : {0.0, 0.3, 1.0}) {
    Far::AklemanOptions options;
    options.edgeParameter = value;
    EXPECT_TRUE(Far::akleman(options).has_value()) << value;
  }
}

TEST(AklemanOptions, BoundaryWeightIsFromZeroToOne) {
  for (const double value : {-1e-9, 1 + 1e-9, kNaN, kInfinity}) {
    Far::AklemanOptions options;
    options.boundary = Far::BoundaryRule::eq16;
    options.boundaryWeight = value;
    ASSERT_NO_FATAL_FAILURE(expectRefused(options, value));
  }
}

TEST(AklemanOptions, NamedTensionsAreTheirFormulas) {
  for (const std::int32_t sides : {3, 4, 5, 6, 7, 64, 1000}) {
    const auto n = static_cast<std::size_t>(sides);
    EXPECT_NEAR((Far::Tension{.rule = Far::Tension::Rule::paper}).at(sides), paperTension(n), 1e-15);
    EXPECT_NEAR((Far::Tension{.rule = Far::Tension::Rule::sqrt3}).at(sides), sqrt3Tension(n), 1e-15);
    EXPECT_NEAR((Far::Tension{.rule = Far::Tension::Rule::topmod}).at(sides), std::sqrt(0.5) - 0.25 + 1.25 / sides,
                1e-15);
    EXPECT_EQ(constant(0.25).at(sides), 0.25);
  }
  EXPECT_NEAR((Far::Tension{.rule = Far::Tension::Rule::sqrt3}).at(6), 23.0 / 36, 1e-15);
  EXPECT_EQ((Far::Tension{.rule = Far::Tension::Rule::sqrt3}).at(3), 1);
}

TEST(AklemanOptions, ASideCountCanHaveItsOwnTension) {
  Far::AklemanOptions options;
  options.tension.bySides = {{4, 0.7}};
  const auto scheme = Far::akleman(options);
  ASSERT_TRUE(scheme.has_value());
  for (const std::size_t sides : {3U, 4U, 5U}) {
    const auto row =
        Far::firstRow(scheme->faceRule(static_cast<std::int32_t>(sides)), static_cast<std::int32_t>(sides));
    const auto expected = closedFormula(sides == 4 ? 0.7 : paperTension(sides), 0.5, sides);
    for (std::size_t k = 0; k < sides; ++k) EXPECT_NEAR(row[k], expected[k], 1e-15) << sides;
  }
}

TEST(RefineOptions, LevelsPast31BitsAreRefusedBeforeAnythingIsBuilt) {
  const Far::Scheme scheme = schemeCase(NamedTension::paper).scheme;
  const Far::Topology mesh = toTopology(cube());
  const std::vector<Far::Scheme> chain(17, scheme);
  for (const auto& refinement : {Far::refine(mesh, scheme, 17), Far::refine(mesh, chain)}) {
    ASSERT_FALSE(refinement.has_value()) << "24 * 3^17 half-edges are more than 2^31";
    EXPECT_EQ(refinement.error().code, ErrorCode::tooLarge);
    EXPECT_THAT(refinement.error().message, testing::HasSubstr("17"));
  }
}

TEST(RefineOptions, LevelsAreFromZeroToTheLargest) {
  const Far::Scheme scheme = schemeCase(NamedTension::paper).scheme;
  const Far::Topology mesh = toTopology(cube());
  EXPECT_FALSE(Far::refine(mesh, scheme, -1).has_value());
  EXPECT_FALSE(Far::refine(mesh, scheme, Far::kMaxLevels + 1).has_value());
  const auto none = Far::refine(mesh, scheme, 0);
  ASSERT_TRUE(none.has_value());
  EXPECT_EQ(none->levelCount(), 0);
  EXPECT_EQ(none->last().topology.faceCount(), 6);
}

TEST(RefineOptions, MemoryLimitIsKept) {
  const Far::Scheme scheme = schemeCase(NamedTension::paper).scheme;
  const Far::Topology mesh = toTopology(torus(20, 20));
  const std::vector<Far::Scheme> chain(3, scheme);
  std::int64_t predicted = 0;
  for (const Far::LevelCounts& level : Far::predict(mesh, chain)) predicted += level.bytes;
  const auto refused = Far::refine(mesh, scheme, 3, {.limits = false, .memoryLimit = 100000});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::tooLarge);
  EXPECT_EQ(refused.error().message.find('\n'), std::string::npos);
  const auto built = Far::refine(mesh, scheme, 3, {.limits = false, .memoryLimit = 2 * predicted});
  ASSERT_TRUE(built.has_value()) << built.error().message;
  EXPECT_LE(built->byteCount(), 2 * predicted);
}

}  // namespace
}  // namespace honeycomb::Test
