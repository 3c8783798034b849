#include "bench/kit/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bench/kit/aligned_floats.h"
#include "bench/kit/level_evaluator.h"
#include "bench/kit/limits.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Bench {

namespace {

/// What the serial evaluator makes.
struct Expected {
  std::vector<float> points, normals;
};

Result<Expected> expectedOf(const Problem& problem) {
  const Result<Prepared> serial = prepareLevels<Osd::SerialEvaluator>(problem);
  if (!serial) return tl::unexpected(serial.error());
  if (auto done = serial->frame(); !done) return tl::unexpected(done.error());
  Expected expected{{serial->refined.begin(), serial->refined.end()}, {}};
  if (problem.normals != Normals::none) expected.normals.assign(serial->normals.begin(), serial->normals.end());
  return expected;
}

/// The largest distance of two numbers in the same place, as a part of the largest number expected; infinite for
/// different counts or no numbers at all.
double differenceOf(std::span<const float> expected, std::span<const float> found) {
  if (expected.size() != found.size() || found.empty()) return INFINITY;
  if (std::memcmp(expected.data(), found.data(), expected.size_bytes()) == 0) return 0;
  double largest = 0, distance = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    largest = std::max(largest, std::abs(static_cast<double>(expected[i])));
    const double apart = std::abs(static_cast<double>(expected[i]) - static_cast<double>(found[i]));
    distance = std::isfinite(apart) ? std::max(distance, apart) : INFINITY;
  }
  // Zeros of different signs are at no distance, and yet not the same bits.
  return std::max(distance / std::max(largest, 1e-30), 1e-30);
}

/// The points of a level in the level's order.
std::vector<float> inLevelOrder(std::span<const float> found, std::span<const std::int32_t> order) {
  std::vector<float> sorted(found.begin(), found.end());
  if (order.empty()) return sorted;
  const auto stride = static_cast<std::ptrdiff_t>(found.size() / order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::copy_n(found.begin() + static_cast<std::ptrdiff_t>(i) * stride, stride, sorted.begin() + order[i] * stride);
  }
  return sorted;
}

/// Evaluates a frame over memory that holds no results yet, and compares.
Result<double> check(const EvaluatorEntry& entry, const Prepared& prepared, const Problem& problem,
                     const Expected& expected) {
  std::fill(problem.refined.begin(), problem.refined.end(), NAN);
  if (auto done = prepared.frame(); !done) return tl::unexpected(done.error());
  double difference = differenceOf(prepared.expected.empty() ? expected.points : prepared.expected,
                                   inLevelOrder(prepared.refined, prepared.order));
  if (!expected.normals.empty()) {
    difference = std::max(difference, differenceOf(expected.normals, inLevelOrder(prepared.normals, prepared.order)));
  }
  const double allowed = entry.agreement == Agreement::bits ? 0 : kMostDifference;
  if (difference <= allowed) return difference;
  return fail(ErrorCode::invalidOption,
              fmt::format("{}: its points differ from the serial evaluator's by {:.3g} of the largest, {:.3g} is "
                          "allowed; leave it out of --evaluators, and report it",
                          entry.name, difference, allowed));
}

struct Contestant {
  Run run;
  Prepared prepared;
};

Result<std::vector<Contestant>> prepareAll(const Comparison& comparison, const Problem& problem,
                                           std::vector<Skip>& skips) {
  const Result<Expected> expected = expectedOf(problem);
  if (!expected) return tl::unexpected(expected.error());
  std::vector<Contestant> contestants;
  for (const EvaluatorEntry* entry : comparison.evaluators) {
    Result<Prepared> prepared = entry->prepare(problem);
    if (!prepared) {
      skips.push_back({entry->name, prepared.error().message});
      continue;
    }
    const Result<double> difference = check(*entry, *prepared, problem, *expected);
    if (!difference) return tl::unexpected(difference.error());
    prepared->expected = {};
    prepared->order = {};
    Run run;
    run.evaluator = entry->name;
    run.threads = entry->threads;
    run.vertices = prepared->vertices;
    run.tableBytes = prepared->tableBytes;
    run.buildMs = prepared->buildMs;
    run.difference = *difference;
    contestants.push_back({run, std::move(*prepared)});
  }
  return contestants;
}

