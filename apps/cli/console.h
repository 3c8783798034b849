#pragma once

#include <string>
#include <string_view>

#include "far/base/result.h"

namespace honeycomb::Cli {

/// The options every subcommand has.
struct Session {
  int threads = 0;     ///< 0: all the machine has
  bool json = false;   ///< results as JSON on standard output
  bool quiet = false;  ///< no notes, no progress bar
};

/// Is somebody watching stderr? Nothing but errors goes there otherwise.
bool stderrIsTerminal();

/// Is this the process that speaks: of those that mpirun has started, the first? Others print nothing at all.
bool speaks();

/// "error: ..." on stderr, always exactly one line.
void printError(const Error& error);

/// A line for whoever watches; dropped where stderr isn't a terminal or --quiet was given.
void printNote(const Session& session, std::string_view text);

/// Results on standard output. Errors: unwritable, when standard output is closed or its disk is full.
Result<void> printResult(std::string_view text);

/// 1234567 -> "1,234,567".
std::string grouped(std::int64_t number);

/// 31234567890 -> "31.2 GB"; powers of ten.
std::string humanBytes(std::int64_t bytes);

/// "1 face", "2 faces".
std::string counted(std::int64_t number, std::string_view singular);

}  // namespace honeycomb::Cli
