#pragma once

#include "apps/cli/chain.h"

namespace CLI {
class App;
}

namespace honeycomb::Cli {

/// Adds --scheme and the options of all schemes to a subcommand, which writes into `options`: it must stay in place.
void addSchemeFlags(CLI::App& subcommand, SchemeOptions& options);

}  // namespace honeycomb::Cli
