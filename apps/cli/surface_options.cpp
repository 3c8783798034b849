#include "apps/cli/surface_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>

#include "apps/cli/chain.h"
#include "apps/cli/scheme_flags.h"
#include "far/base/index.h"

namespace honeycomb::Cli {
namespace {

struct OrderName {
  std::string_view name;
  Far::FaceOrder order;
};
constexpr std::array kOrders{OrderName{"input", Far::FaceOrder::input}, OrderName{"spatial", Far::FaceOrder::spatial}};

}  // namespace

void addLevelsOption(CLI::App& subcommand, std::optional<std::int32_t>& levels) {
  subcommand
      .add_option("--levels", levels,
                  "Refinement steps, 1 to " + std::to_string(Far::kMaxLevels) + "; of a chain, their sum")
      ->default_str(std::to_string(LevelChoice{}.usual));
}

void addSurfaceOptions(CLI::App& subcommand, SurfaceOptions& options) {
  addLevelsOption(subcommand, options.levels);
  addSchemeFlags(subcommand, options.scheme);
  subcommand.add_option("--backend", options.backend, "What refines: " + names(backends()) + " (auto: tbb)")
      ->capture_default_str();
  subcommand
      .add_option("--order", options.order,
                  "The order of control faces and vertices: " + names(kOrders) +
                      " (neighbours near each other: faster where the file's order is random). The surface is the "
                      "same, its points and faces come in another order")
      ->capture_default_str();
  addReadOptions(subcommand, options.read);
}

Result<SurfacePlan> planSurface(const SurfaceOptions& options, int bytesPerNumber, const LevelChoice& levels) {
  const Result<ChainRequest> request = readChain(options.scheme, options.levels, levels);
  if (!request) return tl::unexpected(request.error());
  const auto entry = choose(backends(), "--backend", options.backend);
  if (!entry) return tl::unexpected(entry.error());
  const auto order = choose(kOrders, "--order", options.order);
  if (!order) return tl::unexpected(order.error());
  if (bytesPerNumber == 8 && !(*entry)->doublePrecision)
    return fail(ErrorCode::invalidOption,
                fmt::format("--precision double: the {} backend has single precision only; use serial or tbb",
                            options.backend));
  Result<MeshInput> input = readMesh(options.input, options.read);
  if (!input) return tl::unexpected(input.error());
  Result<ControlMesh> mesh = prepareControl(std::move(*input), options.scheme, *request, (*order)->order);
  if (!mesh) return tl::unexpected(mesh.error());
  Result<std::unique_ptr<Backend>> backend = (*entry)->open();
  if (!backend) return tl::unexpected(backend.error());
  return SurfacePlan{std::move(*mesh), std::move(*backend), request->parts.back().scheme->limits};
}

Result<SurfacePlan> planByTable(const SurfaceOptions& options) {
  const auto given = [&](const SchemeOption* option) { return options.scheme.given(*option); };
  const std::vector<const SchemeOption*> all = allOptions();
  if (options.levels || options.order != SurfaceOptions{}.order || options.scheme.scheme != SchemeOptions{}.scheme ||
      std::any_of(all.begin(), all.end(), given))
    return fail(ErrorCode::invalidOption,
                "--table: the file has scheme, levels and their options; leave --scheme, --levels, --order and the "
                "scheme's options out");
  const auto entry = choose(backends(), "--backend", options.backend);
  if (!entry) return tl::unexpected(entry.error());
  Result<MeshInput> input = readMesh(options.input, options.read);
  if (!input) return tl::unexpected(input.error());
  Result<std::unique_ptr<Backend>> backend = (*entry)->open();
  if (!backend) return tl::unexpected(backend.error());
  return SurfacePlan{{std::move(*input), {}, {}}, std::move(*backend)};
}

Result<Far::Refinement> buildTables(const SurfacePlan& plan, const RunShape& shape) {
  const std::int64_t memory = availableMemory();
  const Result<void> fits = checkSizes(predictSizes(plan.mesh.topology, plan.mesh.chain, shape), memory);
  if (!fits) return tl::unexpected(inFile(plan.mesh.input.file, fits.error()));
  Far::RefineOptions options;
  options.centralPoints = shape.centralPoints;
  options.limits = shape.normals;
  options.memoryLimit = memory;
  Result<Far::Refinement> refinement = Far::refine(plan.mesh.topology, plan.mesh.chain.steps, options);
  if (!refinement) return tl::unexpected(located(plan.mesh.input, refinement.error()));
  return refinement;
}

template <class Real>
Result<void> checkFinite(std::span<const Real> points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i]))
      return fail(ErrorCode::invalidPositions,
                  fmt::format("refined vertex {} overflows {} precision; scale the mesh down", i / 3 + 1,
                              sizeof(Real) == 4 ? "single" : "double"),
                  static_cast<std::int64_t>(i / 3));
  return {};
}
template Result<void> checkFinite<float>(std::span<const float>);
template Result<void> checkFinite<double>(std::span<const double>);

}  // namespace honeycomb::Cli
