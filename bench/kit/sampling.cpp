#include "bench/kit/sampling.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <thread>

#include "far/base/stopwatch.h"

namespace honeycomb::Bench {

namespace {

/// libgomp's threads wait 300,000 pauses for the next loop before they sleep; a pause takes up to 140 cycles.
constexpr std::chrono::milliseconds kSpinTime{30};
constexpr double kMostFrames = 1e6;

Result<void> sample(const Prepared& contestant, double sampleMs, Timing& timing) {
  const Stopwatch warming;
  if (auto done = contestant.frame(); !done) return done;
  const double warm = std::max(warming.milliseconds(), 1e-6);
  const auto frames = static_cast<std::int64_t>(std::clamp(std::ceil(sampleMs / warm), 1.0, kMostFrames));
  std::int64_t done = 0;
  const std::clock_t cpu = std::clock();
  const Stopwatch stopwatch;
  // The first frame may be much slower than those that follow: more are added until the time is full.
  while (done == 0 || stopwatch.milliseconds() < sampleMs) {
    for (std::int64_t i = 0; i < frames; ++i) {
      if (auto evaluated = contestant.frame(); !evaluated) return evaluated;
    }
    done += frames;
  }
  timing.frameMs.push_back(stopwatch.milliseconds() / static_cast<double>(done));
  timing.cpuMs.push_back(1e3 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / static_cast<double>(done));
  timing.framesTimed += done;
  if (contestant.spins) std::this_thread::sleep_for(kSpinTime);
  return {};
}

}  // namespace

Spread spreadOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values.front(), values[(values.size() - 1) / 2], values.back()};
}

Spread operator*(double factor, const Spread& spread) {
  return {factor * spread.min, factor * spread.median, factor * spread.max};
}

Result<std::vector<Timing>> sampleInTurns(std::span<const Prepared* const> contestants,
                                          const SamplingOptions& options) {
  std::vector<Timing> timings(contestants.size());
  for (std::int32_t i = 0; i < options.samples; ++i) {
    for (std::size_t c = 0; c < contestants.size(); ++c) {
      if (auto done = sample(*contestants[c], options.sampleMs, timings[c]); !done) {
        return tl::unexpected(done.error());
      }
    }
  }
  return timings;
}

}  // namespace honeycomb::Bench
