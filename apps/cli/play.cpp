#include <CLI/CLI.hpp>

#include "apps/cli/chain.h"
#include "apps/cli/commands.h"
#include "apps/cli/formats.h"
#include "apps/cli/play/options.h"

namespace honeycomb::Cli {
namespace {

void addPictureOptions(CLI::App& subcommand, Play::PlayCommand& command) {
  subcommand.add_flag("--headless", command.headless, "No window: write pictures");
  subcommand.add_option(
      "--output", command.output,
      "Pictures, numbered (frame_%04d.png), or a video through ffmpeg (.mp4, .webm, .mov, .mkv, .gif)");
  subcommand.add_option("--sheet", command.sheet, "Some of the pictures on one, smaller (.png)");
  subcommand.add_option("--size", command.size, "Width and height of the pictures or the window (default: 1280x800)");
  subcommand.add_option("--turntable", command.turntable,
                        "Degrees the camera turns over the animation; round a mesh that doesn't move, in steps of 5");
  subcommand.add_option("--view", command.view, "What is shown: " + names(Viewer::looks()))->capture_default_str();
  CLI::Option* edges = subcommand.add_flag("--edges", command.edges, "Outline cells, whatever the view");
  subcommand.add_flag("--no-edges", command.noEdges, "Don't")->excludes(edges);
  subcommand.add_flag("--cage", command.cage, "Show the control mesh, too");
  subcommand.add_flag("--normals-shown", command.normals, "Show limit normals as lines");
  subcommand.add_option("--for", command.seconds, "Close the window after so many seconds")->check(CLI::PositiveNumber);
}

}  // namespace

void addPlay(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Play::PlayCommand>();
  CLI::App* subcommand = app.add_subcommand("play", "Watch an animated mesh refined, in a window or as pictures");
  subcommand->add_option("IN", options->request.surface.input, animatedInputHelp())->required();
  addAnimationOptions(*subcommand, options->request.animation, options->request.surface.read);
  addSurfaceOptions(*subcommand, options->request.surface);
  addPictureOptions(*subcommand, *options);
  addSessionOptions(*subcommand, command.session);
  subcommand->callback([options, &command] {
    command.action = [options](const Session& session) {
      return options->headless ? Play::playHeadless(*options, session) : Play::playInWindow(*options, session);
    };
  });
}

}  // namespace honeycomb::Cli