std::vector<Run> runsOf(std::vector<Contestant>& contestants, std::span<const Timing> timings) {
  std::vector<Run> runs;
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    Run& run = contestants[c].run;
    const double nsPerVertex = 1e6 / static_cast<double>(run.vertices);
    run.nsPerVertex = nsPerVertex * spreadOf(timings[c].frameMs);
    run.cpuNsPerVertex = nsPerVertex * spreadOf(timings[c].cpuMs);
    run.frames = timings[c].framesTimed;
    runs.push_back(run);
  }
  return runs;
}

/// The levels of a device's frames, timed by itself. Empty where it can't.
Result<std::vector<LevelSpread>> levelSpreads(const Prepared& prepared, std::int32_t frames) {
  std::vector<LevelSpread> spreads;
  if (!prepared.levels) return spreads;
  std::vector<std::vector<double>> ms;
  for (std::int32_t frame = 0; frame < frames; ++frame) {
    const auto levels = prepared.levels();
    if (!levels && levels.error().code == ErrorCode::unsupported) return spreads;
    if (!levels) return tl::unexpected(levels.error());
    ms.resize(levels->size());
    spreads.resize(levels->size());
    for (std::size_t i = 0; i < ms.size(); ++i) {
      ms[i].push_back((*levels)[i].ms);
      spreads[i] = {(*levels)[i].level, (*levels)[i].limits, {}};
    }
  }
  for (std::size_t i = 0; i < ms.size(); ++i) spreads[i].ms = spreadOf(std::move(ms[i]));
  return spreads;
}

/// What a device's frames take of this thread, after one that brings everything up. Nothing where there is none.
Result<std::optional<HostSpread>> hostSpread(const Prepared& prepared, std::int32_t frames) {
  if (!prepared.host) return std::nullopt;
  std::vector<double> record, submit;
  for (std::int32_t frame = -1; frame < frames; ++frame) {
    const auto us = prepared.host();
    if (!us && us.error().code == ErrorCode::unsupported) return std::nullopt;
    if (!us) return tl::unexpected(us.error());
    if (frame < 0) continue;
    record.push_back(us->record);
    submit.push_back(us->submit);
  }
  return HostSpread{spreadOf(std::move(record)), spreadOf(std::move(submit))};
}

/// The time that is longest has the lowest rate.
std::vector<Limit> limitsOf(std::int64_t bytes, std::span<const Timing> timings) {
  std::vector<Limit> found;
  for (std::size_t i = 0; i < timings.size(); ++i) {
    const Spread ms = spreadOf(timings[i].frameMs);
    const double megabytes = static_cast<double>(bytes) * 1e-6;
    found.push_back({limits()[i].name,
                     limits()[i].threads,
                     bytes,
                     {megabytes / ms.max, megabytes / ms.median, megabytes / ms.min}});
  }
  return found;
}

std::vector<Prepared> prepareLimits(std::span<const float> from, std::span<float> to) {
  std::vector<Prepared> prepared;
  for (const LimitEntry& entry : limits()) prepared.push_back(entry.prepare(from, to));
  return prepared;
}

}  // namespace

Result<Comparisons> compare(const Comparison& comparison) {
  const Workbench workbench(comparison.task);
  Comparisons results;
  auto contestants = prepareAll(comparison, workbench.problem(), results.skips);
  if (!contestants) return tl::unexpected(contestants.error());
  const AlignedFloats source(workbench.output().size());
  const std::vector<Prepared> bandwidths = prepareLimits(source.all(), workbench.output());
  std::vector<const Prepared*> all;
  for (const Contestant& contestant : *contestants) all.push_back(&contestant.prepared);
  for (const Prepared& bandwidth : bandwidths) all.push_back(&bandwidth);
  const Result<std::vector<Timing>> timings = sampleInTurns(all, comparison.sampling);
  if (!timings) return tl::unexpected(timings.error());
  const std::span<const Timing> timed(*timings);
  for (Contestant& contestant : *contestants) {
    auto levels = levelSpreads(contestant.prepared, comparison.sampling.samples);
    if (!levels) return tl::unexpected(levels.error());
    contestant.run.levels = std::move(*levels);
    auto host = hostSpread(contestant.prepared, comparison.sampling.samples);
    if (!host) return tl::unexpected(host.error());
    contestant.run.host = *host;
  }
  results.runs = runsOf(*contestants, timed.first(contestants->size()));
  const auto bytes = static_cast<std::int64_t>(workbench.output().size_bytes());
  results.limits = limitsOf(bytes, timed.subspan(contestants->size()));
  return results;
}

}  // namespace honeycomb::Bench
