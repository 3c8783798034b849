#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "apps/cli/console.h"

namespace honeycomb::Cli {

/// How far a run has come.
struct ProgressState {
  std::string label;     ///< what is being done
  std::string unit;      ///< what `rate` counts: "frames", "vertices"
  double fraction = 0;   ///< of the work, 0..1
  double unitsDone = 0;  ///< 0: no rate is shown
  double seconds = 0;    ///< since the start
};

/// "refining  [#########-----------]  45%  12.3 frames/s  0:07 left".
std::string progressLine(const ProgressState& state);

/// A bar on stderr, redrawn until destroyed, for runs of over a second; invisible where stderr isn't a terminal or
/// --quiet was given. advance() and stage() may be called from any thread.
class Progress {
 public:
  Progress(const Session& session, std::string label, std::string unit, double totalUnits);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `units` more are done.
  void advance(double units);
  /// Names what is being done from now on.
  void stage(std::string label);

 private:
  void drawUntilStopped();

  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  const double totalUnits_;
  std::mutex mutex_;
  std::condition_variable wake_;
  ProgressState state_;
  bool stopped_ = false;
  std::thread drawer_;
};

}  // namespace honeycomb::Cli
