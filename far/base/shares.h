#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>

namespace honeycomb::Parallel {

/// Where piece `piece` of `pieces` equal ones begins.
inline std::int64_t pieceBegin(std::int64_t items, std::int64_t pieces, std::int64_t piece) {
  return items * piece / pieces;
}

/// Consecutive items that one worker takes from the front and others from the back. A cache line of its own.
class alignas(64) Share {
 public:
  void fill(std::int64_t begin, std::int64_t end) { left_ = both(begin, end); }
  /// The item taken, or -1.
  std::int64_t takeFirst() {
    return take([](std::uint64_t left) { return Taken{begin(left), both(begin(left) + 1, end(left))}; });
  }
  std::int64_t takeLast() {
    return take([](std::uint64_t left) { return Taken{end(left) - 1, both(begin(left), end(left) - 1)}; });
  }
  /// Is this the caller's own from now on? To the first who asks.
  bool claim() { return !claimed_.exchange(true, std::memory_order_relaxed); }

 private:
  struct Taken {
    std::int64_t item;
    std::uint64_t left;
  };
  static std::uint64_t both(std::int64_t begin, std::int64_t end) {
    return static_cast<std::uint64_t>(begin) << 32U | static_cast<std::uint64_t>(end);
  }
  static std::int64_t begin(std::uint64_t left) { return static_cast<std::int64_t>(left >> 32U); }
  static std::int64_t end(std::uint64_t left) { return static_cast<std::int64_t>(left & 0xffffffffU); }

  template <class Choose>
  std::int64_t take(const Choose& choose) {
    std::uint64_t seen = left_.load(std::memory_order_relaxed);
    while (begin(seen) < end(seen)) {
      const Taken taken = choose(seen);
      if (left_.compare_exchange_weak(seen, taken.left, std::memory_order_relaxed)) return taken.item;
    }
    return -1;
  }

  std::atomic<std::uint64_t> left_{0};
  std::atomic<bool> claimed_{false};
};

/// The items of a loop, a share for each worker; kMost workers and 2^31 - 1 items at most.
template <int kMost>
class Shares {
 public:
  Shares(std::int64_t items, int workers) : workers_(workers) {
    for (int w = 0; w < workers; ++w) share(w).fill(pieceBegin(items, workers, w), pieceBegin(items, workers, w + 1));
  }

  /// Takes items until none is left. To be called once for each worker, at the same time or not, by the thread that
  /// would be worker `preferred`.
  void work(int preferred, const std::function<void(int, std::int64_t)>& body) {
    int worker = preferred % workers_;
    while (!share(worker).claim()) worker = (worker + 1) % workers_;
    for (std::int64_t i = share(worker).takeFirst(); i >= 0; i = share(worker).takeFirst()) body(worker, i);
    for (int other = (worker + 1) % workers_; other != worker; other = (other + 1) % workers_) {
      for (std::int64_t i = share(other).takeLast(); i >= 0; i = share(other).takeLast()) body(worker, i);
    }
  }

 private:
  Share& share(int worker) { return shares_[static_cast<std::size_t>(worker)]; }

  std::array<Share, kMost> shares_;
  int workers_;
};

}  // namespace honeycomb::Parallel
