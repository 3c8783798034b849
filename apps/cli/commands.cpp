#include "apps/cli/commands.h"

#include <CLI/CLI.hpp>
#include <array>

namespace honeycomb::Cli {

std::span<const CommandEntry> commands() {
  static constexpr std::array kCommands{CommandEntry{addRefine}, CommandEntry{addBake},    CommandEntry{addPlay},
                                        CommandEntry{addInfo},   CommandEntry{addConvert}, CommandEntry{addTable},
                                        CommandEntry{addBench}};
  return kCommands;
}

void addRunOptions(CLI::App& subcommand, Session& session) {
  subcommand.add_option("--threads", session.threads, "Threads; 0: all the machine has")->capture_default_str();
  subcommand.add_flag("--quiet", session.quiet, "No notes, no progress bar");
}

void addSessionOptions(CLI::App& subcommand, Session& session) {
  addRunOptions(subcommand, session);
  subcommand.add_flag("--json", session.json, "Results as JSON on standard output");
}

}  // namespace honeycomb::Cli
