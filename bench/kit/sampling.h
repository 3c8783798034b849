#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bench/kit/evaluators.h"

namespace honeycomb::Bench {

struct SamplingOptions {
  std::int32_t samples = 9;  ///< a contestant
  double sampleMs = 20;      ///< the least time a sample takes: its frames are repeated
};

/// The least, the middle and the largest of some numbers.
struct Spread {
  double min = 0, median = 0, max = 0;
};
/// Of an even count the lower of the two in the middle. `values` isn't empty.
Spread spreadOf(std::vector<double> values);
/// All three times a factor.
Spread operator*(double factor, const Spread& spread);

/// Samples of one contestant.
struct Timing {
  std::vector<double> frameMs;   ///< wall-clock time of a frame, one a sample
  std::vector<double> cpuMs;     ///< processor time of a frame, on all threads of the process together
  std::int64_t framesTimed = 0;  ///< in all samples
};

/// Takes turns: A B C A B C ..., so that what else the machine does meets all alike. Before each sample a frame is
/// evaluated untimed, which brings the contestant's tables back into the caches as they are in a playback; after
/// contestants whose threads spin there is a pause until they have stopped. Errors: the first one of a frame.
Result<std::vector<Timing>> sampleInTurns(std::span<const Prepared* const> contestants, const SamplingOptions& options);

}  // namespace honeycomb::Bench
