#pragma once

#include <functional>
#include <span>

#include "apps/cli/console.h"
#include "far/base/result.h"

namespace CLI {
class App;
}

namespace honeycomb::Cli {

/// What the command line asks for.
struct Command {
  Session session;
  std::function<Result<void>(const Session&)> action;
};

/// Each adds its subcommand to the command line; when the user names it, `command.action` becomes its work.
void addRefine(CLI::App& app, Command& command);
void addBake(CLI::App& app, Command& command);
void addInfo(CLI::App& app, Command& command);
void addConvert(CLI::App& app, Command& command);
void addBench(CLI::App& app, Command& command);
void addPlay(CLI::App& app, Command& command);
void addTable(CLI::App& app, Command& command);

/// The subcommands, in the order of the help text.
struct CommandEntry {
  void (*add)(CLI::App&, Command&);
};
std::span<const CommandEntry> commands();

/// Adds --threads and --quiet to a subcommand.
void addRunOptions(CLI::App& subcommand, Session& session);
/// The same and --json.
void addSessionOptions(CLI::App& subcommand, Session& session);

}  // namespace honeycomb::Cli
