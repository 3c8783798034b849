#include "apps/demo/contest.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>

#include "far/base/stopwatch.h"
#include "far/tables/tile_table.h"
#include "osd/cpu_evaluator.h"
#include "osd/tile_evaluator.h"
#include "osd/tile_size.h"

namespace honeycomb::Demo {
namespace {

using Source = Osd::Points<float>;
using Target = Osd::PointsOut<float>;

/// `evaluate`: Result<void>(Source, Target), from the control points to those of the last level.
template <class Evaluate>
Contestant cpuContestant(const char* name, double preparation, const Far::Refinement& refinement, Evaluate evaluate) {
  struct State {
    Evaluate evaluate;
    std::vector<float> points;
  };
  auto state = std::make_shared<State>(State{std::move(evaluate), {}});
  state->points.resize(3 * static_cast<std::size_t>(refinement.last().pointCount()));
  auto refine = [state, &refinement](std::span<const float> control) -> Result<std::span<const float>> {
    const auto done = state->evaluate(Source{control, {}}, Target{state->points, {}});
    if (!done) return tl::unexpected(done.error());
    return verticesOf(refinement, state->points);
  };
  return {name, preparation, refine};
}

Contestant levelContestant(const char* name, const Far::Refinement& refinement, Osd::CpuEvaluator evaluator) {
  auto evaluate = [evaluator = std::move(evaluator), &refinement](const Source& source, const Target& target) mutable {
    return evaluator.evaluate<float>(refinement, refinement.levelCount(), source, target);
  };
  return cpuContestant(name, 0, refinement, std::move(evaluate));
}

/// Floats in the order of their values as unsigned numbers, the two zeros apart.
std::uint32_t ordered(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

/// Different numbers of points are as different as can be.
std::uint32_t largestDistance(std::span<const float> a, std::span<const float> b) {
  if (a.size() != b.size()) return std::numeric_limits<std::uint32_t>::max();
  std::uint32_t largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, bitDistance(a[i], b[i]));
  return largest;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What is written down about a contestant as the frames go by.
struct Record {
  std::vector<double> times;
  std::uint32_t difference = 0;
};

Standing standingOf(const Contestant& contestant, const Record& record, std::size_t numbers, double tableTime) {
  const double time = median(record.times);
  const double vertices = static_cast<double>(numbers) / 3;
  return {contestant.name, tableTime + contestant.preparation, time, 1000 * vertices / time, record.difference};
}

}  // namespace

std::span<const float> verticesOf(const Far::Refinement& refinement, std::span<const float> points) {
  return points.first(3 * static_cast<std::size_t>(refinement.last().topology.vertexCount()));
}

std::uint32_t bitDistance(float a, float b) {
  const std::uint32_t x = ordered(a);
  const std::uint32_t y = ordered(b);
  return x > y ? x - y : y - x;
}

Contestant serialContestant(const Far::Refinement& refinement) {
  return levelContestant("serial", refinement, Osd::SerialEvaluator());
}

Contestant threadedContestant(const Far::Refinement& refinement) {
  return levelContestant("tbb", refinement, Osd::TbbEvaluator());
}

Result<Contestant> tiledContestant(const Far::Refinement& refinement) {
  struct State {
    Far::TileTable tiles;
    Osd::TileEvaluator evaluator;
  };
  const Stopwatch watch;
  Result<Far::TileTable> tiles = Far::buildTileTable(refinement, Osd::cpuTileOptions());
  if (!tiles) return tl::unexpected(tiles.error());
  const double preparation = watch.milliseconds();
  auto state = std::make_shared<State>();
  state->tiles = std::move(*tiles);
  auto evaluate = [state, &refinement](const Source& source, const Target& target) {
    return state->evaluator.evaluate<float>(refinement, state->tiles, state->tiles.lastLevel, source, target);
  };
  return cpuContestant("tbb, tiles", preparation, refinement, evaluate);
}

Result<std::vector<Standing>> runContest(std::span<const Contestant> contestants, const Animation& animation,
                                         std::int32_t frameCount, double tableTime) {
  std::vector<Record> records(contestants.size());
  std::vector<float> reference;
  for (std::int32_t f = 0; f < frameCount; ++f) {
    const auto control = animation.cache.frame(f);
    if (!control) return tl::unexpected(control.error());
    for (std::size_t c = 0; c < contestants.size(); ++c) {
      const Stopwatch watch;
      const auto points = contestants[c].refine(*control);
      records[c].times.push_back(watch.milliseconds());
      if (!points) return tl::unexpected(points.error());
      if (c == 0) reference.assign(points->begin(), points->end());
      records[c].difference = std::max(records[c].difference, largestDistance(reference, *points));
    }
  }
  std::vector<Standing> standings;
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    standings.push_back(standingOf(contestants[c], records[c], reference.size(), tableTime));
  }
  return standings;
}

std::string tableOf(std::span<const Standing> standings) {
  std::string text = fmt::format("{:<12}{:>12}{:>12}{:>20}{:>22}\n", "evaluator", "build ms", "ms/frame",
                                 "refined vertices/s", "largest difference");
  for (const Standing& s : standings) {
    const std::string difference = s.difference == 0 ? "0 bits" : fmt::format("{} ulp", s.difference);
    text += fmt::format("{:<12}{:>12.1f}{:>12.2f}{:>18.1f} M{:>22}\n", s.name, s.buildTime, s.frameTime,
                        s.vertexRate * 1e-6, difference);
  }
  return text;
}

}  // namespace honeycomb::Demo
