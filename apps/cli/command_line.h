#pragma once

namespace honeycomb::Cli {

/// Runs the command line and returns the exit status: 0, 1 for bad input or values out of range (one line on stderr),
/// 2 for a command line that can't be parsed. Dies of SIGINT or SIGTERM, once its temporary files are gone.
int run(int argumentCount, char** arguments);

}  // namespace honeycomb::Cli
