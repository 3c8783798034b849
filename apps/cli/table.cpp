#include <CLI/CLI.hpp>

#include "apps/cli/table_commands.h"

namespace honeycomb::Cli {

void addTable(CLI::App& app, Command& command) {
  CLI::App* table =
      app.add_subcommand("table", "Table files (.hct): the tables of a mesh, ready to be mapped and used");
  table->require_subcommand(1);
  for (const auto add : {addTableBuild, addTableInfo, addTableCheck, addTableDiff}) add(*table, command);
}

}  // namespace honeycomb::Cli
