#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>

#include "apps/cli/bench_options.h"
#include "apps/cli/chain.h"
#include "apps/cli/console.h"
#include "apps/cli/memory.h"
#include "apps/cli/mesh_input.h"
#include "apps/cli/program_files.h"

namespace honeycomb::Cli {
namespace {

constexpr std::int64_t kUsualFaces = 10'000;
/// Their four corners are half-edges.
constexpr std::int64_t kMostFaces = kMostHalfEdges / 4;
/// A made mesh's face takes about as many bytes, as polygons and as a topology, twice where it is shuffled.
constexpr std::int64_t kBytesPerFace = 400;

/// A mesh that is made, of any size; one line each.
struct MeshChoice {
  std::string_view name;
  Bench::Mesh (*make)(std::int64_t faces);  ///< null: the demo's, which is read
};
constexpr std::array kMeshes{MeshChoice{"torus", Bench::torus}, MeshChoice{"mixed", Bench::mixed},
                             MeshChoice{"demo", nullptr}};

Result<Bench::Mesh> readBenchMesh(const std::string& file, const BenchCommand& command) {
  if (command.faces)
    return fail(ErrorCode::invalidOption,
                fmt::format("--faces {}: {} has the faces it has; leave --faces out", *command.faces, file));
  Result<MeshInput> input = readMesh(file, {});
  if (!input) return tl::unexpected(input.error());
  tagCorners(command.scheme, input->mesh.polygons);
  if (const auto valid = makeTopology(*input); !valid) return tl::unexpected(valid.error());
  return Bench::Mesh{file, std::move(input->mesh.polygons), std::move(input->mesh.positions)};
}

Result<Bench::Mesh> makeBenchMesh(const MeshChoice& choice, std::int64_t faces) {
  if (faces < Bench::kFewestFaces || faces > kMostFaces)
    return fail(ErrorCode::invalidOption,
                fmt::format("--faces {}: give a number from {} to {}", faces, Bench::kFewestFaces, kMostFaces));
  if (faces * kBytesPerFace > availableMemory())
    return fail(ErrorCode::tooLarge, fmt::format("--faces {}: would take {}, {} is free; use fewer", faces,
                                                 humanBytes(faces * kBytesPerFace), humanBytes(availableMemory())));
  return choice.make(faces);
}

Result<Bench::Mesh> chosenMesh(const BenchCommand& command) {
  if (!command.input.empty()) {
    if (!command.mesh) return readBenchMesh(command.input, command);
    return fail(ErrorCode::invalidOption,
                fmt::format("--mesh {}: the mesh is {}; leave out one of the two", *command.mesh, command.input));
  }
  const auto choice = choose(kMeshes, "--mesh", command.mesh.value_or(std::string(kMeshes.front().name)));
  if (!choice) return tl::unexpected(choice.error());
  if ((*choice)->make == nullptr) return readBenchMesh(assetFile("creature.obj").string(), command);
  return makeBenchMesh(**choice, command.faces.value_or(kUsualFaces));
}

}  // namespace

void addMeshOptions(CLI::App& subcommand, BenchCommand& command) {
  subcommand.add_option("--mesh", command.mesh, "Mesh to make where no IN is given: " + names(kMeshes))
      ->default_str(std::string(kMeshes.front().name));
  subcommand.add_option("--faces", command.faces, "About how many faces it is to have")
      ->default_str(std::to_string(kUsualFaces));
  subcommand.add_flag("--shuffle", command.shuffle, "Number the mesh's vertices and faces at random");
}

Result<Bench::Mesh> benchMesh(const BenchCommand& command) {
  Result<Bench::Mesh> mesh = chosenMesh(command);
  if (!mesh || !command.shuffle) return mesh;
  return Bench::shuffled(*mesh);
}

}  // namespace honeycomb::Cli
