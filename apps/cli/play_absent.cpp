#include <CLI/CLI.hpp>

#include "apps/cli/commands.h"

namespace honeycomb::Cli {

void addPlay(CLI::App& app, Command& command) {
  CLI::App* subcommand = app.add_subcommand("play", "Watch an animated mesh refined (not in this build)");
  subcommand->allow_extras();
  subcommand->callback([&command] {
    command.action = [](const Session&) -> Result<void> {
      return fail(ErrorCode::unsupported, "play: this build has no Vulkan; build with -DHONEYCOMB_VULKAN=ON to get it");
    };
  });
}

}  // namespace honeycomb::Cli
