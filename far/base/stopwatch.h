#pragma once

#include <chrono>

namespace honeycomb {

/// Runs from its making. Wall-clock time.
class Stopwatch {
 public:
  double milliseconds() const { return since(Clock::now()); }

  /// The milliseconds so far; runs from zero again.
  double lap() {
    const Clock::time_point now = Clock::now();
    const double time = since(now);
    start_ = now;
    return time;
  }

 private:
  using Clock = std::chrono::steady_clock;

  double since(Clock::time_point now) const { return std::chrono::duration<double, std::milli>(now - start_).count(); }

  Clock::time_point start_ = Clock::now();
};

}  // namespace honeycomb
