#pragma once

#include <span>
#include <string_view>

#include "bench/kit/evaluators.h"

namespace honeycomb::Bench {

/// What the memory can take at most, for outputs of a size. A new one is one line of the table in limits.cpp.
struct LimitEntry {
  std::string_view name;  ///< of the number of GB/s in the results
  Threads threads = Threads::all;
  /// Both spans have the same length and begin at multiples of 64 bytes.
  Prepared (*prepare)(std::span<const float> from, std::span<float> to) = nullptr;
};

/// Plain stores, stores past the caches (where the processor has them), and copies, each on one thread and on all. A
/// frame writes the whole of the output once; a copy reads as many bytes besides.
std::span<const LimitEntry> limits();

}  // namespace honeycomb::Bench
