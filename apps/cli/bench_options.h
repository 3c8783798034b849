#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/chain.h"
#include "bench/kit/comparison.h"
#include "bench/kit/meshes.h"

namespace CLI {
class App;
}

namespace honeycomb::Cli {

/// What the user wrote.
struct BenchCommand {
  std::string input;                ///< empty: a mesh that is made
  std::optional<std::string> mesh;  ///< --mesh
  std::optional<std::int64_t> faces;
  bool shuffle = false;
  SchemeOptions scheme;
  std::optional<std::string> levels;  ///< "3,4"
  std::string evaluators = "all";
  std::string layouts = "xyz,xyzw";
  std::string normals = "none";
  Bench::SamplingOptions sampling;
  bool withoutBuilding = false;
  std::string json;  ///< a file; empty: none

  /// Adds all options to a subcommand, which writes into this object: it must stay in place.
  void addTo(CLI::App& subcommand);
};

/// What is to be measured.
struct BenchPlan {
  std::vector<ChainRequest> chains;  ///< one for each of --levels
  std::vector<const Bench::EvaluatorEntry*> evaluators;
  std::vector<Bench::Layout> layouts;
  Bench::Normals normals = Bench::Normals::none;
};

/// Everything that can be told before there is a mesh. Errors: invalidOption, naming the option and its choices;
/// unwritable, when the JSON can't be written.
Result<BenchPlan> readPlan(const BenchCommand& command);

/// The part of the options that says which mesh.
void addMeshOptions(CLI::App& subcommand, BenchCommand& command);

/// The control mesh: read, or made. Errors: those of the reader; invalidMesh; invalidOption; tooLarge.
Result<Bench::Mesh> benchMesh(const BenchCommand& command);

}  // namespace honeycomb::Cli
