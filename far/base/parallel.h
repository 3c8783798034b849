#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "far/base/array.h"

/// The one seam through which every parallel loop of the project goes: oneTBB in the product, std::thread under the
/// thread sanitizer (Debian's oneTBB is not instrumented and floods it with false reports). What a loop computes never
/// depends on how its range is cut, so results are the same on any number of threads.
namespace honeycomb::Parallel {

/// Ranges below this many light items run on the calling thread: handing out tasks costs more than it gains.
constexpr std::int64_t kGrain = 4096;

/// Calls body(begin, end) on disjoint pieces that cover [begin, end), each at least `grain` long where possible.
/// The pieces run concurrently and in any order; returns when all have run.
void forRange(std::int64_t begin, std::int64_t end, std::int64_t grain,
              const std::function<void(std::int64_t, std::int64_t)>& body);

/// Calls body(i) for every i in [begin, end), concurrently in pieces of at least `grain`.
template <class Body>
void forEach(std::int64_t begin, std::int64_t end, const Body& body, std::int64_t grain = kGrain) {
  forRange(begin, end, grain, [&body](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i < last; ++i) body(i);
  });
}

/// The most workers that a loop over items takes.
constexpr int kMostWorkers = 256;

/// Calls body(worker, i) for every i in [0, count), count up to 2^31 - 1, concurrently and one at a time: for few items
/// that take long. Workers are numbered from 0, below `workers` (threadCount(), or fewer) and kMostWorkers, and a
/// number belongs to one thread at a time. A thread begins with its own share of the items, the same in every loop over
/// as many, since what it wrote the last time may still be in its core's caches; then it takes what others have left,
/// from the ends of their shares. Allocates nothing itself.
void forItems(std::int64_t count, int workers, const std::function<void(int, std::int64_t)>& body);

/// The lowest i in [begin, end) for which test(i) holds, `end` if there is none.
template <class Test>
std::int64_t firstWhere(std::int64_t begin, std::int64_t end, const Test& test) {
  std::atomic<std::int64_t> lowest{end};
  forEach(begin, end, [&](std::int64_t i) {
    std::int64_t seen = lowest.load(std::memory_order_relaxed);
    if (i >= seen || !test(i)) return;
    while (i < seen && !lowest.compare_exchange_weak(seen, i, std::memory_order_relaxed)) {
    }
  });
  return lowest.load();
}

/// Runs body(); while its loops wait for other threads, this one takes up no work from outside of it. For work under a
/// lock that other work takes too.
void isolated(const std::function<void()>& body);

/// The number of threads a loop may use now.
int threadCount();

/// Limits the loops of the process to `threads` threads (0: all the machine has) while it lives.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Exclusive prefix sum in place: values[i] becomes the sum of the values before it. Returns the total.
std::int64_t exclusiveScan(std::span<std::int32_t> values);

/// Stable counting sort: the items 0..keys.size()-1 ordered by keys[i] in [0, keyCount), equal keys in item order.
/// Linear in items and keys.
Array<std::int32_t> stableOrder(std::span<const std::int32_t> keys, std::int32_t keyCount);

}  // namespace honeycomb::Parallel
