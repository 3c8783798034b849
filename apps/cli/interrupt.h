#pragma once

namespace honeycomb::Cli {

/// Once, before anything else: writes past a file size limit become errors instead of killing the program.
void prepareSignals();

/// While one lives an output file is being written, so SIGINT and SIGTERM don't kill the program: from then on every
/// write fails, which makes the writers remove their temporary files, and interruptSignal() tells loops to stop.
class InterruptScope {
 public:
  InterruptScope();
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;
};

/// The signal that came during an InterruptScope, or 0.
int interruptSignal();

/// Ends the program by the signal that came, as if it had not been held up.
[[noreturn]] void dieOfInterrupt();

}  // namespace honeycomb::Cli
