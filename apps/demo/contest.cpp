#include "apps/demo/contest.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>

#include "apps/demo/stopwatch.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Demo {
namespace {

Contestant cpuContestant(const char* name, const Far::Refinement& refinement, const Osd::CpuEvaluator& evaluator) {
  struct State {
    Osd::CpuEvaluator evaluator;
    std::vector<float> points;
  };
  auto state = std::make_shared<State>(State{evaluator, {}});
  state->points.resize(3 * static_cast<std::size_t>(refinement.last().pointCount()));
  auto refine = [state, &refinement](std::span<const float> control) -> Result<std::span<const float>> {
    const Osd::Points<float> source{control, {}};
    const Osd::PointsOut<float> target{state->points, {}};
    const auto done = state->evaluator.evaluate<float>(refinement, refinement.levelCount(), source, target);
    if (!done) return tl::unexpected(done.error());
    return verticesOf(refinement, state->points);
  };
  return {name, 0, refine};
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
  return cpuContestant("serial", refinement, Osd::SerialEvaluator());
}

Contestant threadedContestant(const Far::Refinement& refinement) {
  return cpuContestant("tbb", refinement, Osd::TbbEvaluator());
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
  std::string text = fmt::format("{:<10}{:>12}{:>12}{:>20}{:>22}\n", "evaluator", "build ms", "ms/frame",
                                 "refined vertices/s", "largest difference");
  for (const Standing& s : standings) {
    const std::string difference = s.difference == 0 ? "0 bits" : fmt::format("{} ulp", s.difference);
    text += fmt::format("{:<10}{:>12.1f}{:>12.2f}{:>18.1f} M{:>22}\n", s.name, s.buildTime, s.frameTime,
                        s.vertexRate * 1e-6, difference);
  }
  return text;
}

}  // namespace honeycomb::Demo
