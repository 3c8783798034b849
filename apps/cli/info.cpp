#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/control_mesh.h"
#include "apps/cli/formats.h"
#include "apps/cli/info_machine.h"
#include "apps/cli/info_report.h"
#include "apps/cli/scheme_flags.h"

namespace honeycomb::Cli {
namespace {

constexpr std::int32_t kDefaultLevels = 5;

struct InfoCommand {
  std::string input;  ///< empty: the machine
  std::optional<std::int32_t> levels;
  SchemeOptions scheme;
  ReadOptions read;
};

Result<void> printDefects(const Session& session, const MeshInput& input, const std::vector<Far::Defect>& defects) {
  const DefectList list{input, defects};
  const auto printed = printResult(session.json ? defectsJson(list) : defectsText(list));
  return printed ? tl::unexpected(summarize(input, defects)) : printed;
}

Result<void> infoOfMesh(const InfoCommand& command, const Session& session) {
  const Result<ChainRequest> request = readChain(command.scheme, command.levels, {kDefaultLevels, 0});
  if (!request) return tl::unexpected(request.error());
  Result<MeshInput> input = readMesh(command.input, command.read);
  if (!input) return tl::unexpected(input.error());
  const std::vector<Far::Defect> defects = Far::findDefects(input->mesh.polygons);
  if (!defects.empty()) return printDefects(session, *input, defects);
  const Result<ControlMesh> mesh = prepareControl(std::move(*input), command.scheme, *request);
  if (!mesh) return tl::unexpected(mesh.error());
  RunShape shape;
  shape.centralPoints = command.scheme.given(kCentralFileOption) || command.scheme.given(kCentralOffsetOption);
  const MeshReport report{mesh->input, mesh->topology, predictSizes(mesh->topology, mesh->chain, shape),
                          availableMemory()};
  return printResult(session.json ? meshJson(report) : meshText(report));
}

Result<void> info(const InfoCommand& command, const Session& session) {
  if (!command.input.empty()) return infoOfMesh(command, session);
  return printResult(session.json ? machineJson() : machineText());
}

}  // namespace

void addInfo(CLI::App& app, Command& command) {
  const auto options = std::make_shared<InfoCommand>();
  CLI::App* subcommand = app.add_subcommand(
      "info", "A mesh's counts, defects and predicted sizes; without IN: this machine's devices and limits");
  subcommand->add_option("IN", options->input, "Mesh: " + meshInputNames());
  subcommand->add_option("--levels", options->levels, "Levels to predict; of a chain, their sum")
      ->default_str(std::to_string(kDefaultLevels));
  addSchemeFlags(*subcommand, options->scheme);
  addReadOptions(*subcommand, options->read);
  addSessionOptions(*subcommand, command.session);
  subcommand->callback(
      [options, &command] { command.action = [options](const Session& session) { return info(*options, session); }; });
}

}  // namespace honeycomb::Cli
