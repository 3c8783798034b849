#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace honeycomb::Test {

/// How a run of `honeycomb` ended.
struct Outcome {
  int exitCode = -1;  ///< -1: it died of a signal
  int signal = 0;
  std::string out;              ///< standard output
  std::string err;              ///< standard error
  std::int64_t mostMemory = 0;  ///< bytes that were in memory at once
};

/// A signal at each write to a file from a certain one on: the same moment however fast the machine is.
struct SignalAtWrite {
  int signal = 0;  ///< 0: none. SIGKILL comes when half of the bytes are written
  int write = 1;   ///< the first is 1; of all threads together, of each rank by itself
};

/// How to run it.
struct RunOptions {
  std::vector<std::pair<std::string, std::string>> environment = {};  ///< set on top of the caller's
  long fileSizeLimit = -1;                                            ///< bytes a file may get (RLIMIT_FSIZE); -1: any
  int ranks = 0;                                                      ///< started by mpirun; 0: without it
  SignalAtWrite at = {};
  std::string output = {};  ///< of start(): the file that standard output goes to; empty: none
};

/// Runs the built program to its end. Its stderr is no terminal, so it must say nothing there but errors.
Outcome run(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// Starts it and leaves it running; output is thrown away, but for RunOptions::output. wait() collects it.
pid_t start(const std::vector<std::string>& arguments, const RunOptions& options = {});
Outcome wait(pid_t child);

/// Has it ended, waiting to be collected?
bool hasEnded(pid_t child);
/// Waits until a SIGSTOP has stopped it; false where it ended instead.
bool waitUntilStopped(pid_t child);
/// Lets one that is stopped again and again go on to its end.
Outcome continueToTheEnd(pid_t child);

/// Does stderr hold exactly one line that begins with "error: "?
bool isOneErrorLine(const std::string& err);

}  // namespace honeycomb::Test
