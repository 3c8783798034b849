#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <limits>

#include "apps/cli/choice.h"
#include "apps/cli/commands.h"
#include "apps/cli/formats.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/json_text.h"
#include "apps/cli/mesh_input.h"
#include "far/base/index.h"
#include "far/topology/conversions.h"

namespace honeycomb::Cli {
namespace {

struct ConvertCommand {
  std::string input;
  std::string output;
  std::string to;
  bool dropIsolated = false;
};

/// What a mesh can be converted to. A new conversion is one line.
struct Target {
  std::string_view name;
  Result<Far::Conversion> (*convert)(const Far::Topology&);
};
constexpr std::array kTargets{Target{"dual", Far::dual}, Target{"triangles", Far::triangulate}};

/// A conversion that isn't a manifold would be refused by every other command.
Result<void> checkManifold(const ConvertCommand& command, const Far::Conversion& converted) {
  const Result<Far::Topology> topology = Far::Topology::create(converted.polygons);
  if (topology) return {};
  return fail(ErrorCode::invalidMesh, fmt::format("{}: the {} of this mesh is not a manifold: {}", command.input,
                                                  command.to, topology.error().message));
}

Result<Far::Conversion> convertMesh(const ConvertCommand& command, const Target& target, const MeshInput& input) {
  const Result<Far::Topology> topology = makeTopology(input);
  if (!topology) return tl::unexpected(topology.error());
  Result<Far::Conversion> converted = target.convert(*topology);
  if (!converted && converted.error().element >= 0) {
    const std::int64_t line = input.mesh.vertexLines[at(converted.error().element)];
    return fail(converted.error().code, fmt::format("{}:{}: {}", input.file, line, converted.error().message), line);
  }
  if (!converted) return tl::unexpected(inFile(input.file, converted.error()));
  if (const auto manifold = checkManifold(command, *converted); !manifold) return tl::unexpected(manifold.error());
  return converted;
}

Result<void> write(const ConvertCommand& command, const Far::Conversion& converted,
                   const std::vector<double>& positions) {
  const Result<const MeshFormat*> format = meshFormat(command.output);
  if (!format) return tl::unexpected(format.error());
  const Far::Polygons& polygons = converted.polygons;
  // checkManifold built a topology of it, so its corners can be counted in 32 bits.
  const std::vector<std::int32_t> faceOffsets(polygons.faceOffsets.begin(), polygons.faceOffsets.end());
  const InterruptScope interruptible;
  return (*format)->write(command.output, Io::ObjContent<double>{positions, {}, faceOffsets, polygons.indices});
}

Result<void> printSummary(const ConvertCommand& command, const Session& session, const MeshInput& input,
                          const Far::Polygons& polygons) {
  if (!session.json) {
    printNote(session, fmt::format("{}: {} vertices, {} faces", command.output, grouped(polygons.vertexCount),
                                   grouped(polygons.faceCount())));
    return {};
  }
  const nlohmann::ordered_json json{{"input", command.input},
                                    {"output", command.output},
                                    {"to", command.to},
                                    {"dropped_vertices", input.dropped()},
                                    {"vertices", polygons.vertexCount},
                                    {"faces", polygons.faceCount()}};
  return printResult(jsonText(json));
}

Result<void> convert(const ConvertCommand& command, const Session& session) {
  const auto target = choose(kTargets, "--to", command.to);
  if (!target) return tl::unexpected(target.error());
  if (const auto format = meshFormat(command.output); !format) return tl::unexpected(format.error());
  const std::array<std::filesystem::path, 1> inputs{command.input};
  if (const auto writable = checkOutput(command.output, inputs); !writable) return writable;
  const Result<MeshInput> input = readMesh(command.input, command.dropIsolated ? Isolated::drop : Isolated::keep);
  if (!input) return tl::unexpected(input.error());
  const Result<Far::Conversion> converted = convertMesh(command, **target, *input);
  if (!converted) return tl::unexpected(converted.error());
  if (const auto written = write(command, *converted, Far::means(*converted, input->mesh.positions, 3)); !written)
    return written;
  return printSummary(command, session, *input, converted->polygons);
}

}  // namespace

void addConvert(CLI::App& app, Command& command) {
  const auto options = std::make_shared<ConvertCommand>();
  CLI::App* subcommand = app.add_subcommand("convert", "Make another mesh from a mesh");
  subcommand->add_option("IN", options->input, "Mesh (.obj)")->required();
  subcommand->add_option("OUT", options->output, "Converted mesh (.obj)")->required();
  subcommand->add_option("--to", options->to, "Conversion: " + names(kTargets))->required();
  subcommand->add_flag("--drop-isolated", options->dropIsolated, "Leave out vertices that are in no face");
  addSessionOptions(*subcommand, command.session);
  subcommand->callback([options, &command] {
    command.action = [options](const Session& session) { return convert(*options, session); };
  });
}

}  // namespace honeycomb::Cli
