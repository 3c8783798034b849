#pragma once

#include <chrono>
#include <cstdint>
#include <thread>

namespace honeycomb::Osd {

/// Waits for a device that is this machine's CPU. Who sleeps until a frame is done lets a processor halt, and a halted
/// one comes back 20 to 30 microseconds late on a virtual machine, twice a frame: a tenth of a frame of 600. Who asks
/// again and again and gives way between takes no time from threads that compute on the same processor. It sleeps where
/// that would do harm: once it has kept a processor to itself, since the scheduler gives threads that wait elsewhere an
/// idle one alone; and for some waits behind a long turn of others, who give a sleeper the processor sooner than one
/// that gives way. Belongs to one thread at a time.
class CpuWait {
 public:
  static constexpr std::chrono::microseconds kShortTurn{50};  ///< nobody else had work on this processor
  static constexpr std::chrono::microseconds kMostAlone{150};
  static constexpr std::chrono::microseconds kLongTurn{1000};  ///< others than a small frame's threads had work
  static constexpr std::chrono::microseconds kMostAsking{5000};
  static constexpr std::uint32_t kSleepingWaits = 64;

  /// True once `done()` is; false where the caller is to sleep instead. `giveWay` lets other threads run.
  template <class Done, class GiveWay>
  bool ask(const Done& done, const GiveWay& giveWay) {
    if (sleeping_ > 0) {
      --sleeping_;
      return false;
    }
    std::chrono::nanoseconds alone{0}, asking{0};
    while (alone < kMostAlone && asking < kMostAsking) {
      const auto before = std::chrono::steady_clock::now();
      if (done()) return true;
      giveWay();
      const auto turn = std::chrono::steady_clock::now() - before;
      asking += turn;
      if (turn < kShortTurn) alone += turn;
      if (turn < kLongTurn) continue;
      sleeping_ = kSleepingWaits;
      break;
    }
    return false;
  }
  template <class Done>
  bool ask(const Done& done) {
    return ask(done, [] { std::this_thread::yield(); });
  }

 private:
  std::uint32_t sleeping_ = 0;  ///< waits that don't ask
};

}  // namespace honeycomb::Osd
