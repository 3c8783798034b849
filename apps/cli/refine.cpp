#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>

#include "apps/cli/choice.h"
#include "apps/cli/commands.h"
#include "apps/cli/formats.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/json_text.h"
#include "apps/cli/progress.h"
#include "apps/cli/surface_options.h"
#include "far/base/index.h"

namespace honeycomb::Cli {
namespace {

struct RefineCommand {
  SurfaceOptions surface;
  std::string output;
  std::string precision = "single";
  std::string normals = "none";
};

struct Precision {
  std::string_view name;
  int bytes;
};
constexpr std::array kPrecisions{Precision{"single", 4}, Precision{"double", 8}};

struct NormalsChoice {
  std::string_view name;
  Normals normals;
};
constexpr std::array kNormals{NormalsChoice{"none", Normals::none}, NormalsChoice{"exact", Normals::exact}};

struct Summary {
  double buildMs = 0, refineMs = 0, writeMs = 0;
};

// Shares of the whole run, measured on the soldier at levels 4 to 6.
constexpr double kBuildShare = 0.18, kRefineShare = 0.06;

/// The control points in the precision of the run. Errors: invalidPositions, when one is too large for it.
template <class Real>
Result<std::vector<Real>> controlPoints(const MeshInput& input) {
  std::vector<Real> points(input.mesh.positions.begin(), input.mesh.positions.end());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i]))
      return fail(ErrorCode::invalidPositions,
                  fmt::format("{}:{}: coordinate {} of vertex {} doesn't fit single precision; use --precision double",
                              input.file, input.mesh.vertexLines[i / 3], input.mesh.positions[i],
                              input.fileVertex(static_cast<std::int64_t>(i / 3)) + 1));
  return points;
}

template <class Real>
Result<void> writeSurface(const std::string& output, const Far::Refinement& refinement, const Surface<Real>& surface) {
  const Result<const MeshFormat*> format = meshFormat(output);
  if (!format) return tl::unexpected(format.error());
  const Far::Topology& topology = refinement.last().topology;
  const InterruptScope interruptible;
  return (*format)->write(
      output, Io::ObjContent<Real>{surface.points, surface.normals, topology.faceOffsets(), topology.vert()});
}

template <class Real>
Result<void> evaluateAndWrite(const RefineCommand& command, const SurfacePlan& plan, const Far::Refinement& refinement,
                              Normals normals, Progress& progress, Summary& summary) {
  const auto vertices = static_cast<double>(refinement.last().topology.vertexCount());
  progress.advance(vertices * kBuildShare);
  progress.stage("refining");
  const Result<std::vector<Real>> control = controlPoints<Real>(plan.input);
  if (!control) return tl::unexpected(control.error());
  Result<std::unique_ptr<SurfaceEvaluator>> evaluator = plan.backend->evaluator(refinement, normals);
  if (!evaluator) return tl::unexpected(evaluator.error());
  Stopwatch stopwatch;
  Surface<Real> surface;
  Result<void> done = (*evaluator)->evaluate(std::span<const Real>(*control), surface);
  if (done) done = checkFinite<Real>(surface.points);
  if (!done) return tl::unexpected(inFile(plan.input.file, done.error()));
  summary.refineMs = stopwatch.lap();
  progress.advance(vertices * kRefineShare);
  progress.stage("writing");
  done = writeSurface(command.output, refinement, surface);
  summary.writeMs = stopwatch.lap();
  return done;
}

Result<void> printSummary(const RefineCommand& command, const Session& session, const SurfacePlan& plan,
                          const Far::Refinement& refinement, const Summary& summary) {
  const Far::Topology& refined = refinement.last().topology;
  if (!session.json) {
    printNote(session, fmt::format("{}: {} vertices, {} faces at level {}", command.output,
                                   grouped(refined.vertexCount()), grouped(refined.faceCount()), plan.levels));
    return {};
  }
  const nlohmann::ordered_json json{{"input", command.surface.input},
                                    {"output", command.output},
                                    {"scheme", command.surface.scheme.scheme},
                                    {"levels", plan.levels},
                                    {"backend", plan.backend->name()},
                                    {"precision", command.precision},
                                    {"dropped_vertices", plan.input.dropped()},
                                    {"vertices", refined.vertexCount()},
                                    {"edges", refined.edgeCount()},
                                    {"faces", refined.faceCount()},
                                    {"table_bytes", refinement.byteCount()},
                                    {"build_ms", summary.buildMs},
                                    {"refine_ms", summary.refineMs},
                                    {"write_ms", summary.writeMs}};
  return printResult(jsonText(json));
}

/// Builds, refines and writes under a progress bar.
Result<Far::Refinement> produce(const RefineCommand& command, const Session& session, const SurfacePlan& plan,
                                const RunShape& shape, Summary& summary) {
  Stopwatch stopwatch;
  const auto counts = Far::predict(plan.control, std::vector<Far::Scheme>(at(plan.levels), plan.scheme));
  Progress progress(session, "building", "vertices", static_cast<double>(counts.back().vertices));
  Result<Far::Refinement> refinement = buildTables(plan, shape);
  if (!refinement) return refinement;
  summary.buildMs = stopwatch.lap();
  const auto finish = shape.bytesPerNumber == 8 ? evaluateAndWrite<double> : evaluateAndWrite<float>;
  const Normals normals = shape.normals ? Normals::exact : Normals::none;
  const Result<void> done = finish(command, plan, *refinement, normals, progress, summary);
  if (!done) return tl::unexpected(done.error());
  return refinement;
}

Result<void> refine(const RefineCommand& command, const Session& session) {
  const auto precision = choose(kPrecisions, "--precision", command.precision);
  if (!precision) return tl::unexpected(precision.error());
  const auto normals = choose(kNormals, "--normals", command.normals);
  if (!normals) return tl::unexpected(normals.error());
  if (const auto format = meshFormat(command.output); !format) return tl::unexpected(format.error());
  const std::array<std::filesystem::path, 1> inputs{command.surface.input};
  if (const auto writable = checkOutput(command.output, inputs); !writable) return writable;
  const RunShape shape{1, (*precision)->bytes, (*normals)->normals == Normals::exact};
  const Result<SurfacePlan> plan = planSurface(command.surface, shape.bytesPerNumber);
  if (!plan) return tl::unexpected(plan.error());
  Summary summary;
  const Result<Far::Refinement> refinement = produce(command, session, *plan, shape, summary);
  if (!refinement) return tl::unexpected(refinement.error());
  return printSummary(command, session, *plan, *refinement, summary);
}

}  // namespace

void addRefine(CLI::App& app, Command& command) {
  const auto options = std::make_shared<RefineCommand>();
  CLI::App* subcommand = app.add_subcommand("refine", "Refine a mesh");
  subcommand->add_option("IN", options->surface.input, "Control mesh (.obj)")->required();
  subcommand->add_option("OUT", options->output, "Refined mesh (.obj)")->required();
  addSurfaceOptions(*subcommand, options->surface);
  subcommand->add_option("--precision", options->precision, "Arithmetic: " + names(kPrecisions))->capture_default_str();
  subcommand->add_option("--normals", options->normals, "Limit normals of the vertices: " + names(kNormals))
      ->capture_default_str();
  addSessionOptions(*subcommand, command.session);
  subcommand->callback([options, &command] {
    command.action = [options](const Session& session) { return refine(*options, session); };
  });
}

}  // namespace honeycomb::Cli
