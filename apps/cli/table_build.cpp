#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "apps/cli/bake_tables.h"
#include "apps/cli/formats.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/json_text.h"
#include "apps/cli/scheme_flags.h"
#include "apps/cli/table_commands.h"
#include "far/base/stopwatch.h"
#include "io/table_file.h"
#include "osd/tile_size.h"

namespace honeycomb::Cli {
namespace {

struct TableBuildCommand {
  std::string input, output;
  std::optional<std::int32_t> levels;
  SchemeOptions scheme;
  ReadOptions read;
  bool tiles = false;
  bool limits = false;
  bool indexBuffers = true;
};

Result<void> checkTableCommand(const TableBuildCommand& command) {
  if (std::filesystem::path(command.output).extension() != ".hct")
    return fail(ErrorCode::invalidOption, fmt::format("{}: name a table file .hct", command.output));
  if (command.scheme.given(kCentralFileOption) || command.scheme.given(kCentralOffsetOption))
    return fail(ErrorCode::invalidOption,
                "--ccv: a table file is for any positions, central control vertices in barycentres; leave it out");
  return checkOutput(command.output, std::vector<std::filesystem::path>{command.input});
}

/// What the control points of the mesh have.
std::vector<Io::TablePrimvar> primvarsOf(const Io::Mesh& mesh) {
  std::vector<Io::TablePrimvar> primvars{{"positions", 3}};
  if (!mesh.colours.empty()) primvars.push_back({"colours", 3});
  if (!mesh.texcoords.empty()) primvars.push_back({"texcoords", 2});
  return primvars;
}

struct BuiltTable {
  Far::Refinement refinement;
  std::optional<Far::TileTable> tiles;
  Io::TableInfo info;
  double buildMs = 0;
};

Result<BuiltTable> buildTable(const TableBuildCommand& command, const Session& session) {
  const Result<ChainRequest> request = readChain(command.scheme, command.levels);
  if (!request) return tl::unexpected(request.error());
  Result<MeshInput> input = readMesh(command.input, command.read);
  if (!input) return tl::unexpected(input.error());
  printNotes(session, *input);
  Io::TableInfo info;
  info.meshHash = Io::meshHash(input->mesh.polygons);
  info.inputVertices = input->mesh.polygons.vertexCount;
  info.inputFaces = static_cast<std::int32_t>(input->mesh.polygons.faceCount());
  info.primvars = primvarsOf(input->mesh);
  Result<ControlMesh> mesh = prepareControl(std::move(*input), command.scheme, *request);
  if (!mesh) return tl::unexpected(mesh.error());
  info.steps = describeSteps(mesh->chain, *request, command.scheme);

  Stopwatch stopwatch;
  const SurfacePlan plan{std::move(*mesh), nullptr};
  Result<Far::Refinement> refinement = buildTables(plan, {1, sizeof(float), command.limits, false});
  if (!refinement) return tl::unexpected(refinement.error());
  BuiltTable built{std::move(*refinement), {}, std::move(info)};
  if (command.tiles) {
    Result<Far::TileTable> tiles = Far::buildTileTable(
        built.refinement, Osd::cpuTileOptions(command.limits ? Far::TileNormalKind::exact : Far::TileNormalKind::none));
    if (!tiles) return tl::unexpected(inFile(command.input, tiles.error()));
    built.tiles = std::move(*tiles);
  }
  built.buildMs = stopwatch.lap();
  return built;
}

Result<void> tableBuild(const TableBuildCommand& command, const Session& session) {
  if (auto sound = checkTableCommand(command); !sound) return sound;
  const Result<BuiltTable> built = buildTable(command, session);
  if (!built) return tl::unexpected(built.error());
  Stopwatch stopwatch;
  const InterruptScope interruptible;
  const Io::TableContent content{built->refinement, built->tiles ? &*built->tiles : nullptr, built->info,
                                 command.indexBuffers, command.indexBuffers};
  if (auto written = Io::writeTableFile(command.output, content); !written) return written;
  const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(command.output));
  const std::int32_t vertices = built->refinement.last().topology.vertexCount();
  if (!session.json) {
    printNote(session, fmt::format("{}: {} levels to {} vertices, {}", command.output, built->info.steps.size(),
                                   grouped(vertices), humanBytes(bytes)));
    return {};
  }
  return printResult(jsonText({{"input", command.input},
                               {"output", command.output},
                               {"steps", built->info.steps},
                               {"vertices", vertices},
                               {"faces", built->refinement.last().topology.faceCount()},
                               {"bytes", bytes},
                               {"build_ms", built->buildMs},
                               {"write_ms", stopwatch.lap()}}));
}

}  // namespace

void addTableBuild(CLI::App& table, Command& command) {
  const auto options = std::make_shared<TableBuildCommand>();
  CLI::App* subcommand = table.add_subcommand("build", "Build the tables of a mesh and write them");
  subcommand->add_option("IN", options->input, "Control mesh: " + meshInputNames())->required();
  subcommand->add_option("OUT", options->output, "Table file (.hct)")->required();
  addLevelsOption(*subcommand, options->levels);
  addSchemeFlags(*subcommand, options->scheme);
  subcommand->add_flag("--tiles", options->tiles, "Also the tiles that are evaluated fastest");
  subcommand->add_flag("--limits", options->limits, "Also limit positions and exact normals of the last level");
  subcommand->add_flag("!--no-index-buffers", options->indexBuffers,
                       "Leave out triangles and lines, which follow from the faces");
  addReadOptions(*subcommand, options->read);
  addSessionOptions(*subcommand, command.session);
  subcommand->callback([options, &command] {
    command.action = [options](const Session& session) { return tableBuild(*options, session); };
  });
}

}  // namespace honeycomb::Cli
