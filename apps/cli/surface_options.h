#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/control_mesh.h"
#include "apps/cli/memory.h"
#include "apps/cli/surface_evaluator.h"
#include "far/tables/refinement.h"

namespace CLI {
class App;
}

namespace honeycomb::Cli {

/// What refine and bake have in common.
struct SurfaceOptions {
  std::string input;
  std::optional<std::int32_t> levels;
  SchemeOptions scheme;
  std::string backend = "auto";
  std::string order = "input";
  ReadOptions read;
};

/// Adds --levels.
void addLevelsOption(CLI::App& subcommand, std::optional<std::int32_t>& levels);
/// Adds --levels, the scheme's options, --backend, --order and what addReadOptions adds.
void addSurfaceOptions(CLI::App& subcommand, SurfaceOptions& options);

/// An input, checked and opened: nothing that the tables need is missing, and nothing of them is built.
struct SurfacePlan {
  ControlMesh mesh;
  std::unique_ptr<Backend> backend;
  bool limits = false;  ///< are those of the chain's last scheme known?
};

/// Reads and validates everything the options name, but central control vertices. Errors: whatever is wrong with it.
Result<SurfacePlan> planSurface(const SurfaceOptions& options, int bytesPerNumber, const LevelChoice& levels = {});

/// The same for a table file, which has scheme and levels: the chain and the topology of the plan are empty. Errors:
/// also invalidOption for levels, a scheme or an order that the table has.
Result<SurfacePlan> planByTable(const SurfaceOptions& options);

/// Builds the tables, if they and the run's buffers fit. Errors: tooLarge.
Result<Far::Refinement> buildTables(const SurfacePlan& plan, const RunShape& shape);

/// Errors: invalidPositions, when a refined coordinate overflowed.
template <class Real>
Result<void> checkFinite(std::span<const Real> points);

}  // namespace honeycomb::Cli
