#include "apps/cli/read_options.h"

#include <CLI/CLI.hpp>

namespace honeycomb::Cli {

void addReadOptions(CLI::App& subcommand, ReadOptions& options) {
  subcommand.add_flag("--drop-isolated", options.dropIsolated, "Leave out vertices that are in no face");
}

}  // namespace honeycomb::Cli
