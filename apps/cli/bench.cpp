#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "apps/cli/bench_report.h"
#include "apps/cli/commands.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/memory.h"
#include "apps/cli/mesh_input.h"
#include "far/base/stopwatch.h"
#include "io/output_file.h"

namespace honeycomb::Cli {
namespace {

/// Points that a comparison keeps beside the tables: those it makes, those expected, what is copied from, and those of
/// the largest evaluator of its own.
constexpr int kFrames = 4;
constexpr int kBytesPerNumber = 4;
/// While building is timed, what was built is there beside what is built.
constexpr std::int64_t kBuiltAtOnce = 2;
/// Flattened tables of the stencils, of OpenSubdiv, of Eigen and on the device take about four times the stencils.
constexpr std::int64_t kFlatTables = 4;

/// What is measured with.
struct Setup {
  const BenchCommand& command;
  const BenchPlan& plan;
  Bench::Mesh mesh;
  Far::Topology topology;
};

/// The mesh in front of errors that aren't the options'.
Error ofMesh(const Setup& setup, Error error) {
  const bool ofOptions = error.code == ErrorCode::invalidOption && error.kind == ElementKind::other;
  return ofOptions ? error : inFile(setup.mesh.name, std::move(error));
}

Result<SchemeChain> chainOf(const Setup& setup, const ChainRequest& request) {
  Result<SchemeChain> chain = makeChain(request, setup.command.scheme, setup.topology, checkChain);
  if (!chain) return tl::unexpected(ofMesh(setup, chain.error()));
  const RunShape shape{kFrames, kBytesPerNumber, setup.plan.normals != Bench::Normals::none, false};
  std::vector<LevelSize> sizes = predictSizes(setup.topology, *chain, shape);
  for (LevelSize& size : sizes) size.runBytes *= kBuiltAtOnce;
  const Result<void> fits = checkSizes(sizes, availableMemory());
  if (!fits) return tl::unexpected(ofMesh(setup, fits.error()));
  return chain;
}

/// All layouts of a level; the refinement is gone when others are built.
Result<void> compareLevel(const Setup& setup, const SchemeChain& chain, BenchReport& report) {
  Far::RefineOptions options;
  options.limits = setup.plan.normals == Bench::Normals::exact;
  const Stopwatch stopwatch;
  const Result<Far::Refinement> refinement = Far::refine(setup.topology, chain.steps, options);
  if (!refinement) return tl::unexpected(ofMesh(setup, refinement.error()));
  const double tablesMs = stopwatch.milliseconds();
  for (const Bench::Layout& layout : setup.plan.layouts) {
    const Bench::Task task{*refinement, setup.mesh.points, tablesMs, availableMemory() / kFlatTables,
                           layout,      setup.plan.normals};
    Result<Bench::Comparisons> compared = Bench::compare({task, setup.plan.evaluators, setup.command.sampling});
    if (!compared) return tl::unexpected(compared.error());
    const std::int64_t bytes = std::int64_t{layout.desc.stride} * refinement->last().table.targetCount * 4;
    report.layouts.push_back({chain.levels(), layout, bytes, std::move(*compared)});
    if (auto printed = printResult(benchTable(report.layouts.back())); !printed) return printed;
  }
  return {};
}

Result<void> buildLevel(const Setup& setup, const SchemeChain& chain, BenchReport& report) {
  // Tables take longer to build than to apply, and what is measured is longer too: a third of the samples.
  Bench::SamplingOptions sampling = setup.command.sampling;
  sampling.samples = (sampling.samples + 2) / 3;
  auto times = Bench::measureBuilding(
      {setup.mesh.polygons, setup.topology, chain.steps, availableMemory() / kFlatTables, sampling});
  if (!times) return tl::unexpected(ofMesh(setup, times.error()));
  report.builds.push_back({chain.levels(), std::move(*times)});
  return printResult(benchTable(report.builds.back()));
}

Result<void> writeJson(const BenchCommand& command, const BenchReport& report) {
  if (command.json.empty()) return {};
  const InterruptScope interruptible;
  Result<Io::OutputFile> file = Io::OutputFile::create(command.json);
  if (!file) return tl::unexpected(file.error());
  const Result<void> written = file->write(benchJson(report));
  return written ? file->commit() : written;
}

Result<void> measure(const Setup& setup) {
  std::vector<SchemeChain> chains;
  for (const ChainRequest& request : setup.plan.chains) {
    Result<SchemeChain> chain = chainOf(setup, request);
    if (!chain) return tl::unexpected(chain.error());
    chains.push_back(std::move(*chain));
  }
  BenchReport report{setup.command, setup.mesh.name, setup.topology.faceCount(), setup.topology.vertexCount(), {}, {}};
  if (auto printed = printResult(benchHeading(report)); !printed) return printed;
  for (const SchemeChain& chain : chains) {
    if (auto compared = compareLevel(setup, chain, report); !compared) return compared;
    if (setup.command.withoutBuilding) continue;
    if (auto built = buildLevel(setup, chain, report); !built) return built;
  }
  return writeJson(setup.command, report);
}

Result<void> bench(const BenchCommand& command) {
  const Result<BenchPlan> plan = readPlan(command);
  if (!plan) return tl::unexpected(plan.error());
  Result<Bench::Mesh> mesh = benchMesh(command);
  if (!mesh) return tl::unexpected(mesh.error());
  Result<Far::Topology> topology = Far::Topology::create(mesh->polygons);
  if (!topology) return tl::unexpected(inFile(mesh->name, topology.error()));
  return measure({command, *plan, std::move(*mesh), std::move(*topology)});
}

}  // namespace

void addBench(CLI::App& app, Command& command) {
  const auto options = std::make_shared<BenchCommand>();
  CLI::App* subcommand =
      app.add_subcommand("bench", "Time the evaluators, and others', in turns: nanoseconds a refined vertex");
  options->addTo(*subcommand);
  addRunOptions(*subcommand, command.session);
  subcommand->callback([options, &command] { command.action = [options](const Session&) { return bench(*options); }; });
}

}  // namespace honeycomb::Cli
