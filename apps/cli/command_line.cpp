#include "apps/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "apps/cli/catching.h"
#include "apps/cli/commands.h"
#include "apps/cli/console.h"
#include "apps/cli/interrupt.h"
#include "far/base/parallel.h"

namespace honeycomb::Cli {
namespace {

// CLI11 has a code for each kind of mistake; scripts get one for all of them.
constexpr int kUnparsable = 2;
constexpr int kMostThreads = 4096;

Result<void> act(const Command& command) {
  if (command.session.threads < 0 || command.session.threads > kMostThreads)
    return fail(ErrorCode::invalidOption, "--threads " + std::to_string(command.session.threads) +
                                              ": give a number from 1 to " + std::to_string(kMostThreads) +
                                              ", or 0 for all the machine has");
  const Parallel::ThreadLimit limit(command.session.threads);
  return command.action(command.session);
}

Result<void> actCatching(const Command& command) {
  return catching([&command] { return act(command); });
}

int finish(const Result<void>& result) {
  if (interruptSignal() != 0) dieOfInterrupt();
  if (!result) printError(result.error());
  return result ? 0 : 1;
}

/// CLI11 reads an empty text as a number that isn't given, so a script's unset variable would pass unseen.
void refuseEmptyNumbers(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string>& texts = option->results();
    if (option->get_type_name() != "TEXT" && std::find(texts.begin(), texts.end(), "") != texts.end())
      throw CLI::ConversionError("''", option->get_name());
  }
  for (const CLI::App* subcommand : app.get_subcommands()) refuseEmptyNumbers(*subcommand);
}

int parseFailure(const CLI::App& app, const CLI::ParseError& failure) {
  if (failure.get_exit_code() == 0) return speaks() ? app.exit(failure) : 0;  // --help, --version
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const std::string help = chosen.empty() ? "honeycomb --help" : "honeycomb " + chosen[0]->get_name() + " --help";
  printError({ErrorCode::invalidOption, std::string(failure.what()) + "; see " + help});
  // Others of mpirun's processes, which find the same, leave it to the first to say so and to fail.
  return speaks() ? kUnparsable : 0;
}

}  // namespace

int run(int argumentCount, char** arguments) {
  prepareSignals();
  CLI::App app{"Honeycomb: three-valent subdivision of deforming polygon meshes", "honeycomb"};
  app.set_version_flag("--version", "honeycomb " HONEYCOMB_VERSION);
  app.require_subcommand(1);
  Command command;
  for (const CommandEntry& entry : commands()) entry.add(app, command);
  try {
    app.parse(argumentCount, arguments);
    refuseEmptyNumbers(app);
  } catch (const CLI::ParseError& failure) {
    return parseFailure(app, failure);
  }
  return finish(actCatching(command));
}

}  // namespace honeycomb::Cli
