// Bits as numbers: those that every processor and every compiler must give. Tables and points here are made by
// additions, multiplications, divisions and square roots alone, which are rounded in one way everywhere; a library's
// cosines, of which most schemes' weights are made, are not.
#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "far/schemes/centroid.h"
#include "far/schemes/trisect.h"
#include "osd/cpu_evaluator.h"
#include "tests/osd/tile_surface.h"
#include "tests/support/random_tables.h"
#include "tests/support/refined.h"
#include "tests/support/sha256.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

template <class Real>
std::string digest(const std::vector<Real>& numbers) {
  const auto* bytes = reinterpret_cast<const char*>(numbers.data());
  return sha256(std::string_view(bytes, numbers.size() * sizeof(Real))).substr(0, 16);
}

template <class Real>
std::vector<Real> portableNumbers(std::int64_t count) {
  Random random(17);
  std::vector<Real> numbers(static_cast<std::size_t>(count));
  for (Real& x : numbers) x = static_cast<Real>(random.symmetric());
  return numbers;
}

/// Calls check(evaluator) for plain loops, vectors and threads.
template <class Check>
void forEveryEvaluator(const Check& check) {
  for (auto [name, evaluator] : {std::pair<const char*, Osd::CpuEvaluator>{"plain loops", Osd::SerialEvaluator()},
                                 {"vectors", Osd::SimdEvaluator()},
                                 {"threads", Osd::TbbEvaluator()}}) {
    SCOPED_TRACE(name);
    check(evaluator);
  }
}

template <class Real>
void expectPoints(const std::string& expected) {
  const Far::LevelTable table = randomTable({.circulants = {{3, 50}, {4, 50}, {5, 33}, {6, 100, true}, {20, 9}},
                                             .projected = {65, 700},
                                             .halfProjected = {80},
                                             .dense = {{2, 40}, {4, 70}},
                                             .looseRows = 77,
                                             .summedRows = 60});
  const std::vector<Real> source = portableNumbers<Real>(3 * std::int64_t{table.sourceCount});
  forEveryEvaluator([&](Osd::CpuEvaluator& evaluator) {
    std::vector<Real> points(3 * static_cast<std::size_t>(table.targetCount));
    ASSERT_TRUE(evaluator.evaluate(table, Osd::Points<Real>{source, {}}, Osd::PointsOut<Real>{points, {}}));
    EXPECT_EQ(digest(points), expected);
  });
}

TEST(EveryMachine, GivesTheseBitsOfATable) {
  expectPoints<float>("be343bd75361bcf9");
  expectPoints<double>("04811c6a85176652");
}

template <class Real>
void expectLimits(const std::string& positions, const std::string& normals) {
  Far::LimitTable table;
  table.faces = randomLimits(1000, {{3, 40}, {4, 101}, {5, 33}, {6, 101}, {90, 5}});
  const std::vector<Real> source = portableNumbers<Real>(3000);
  forEveryEvaluator([&](Osd::CpuEvaluator& evaluator) {
    std::vector<Real> limits(3 * static_cast<std::size_t>(table.faces.elementCount));
    std::vector<Real> units = limits;
    ASSERT_TRUE(evaluator.faceLimits(table, Osd::Points<Real>{source, {}}, Osd::PointsOut<Real>{limits, {}},
                                     Osd::PointsOut<Real>{units, {}}));
    EXPECT_EQ(digest(limits), positions);
    EXPECT_EQ(digest(units), normals);
  });
}

TEST(EveryMachine, GivesTheseLimits) {
  expectLimits<float>("225300a14ceecf6b", "3ef55623b0ef729b");
  expectLimits<double>("ce7b5f90dce50b52", "ab2f798b14b57adf");
}

/// Points and fast normals of three levels, level after level as by tiles.
template <class Real>
TileSurface<Real> surfaceOf(const Far::Scheme& scheme) {
  const Far::Refinement refinement = refined(torus(12, 9), scheme, 3);
  const std::vector<Real> control = portableNumbers<Real>(3 * std::int64_t{refinement.level(0).pointCount()});
  const TileSurface<Real> surface = levelByLevel(refinement, control);
  const auto tiles = Far::buildTileTable(refinement, {.scratchPoints = 600, .normals = Far::TileNormalKind::fast});
  EXPECT_TRUE(tiles.has_value());
  expectOfTiles(refinement, *tiles, control, surface);
  return surface;
}

TEST(EveryMachine, GivesTheseSurfaces) {
  const Far::Scheme centroid = Far::centroid();
  const auto single = surfaceOf<float>(centroid);
  EXPECT_EQ(digest(single.points), "807abe66d8e2eb4b");
  EXPECT_EQ(digest(single.normals), "2f9a0efc50668b85");  // of quads: no cosines
  const auto twice = surfaceOf<double>(centroid);
  EXPECT_EQ(digest(twice.points), "6199394d2e08ed8d");
  EXPECT_EQ(digest(twice.normals), "7ff0e53d998d9669");
  const Far::Scheme trisect = Far::trisect({.ratio = 0.25}).value();
  EXPECT_EQ(digest(surfaceOf<float>(trisect).points), "a8426bd2dc7f3154");
  EXPECT_EQ(digest(surfaceOf<double>(trisect).points), "5273b5eaee72e224");
}

}  // namespace
}  // namespace honeycomb::Test
