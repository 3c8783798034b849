#pragma once

#include "apps/cli/commands.h"

namespace honeycomb::Cli {

/// Each adds one of `honeycomb table`'s own subcommands.
void addTableBuild(CLI::App& table, Command& command);
void addTableInfo(CLI::App& table, Command& command);
void addTableCheck(CLI::App& table, Command& command);
void addTableDiff(CLI::App& table, Command& command);

}  // namespace honeycomb::Cli
