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

/// How to run it.
struct RunOptions {
  std::vector<std::pair<std::string, std::string>> environment;  ///< set on top of the caller's
  long fileSizeLimit = -1;                                       ///< bytes a file may get (RLIMIT_FSIZE); -1: any
  int ranks = 0;                                                 ///< started by mpirun; 0: without it
};

/// Runs the built program to its end. Its stderr is no terminal, so it must say nothing there but errors.
Outcome run(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// Starts it and leaves it running; output is thrown away. wait() collects it.
pid_t start(const std::vector<std::string>& arguments, const RunOptions& options = {});
Outcome wait(pid_t child);

/// Does stderr hold exactly one line that begins with "error: "?
bool isOneErrorLine(const std::string& err);

}  // namespace honeycomb::Test
