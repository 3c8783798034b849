#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/kit/evaluators.h"
#include "bench/kit/sampling.h"
#include "bench/kit/workbench.h"

namespace honeycomb::Bench {

/// A task for evaluators in turns.
struct Comparison {
  Task task;
  std::span<const EvaluatorEntry* const> evaluators;
  SamplingOptions sampling = {};
};

/// What a device's frames took of the calling thread, microseconds of processor time.
struct HostSpread {
  Spread recordUs, submitUs;
};

/// What a level took in a frame.
struct LevelSpread {
  std::int32_t level = 0;
  bool limits = false;  ///< the limits of that level
  Spread ms;
};

/// What was measured of one evaluator.
struct Run {
  std::string_view evaluator;
  Threads threads = Threads::all;
  Spread nsPerVertex;
  Spread cpuNsPerVertex;  ///< processor time of all threads together, which others' work disturbs less
  std::int64_t vertices = 0;
  std::int64_t frames = 0;  ///< timed
  std::int64_t tableBytes = 0;
  double buildMs = 0;
  std::vector<LevelSpread> levels{};  ///< of a device that tells
  std::optional<HostSpread> host{};   ///< of a device
  double difference = 0;  ///< from the serial evaluator's numbers at most, in the largest of these; 0: the same bits
};

/// An evaluator that wasn't measured.
struct Skip {
  std::string_view evaluator;
  std::string why;
};

/// A limit of the memory, in GB/s of the bytes written.
struct Limit {
  std::string_view name;
  Threads threads = Threads::all;
  std::int64_t bytes = 0;  ///< of the output
  Spread gbPerSecond;
};

struct Comparisons {
  std::vector<Run> runs;
  std::vector<Skip> skips;
  std::vector<Limit> limits;
};

/// By how much the numbers of an evaluator with composed weights may differ, as a part of the largest: a few dozen
/// roundings of 2^-24.
constexpr double kMostDifference = 4e-6;

/// Prepares every evaluator, compares what it makes with the serial evaluator's points, and times all of them and the
/// limits of the memory in turns. Evaluators that this build or machine hasn't, or whose tables don't fit, are skipped.
/// Errors: those of a frame; invalidOption when an evaluator's numbers are wrong: a benchmark of these would be worth
/// nothing.
Result<Comparisons> compare(const Comparison& comparison);

}  // namespace honeycomb::Bench
