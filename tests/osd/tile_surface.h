#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "far/tables/normal_rule.h"
#include "osd/normal_evaluator.h"
#include "osd/tile_evaluator.h"
#include "tests/support/random.h"
#include "tests/support/same_bits.h"

/// Points and normals of a refinement's last level, by tiles in all the ways they are evaluated.
namespace honeycomb::Test {

template <class Real>
struct TileSurface {
  std::vector<Real> points;
  std::vector<Real> normals;
};

template <class Real>
TileSurface<Real> emptySurface(const Far::Refinement& refinement) {
  const auto numbers = 3 * static_cast<std::size_t>(refinement.last().pointCount());
  return {std::vector<Real>(numbers, Real{7}), std::vector<Real>(numbers, Real{7})};
}

template <class Real>
std::vector<Real> randomControl(const Far::Refinement& refinement, std::uint64_t seed) {
  Random random(seed);
  std::vector<Real> control(3 * static_cast<std::size_t>(refinement.level(0).pointCount()));
  for (Real& x : control) x = static_cast<Real>(random.symmetric());
  return control;
}

/// Points level after level, then CpuEvaluator::vertexLimits; points that are no vertices have the zero vector.
template <class Real>
TileSurface<Real> withLimits(const Far::Refinement& refinement, const std::vector<Real>& control) {
  TileSurface<Real> surface = emptySurface<Real>(refinement);
  std::fill(surface.normals.begin(), surface.normals.end(), Real{0});
  Osd::SerialEvaluator serial;
  EXPECT_TRUE(serial.evaluate(refinement, refinement.levelCount(), Osd::Points<Real>{control, {}},
                              Osd::PointsOut<Real>{surface.points, {}}));
  EXPECT_TRUE(serial.vertexLimits(refinement.limits(), Osd::Points<Real>{surface.points, {}}, Osd::PointsOut<Real>{},
                                  Osd::PointsOut<Real>{surface.normals, {}}));
  return surface;
}

/// Points and fast normals level after level.
template <class Real>
TileSurface<Real> levelByLevel(const Far::Refinement& refinement, const std::vector<Real>& control) {
  const auto table = Far::buildNormalTable(refinement, refinement.levelCount());
  EXPECT_TRUE(table.has_value());
  TileSurface<Real> surface = emptySurface<Real>(refinement);
  Osd::NormalEvaluator evaluator(Osd::CpuEvaluator::Threads::one);
  EXPECT_TRUE(evaluator.evaluate(refinement, *table, Osd::Points<Real>{control, {}},
                                 Osd::PointsOut<Real>{surface.points, {}}, Osd::PointsOut<Real>{surface.normals, {}}));
  return surface;
}

template <class Real>
TileSurface<Real> byTiles(const Far::Refinement& refinement, const Far::TileTable& tiles,
                          const std::vector<Real>& control, const Osd::TileEvaluatorOptions& options) {
  TileSurface<Real> surface = emptySurface<Real>(refinement);
  Osd::TileEvaluator evaluator(options);
  const auto done = evaluator.evaluate(refinement, tiles, tiles.lastLevel, Osd::Points<Real>{control, {}},
                                       Osd::PointsOut<Real>{surface.points, {}},
                                       Osd::TileRequest<Real>{Osd::PointsOut<Real>{surface.normals, {}}, {}});
  EXPECT_TRUE(done.has_value()) << (done ? "" : done.error().message);
  return surface;
}

/// In plain loops, on vectors, and past the caches.
template <class Real>
void expectOfTiles(const Far::Refinement& refinement, const Far::TileTable& tiles, const std::vector<Real>& control,
                   const TileSurface<Real>& expected) {
  using Instructions = Osd::CpuEvaluator::Instructions;
  constexpr std::int64_t kNever = std::int64_t{1} << 60;
  const auto threads = Osd::CpuEvaluator::Threads::one;
  for (const Osd::TileEvaluatorOptions& options : {Osd::TileEvaluatorOptions{threads, Instructions::plain, kNever},
                                                   {threads, Instructions::vectors, kNever},
                                                   {threads, Instructions::vectors, 0}}) {
    const TileSurface<Real> surface = byTiles(refinement, tiles, control, options);
    ASSERT_TRUE(sameBits(surface.points, expected.points));
    ASSERT_TRUE(sameBits(surface.normals, expected.normals))
        << "vectors " << (options.instructions == Instructions::vectors) << ", streamed from " << options.streamedBytes;
  }
}

}  // namespace honeycomb::Test
