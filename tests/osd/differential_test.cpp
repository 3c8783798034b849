// Random meshes through all schemes and all evaluators of the CPU: the same bits. HONEYCOMB_FUZZ_ROUNDS takes more of
// them.
#include <gtest/gtest.h>

#include "far/tables/stencil_table.h"
#include "osd/cpu_evaluator.h"
#include "tests/osd/tile_surface.h"
#include "tests/support/random_mesh.h"
#include "tests/support/random_refinements.h"

namespace honeycomb::Test {
namespace {

constexpr std::uint64_t kDifferentialMeshes = meshes(8);

template <class Real>
class Differential : public testing::Test {};

using DifferentialReals = testing::Types<float, double>;
TYPED_TEST_SUITE(Differential, DifferentialReals);

template <class Real, class Evaluator, class Table>
std::vector<Real> lastPoints(Evaluator evaluator, const Far::Refinement& refinement, const Table& table,
                             const std::vector<Real>& control) {
  std::vector<Real> points = emptySurface<Real>(refinement).points;
  const Osd::Points<Real> in{control, {}};
  const Osd::PointsOut<Real> out{points, {}};
  Result<void> done;
  if constexpr (std::is_same_v<Table, Far::StencilTable>) {
    done = evaluator.evaluate(table, in, out);
  } else {
    done = evaluator.evaluate(table, table.levelCount(), in, out);
  }
  EXPECT_TRUE(done.has_value()) << (done ? "" : done.error().message);
  return points;
}

/// Plain loops, vectors and threads; `table`: the refinement, or its rows in one step.
template <class Real, class Table>
void compareChains(const Far::Refinement& refinement, const Table& table, const std::vector<Real>& control) {
  const auto serial = lastPoints(Osd::SerialEvaluator(), refinement, table, control);
  ASSERT_TRUE(sameBits(lastPoints(Osd::SimdEvaluator(), refinement, table, control), serial)) << "vectors";
  ASSERT_TRUE(sameBits(lastPoints(Osd::TbbEvaluator(), refinement, table, control), serial)) << "threads";
}

/// Flattened rows are rounded elsewhere: all evaluators give the same bits of them, near the chain's.
template <class Real>
void compareFlattened(const Far::Refinement& refinement, const std::vector<Real>& control) {
  const auto flat = Far::StencilTable::build(refinement);
  ASSERT_TRUE(flat.has_value()) << flat.error().message;
  ASSERT_NO_FATAL_FAILURE(compareChains(refinement, *flat, control));
  const auto chained = lastPoints(Osd::SerialEvaluator(), refinement, refinement, control);
  const auto points = lastPoints(Osd::SerialEvaluator(), refinement, *flat, control);
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_NEAR(points[i], chained[i], sizeof(Real) == 4 ? 1e-5 : 1e-13) << "number " << i;
}

template <class Real>
void compareTiles(const RandomRefinement& random, const std::vector<Real>& control) {
  const bool exact = random.choice.chance(0.5);
  Far::TileOptions options;
  options.scratchPoints = static_cast<std::int32_t>(random.choice.between(64, 1000));
  options.places = random.choice.chance(0.5) ? Far::TilePlaces::fours : Far::TilePlaces::faces;
  options.normals = exact ? Far::TileNormalKind::exact : Far::TileNormalKind::fast;
  const auto tiles = Far::buildTileTable(random.refinement, options);
  ASSERT_TRUE(tiles.has_value()) << tiles.error().message;
  const auto expected = exact ? withLimits(random.refinement, control) : levelByLevel(random.refinement, control);
  ASSERT_NO_FATAL_FAILURE(expectOfTiles(random.refinement, *tiles, control, expected))
      << options.scratchPoints << " points a tile, " << (exact ? "exact" : "fast") << " normals";
}

TYPED_TEST(Differential, AllEvaluatorsGiveTheSameBits) {
  forRandomRefinements(fuzzRounds(kDifferentialMeshes), [](const RandomRefinement& random) {
    SCOPED_TRACE(random.name);
    const auto control = randomControl<TypeParam>(random.refinement, 1);
    compareChains(random.refinement, random.refinement, control);
    if (!testing::Test::HasFatalFailure()) compareFlattened(random.refinement, control);
    if (!testing::Test::HasFatalFailure()) compareTiles(random, control);
    return !testing::Test::HasFatalFailure();
  });
}

}  // namespace
}  // namespace honeycomb::Test
