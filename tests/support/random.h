#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>

namespace honeycomb::Test {

/// Numbers that are the same on every machine for the same seed (the standard's distributions aren't).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// 0 .. n-1.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  /// low .. high.
  std::size_t between(std::size_t low, std::size_t high) { return low + below(high - low + 1); }
  /// [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// [-1, 1).
  double symmetric() { return 2 * unit() - 1; }
  bool chance(double p) { return unit() < p; }

  template <class Items>
  void shuffle(Items& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace honeycomb::Test
