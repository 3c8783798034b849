#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <optional>

#include "apps/cli/chain.h"
#include "apps/cli/commands.h"
#include "apps/cli/converted_primvars.h"
#include "apps/cli/formats.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/json_text.h"
#include "apps/cli/mesh_input.h"
#include "far/base/index.h"
#include "far/conversions/bricks.h"
#include "far/conversions/conversions.h"
#include "far/conversions/inverse_dual.h"

namespace honeycomb::Cli {
namespace {

struct ConvertCommand {
  std::string input;
  std::string output;
  std::string to;
  std::optional<double> ratio;
  std::optional<std::int32_t> rows;
  ReadOptions read;
};

constexpr std::int32_t kDefaultRows = 4;

/// The option that a conversion takes beside the mesh.
enum class Takes : std::uint8_t { nothing, ratio, rows };

/// What a mesh can be converted to. A new conversion is one line.
struct Target {
  std::string_view name;
  Result<Far::Conversion> (*convert)(const Far::Topology&, const ConvertCommand&);
  Takes takes = Takes::nothing;
};

/// A conversion that takes nothing beside the mesh.
template <Result<Far::Conversion> (*Convert)(const Far::Topology&)>
Result<Far::Conversion> plain(const Far::Topology& topology, const ConvertCommand&) {
  return Convert(topology);
}

Result<Far::Conversion> truncate(const Far::Topology& topology, const ConvertCommand& command) {
  return Far::truncate(topology, command.ratio.value_or(Far::kThird));
}

Result<Far::Conversion> bricks(const Far::Topology& topology, const ConvertCommand& command) {
  return Far::bricks(topology, command.rows.value_or(kDefaultRows));
}

constexpr std::array kTargets{Target{"dual", plain<Far::dual>},
                              Target{"truncate", truncate, Takes::ratio},
                              Target{"triangles", plain<Far::triangulate>},
                              Target{"quads", plain<Far::quads>},
                              Target{"hexagonal", plain<Far::hexagonal>},
                              Target{"inverse-dual", plain<Far::inverseDual>},
                              Target{"bricks", bricks, Takes::rows}};

/// An option that the target has no use for, or a value out of its range.
Result<void> checkOptions(const ConvertCommand& command, const Target& target) {
  if (command.ratio && target.takes != Takes::ratio)
    return fail(ErrorCode::invalidOption,
                fmt::format("--ratio {}: --to {} has no ratio; leave it out", *command.ratio, command.to));
  if (command.rows && target.takes != Takes::rows)
    return fail(ErrorCode::invalidOption,
                fmt::format("--rows {}: --to {} has no rows; leave it out", *command.rows, command.to));
  if (command.ratio && !(*command.ratio > 0 && *command.ratio < 0.5))
    return fail(ErrorCode::invalidOption,
                fmt::format("--ratio {}: must lie between 0 and 0.5, both excluded", *command.ratio));
  if (command.rows && (*command.rows < 1 || *command.rows > Far::kMaxBrickRows))
    return fail(ErrorCode::invalidOption,
                fmt::format("--rows {}: must lie between 1 and {}", *command.rows, Far::kMaxBrickRows));
  return {};
}

/// A conversion that isn't a manifold would be refused by every other command.
Result<void> checkManifold(const ConvertCommand& command, const Far::Conversion& converted) {
  const Result<Far::Topology> topology = Far::Topology::create(converted.polygons);
  if (topology) return {};
  return fail(ErrorCode::invalidMesh, fmt::format("{}: the {} of this mesh is not a manifold: {}", command.input,
                                                  command.to, topology.error().message));
}

/// The converted mesh and the values of its vertices and corners.
struct Converted {
  Far::Conversion mesh;
  std::vector<double> positions;
  ConvertedPrimvars primvars;
};

Result<Converted> convertMesh(const ConvertCommand& command, const Target& target, const MeshInput& input) {
  const Result<Far::Topology> topology = makeTopology(input);
  if (!topology) return tl::unexpected(topology.error());
  Result<Far::Conversion> mesh = target.convert(*topology, command);
  if (!mesh) return tl::unexpected(located(input, mesh.error()));
  if (const auto manifold = checkManifold(command, *mesh); !manifold) return tl::unexpected(manifold.error());
  Result<std::vector<double>> positions = Far::apply(*mesh, input.mesh.positions, 3);
  if (!positions) return tl::unexpected(located(input, positions.error()));
  Result<ConvertedPrimvars> primvars = convertPrimvars(input, *topology, *mesh);
  if (!primvars) return tl::unexpected(located(input, primvars.error()));
  return Converted{std::move(*mesh), std::move(*positions), std::move(*primvars)};
}

Result<void> write(const ConvertCommand& command, const Converted& converted) {
  const Result<const MeshOutput*> format = meshOutput(command.output);
  if (!format) return tl::unexpected(format.error());
  const Far::Polygons& polygons = converted.mesh.polygons;
  // checkManifold built a topology of it, so its corners can be counted in 32 bits.
  const std::vector<std::int32_t> faceOffsets(polygons.faceOffsets.begin(), polygons.faceOffsets.end());
  Io::ObjContent<double> content{converted.positions, {}, faceOffsets, polygons.indices};
  converted.primvars.values.addTo(content);
  const InterruptScope interruptible;
  return (*format)->write(command.output, content);
}

Result<void> printSummary(const ConvertCommand& command, const Session& session, const MeshInput& input,
                          const Converted& converted) {
  const Far::Polygons& polygons = converted.mesh.polygons;
  const bool leftOut = converted.primvars.texcoordsLeftOut;
  if (!session.json) {
    if (leftOut) printNote(session, fmt::format("{}: without texture coordinates: they have seams", command.output));
    printNote(session, fmt::format("{}: {} vertices, {} faces", command.output, grouped(polygons.vertexCount),
                                   grouped(polygons.faceCount())));
    return {};
  }
  const nlohmann::ordered_json json{{"input", command.input},
                                    {"output", command.output},
                                    {"to", command.to},
                                    {"dropped_vertices", input.dropped()},
                                    {"vertices", polygons.vertexCount},
                                    {"faces", polygons.faceCount()},
                                    {"texcoords_left_out", leftOut}};
  return printResult(jsonText(json));
}

Result<void> convert(const ConvertCommand& command, const Session& session) {
  const auto target = choose(kTargets, "--to", command.to);
  if (!target) return tl::unexpected(target.error());
  if (auto sensible = checkOptions(command, **target); !sensible) return sensible;
  if (const auto format = meshOutput(command.output); !format) return tl::unexpected(format.error());
  const std::array<std::filesystem::path, 1> inputs{command.input};
  if (auto writable = checkOutput(command.output, inputs); !writable) return writable;
  const Result<MeshInput> input = readMesh(command.input, command.read);
  if (!input) return tl::unexpected(input.error());
  const Result<Converted> converted = convertMesh(command, **target, *input);
  if (!converted) return tl::unexpected(converted.error());
  if (auto written = write(command, *converted); !written) return written;
  return printSummary(command, session, *input, *converted);
}

}  // namespace

void addConvert(CLI::App& app, Command& command) {
  const auto options = std::make_shared<ConvertCommand>();
  CLI::App* subcommand = app.add_subcommand("convert", "Make another mesh from a mesh");
  subcommand->add_option("IN", options->input, "Mesh: " + meshInputNames())->required();
  subcommand->add_option("OUT", options->output, "Converted mesh (.obj, .ply, .glb)")->required();
  subcommand
      ->add_option("--to", options->to,
                   "Conversion: " + names(kTargets) +
                       " [dual, inverse-dual, bricks: without texture coordinates that have seams]")
      ->required();
  subcommand->add_option("--ratio", options->ratio,
                         "truncate: where an edge is cut, in parts of it from either end, between 0 and 0.5 [1/3]");
  subcommand->add_option("--rows", options->rows, "bricks: courses a ring of quads, 1 to 1000 [4]");
  addReadOptions(*subcommand, options->read);
  addSessionOptions(*subcommand, command.session);
  subcommand->callback([options, &command] {
    command.action = [options](const Session& session) { return convert(*options, session); };
  });
}

}  // namespace honeycomb::Cli
