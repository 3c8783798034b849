#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>

#include "apps/cli/central_points.h"
#include "apps/cli/chain.h"
#include "apps/cli/commands.h"
#include "apps/cli/formats.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/json_text.h"
#include "apps/cli/primvars.h"
#include "apps/cli/progress.h"
#include "apps/cli/surface_options.h"
#include "apps/cli/tessellation.h"
#include "far/base/index.h"
#include "far/base/stopwatch.h"
#include "far/tables/patch_table.h"

namespace honeycomb::Cli {
namespace {

struct RefineCommand {
  SurfaceOptions surface;
  std::string output;
  std::string precision = "single";
  std::string normals = "none";
  std::optional<std::int32_t> pieces;  ///< --tessellate
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
constexpr std::array kNormals{NormalsChoice{"none", Normals::none}, NormalsChoice{"exact", Normals::exact},
                              NormalsChoice{"fast", Normals::fast}};

struct Summary {
  double buildMs = 0, refineMs = 0, writeMs = 0;
};

// Shares of the whole run, measured on the soldier at levels 4 to 6.
constexpr double kBuildShare = 0.18, kRefineShare = 0.06;

/// The number of the first point that single precision has no room for; -1 when there is none.
template <class Real>
std::int64_t firstTooLarge(std::span<const Real> numbers) {
  const auto found = std::find_if(numbers.begin(), numbers.end(), [](Real x) { return !std::isfinite(x); });
  return found == numbers.end() ? -1 : (found - numbers.begin()) / 3;
}

/// The control points in the precision of the run: vertices, then central control vertices where they are given.
/// Errors: invalidPositions, when one is too large for it.
template <class Real>
Result<std::vector<Real>> controlPoints(const MeshInput& input, const CentralPoints& central) {
  std::vector<Real> points(input.mesh.positions.begin(), input.mesh.positions.end());
  if (const std::int64_t v = firstTooLarge<Real>(points); v >= 0)
    return fail(ErrorCode::invalidPositions,
                fmt::format("{}: vertex {} doesn't fit single precision; use --precision double",
                            placeInFile(input, input.mesh.vertexLines.empty() ? 0 : input.mesh.vertexLines[at(v)]),
                            input.fileVertex(v) + 1));
  if (!central.given) return points;
  if (central.file.empty()) {
    appendOffsetPoints(input.mesh.polygons, central.offsets, points);
    return points;
  }
  points.insert(points.end(), central.positions.begin(), central.positions.end());
  if (const std::int64_t i = firstTooLarge<Real>(points); i >= 0)
    return fail(ErrorCode::invalidPositions,
                fmt::format("{}: point {} doesn't fit single precision; use --precision double", central.file,
                            i - input.mesh.polygons.vertexCount + 1));
  return points;
}

/// What is refined, and how far.
struct RefineJob {
  const RefineCommand& command;
  const SurfacePlan& plan;
  CentralPoints central;
  Normals normals = Normals::none;
  int bytesPerNumber = 4;
};

template <class Real>
struct Refined {
  Surface<Real> surface;
  Primvars<Real> primvars;
};

template <class Real>
Result<void> writeSurface(const std::string& output, const Far::Refinement& refinement, const Refined<Real>& refined) {
  const Result<const MeshOutput*> format = meshOutput(output);
  if (!format) return tl::unexpected(format.error());
  const Far::Topology& topology = refinement.last().topology;
  Io::ObjContent<Real> content{refined.surface.vertices(), refined.surface.normals, topology.faceOffsets(),
                               topology.vert()};
  refined.primvars.addTo(content);
  const InterruptScope interruptible;
  return (*format)->write(output, content);
}

/// The surface of the tables' last level. A tessellation brings its derivatives, and so its normals, along.
template <class Real>
Result<Refined<Real>> evaluate(const RefineJob& job, const Far::Refinement& refinement) {
  const Result<std::vector<Real>> control = controlPoints<Real>(job.plan.mesh.input, job.central);
  if (!control) return tl::unexpected(control.error());
  Result<std::unique_ptr<SurfaceEvaluator>> evaluator =
      job.plan.backend->evaluator(refinement, job.command.pieces ? Normals::none : job.normals);
  if (!evaluator) return tl::unexpected(evaluator.error());
  Surface<Real> surface;
  Result<void> done = (*evaluator)->evaluate(std::span<const Real>(*control), surface);
  if (done) done = checkFinite<Real>(surface.vertices());
  if (!done) return tl::unexpected(inFile(job.plan.mesh.input.file, done.error()));
  if (job.command.pieces && job.normals == Normals::exact) setNormals(surface);
  auto primvars = refinePrimvars<Real>(job.plan.mesh.input, refinement, job.central.given, **evaluator);
  if (!primvars) return tl::unexpected(inFile(job.plan.mesh.input.file, primvars.error()));
  return Refined<Real>{std::move(surface), std::move(*primvars)};
}

template <class Real>
Result<void> evaluateAndWrite(const RefineJob& job, const Far::Refinement& refinement, Progress& progress,
                              Summary& summary) {
  const auto vertices = static_cast<double>(refinement.last().topology.vertexCount());
  progress.advance(vertices * kBuildShare);
  progress.stage("refining");
  Stopwatch stopwatch;
  const Result<Refined<Real>> refined = evaluate<Real>(job, refinement);
  if (!refined) return tl::unexpected(refined.error());
  summary.refineMs = stopwatch.lap();
  progress.advance(vertices * kRefineShare);
  progress.stage("writing");
  Result<void> written = writeSurface(job.command.output, refinement, *refined);
  summary.writeMs = stopwatch.lap();
  return written;
}

Result<void> printSummary(const RefineJob& job, const Session& session, const Far::Refinement& refinement,
                          const Summary& summary) {
  const Far::Topology& refined = refinement.last().topology;
  const SchemeChain& chain = job.plan.mesh.chain;
  if (!session.json) {
    printNote(session, fmt::format("{}: {} vertices, {} faces at level {} of {}", job.command.output,
                                   grouped(refined.vertexCount()), grouped(refined.faceCount()), chain.levels(),
                                   job.command.surface.scheme.scheme));
    return {};
  }
  nlohmann::ordered_json json{{"input", job.command.surface.input},
                              {"output", job.command.output},
                              {"scheme", job.command.surface.scheme.scheme},
                              {"steps", stepNames(chain)},
                              {"levels", chain.levels()},
                              {"backend", job.plan.backend->name()},
                              {"precision", job.command.precision},
                              {"dropped_vertices", job.plan.mesh.input.dropped()},
                              {"vertices", refined.vertexCount()},
                              {"edges", refined.edgeCount()},
                              {"faces", refined.faceCount()},
                              {"table_bytes", refinement.byteCount()},
                              {"build_ms", summary.buildMs},
                              {"refine_ms", summary.refineMs},
                              {"write_ms", summary.writeMs}};
  if (job.command.pieces) json["tessellate"] = *job.command.pieces;
  return printResult(jsonText(json));
}

Result<Far::Refinement> build(const RefineJob& job) {
  RunShape shape{1, job.bytesPerNumber, job.normals == Normals::exact && !job.command.pieces, job.central.given};
  shape.fastNormals = job.normals == Normals::fast;
  Result<Far::Refinement> refinement = buildTables(job.plan, shape);
  if (!refinement || !job.command.pieces) return refinement;
  refinement = tessellate(std::move(*refinement), *job.command.pieces, job.normals, availableMemory());
  if (!refinement) return tl::unexpected(inFile(job.plan.mesh.input.file, refinement.error()));
  return refinement;
}

/// Builds, refines and writes under a progress bar.
Result<Far::Refinement> produce(const RefineJob& job, const Session& session, Summary& summary) {
  Stopwatch stopwatch;
  const auto counts = Far::predict(job.plan.mesh.topology, job.plan.mesh.chain.steps);
  const double pieces = job.command.pieces.value_or(1);
  Progress progress(session, "building", "vertices", static_cast<double>(counts.back().vertices) * pieces * pieces);
  Result<Far::Refinement> refinement = build(job);
  if (!refinement) return refinement;
  summary.buildMs = stopwatch.lap();
  const auto finish = job.bytesPerNumber == 8 ? evaluateAndWrite<double> : evaluateAndWrite<float>;
  const Result<void> done = finish(job, *refinement, progress, summary);
  if (!done) return tl::unexpected(done.error());
  return refinement;
}

/// A tessellation may be of the three-valent mesh itself.
LevelChoice levelChoice(const RefineCommand& command) {
  return {LevelChoice{}.usual, command.pieces ? 0 : 1};
}

/// What can be told before the mesh is read.
Result<void> checkCommand(const RefineCommand& command) {
  if (const auto format = meshOutput(command.output); !format) return tl::unexpected(format.error());
  std::vector<std::filesystem::path> inputs{command.surface.input};
  if (command.surface.scheme.given(kCentralFileOption))
    inputs.emplace_back(command.surface.scheme.text(kCentralFileOption));
  if (auto writable = checkOutput(command.output, inputs); !writable) return writable;
  const auto chain = readChain(command.surface.scheme, command.surface.levels, levelChoice(command));
  if (!chain) return tl::unexpected(chain.error());
  if (command.pieces && command.normals == "fast")
    return fail(ErrorCode::invalidOption, "--normals fast: a tessellation has exact ones; use --normals exact");
  if (command.pieces) return checkTessellation(*chain, command.surface.scheme, *command.pieces);
  const SchemeEntry& last = *chain->parts.back().scheme;
  if (command.normals == "none" || last.limits) return {};
  return fail(ErrorCode::invalidOption, fmt::format("--normals {}: the limits of {} are not known; end the chain with "
                                                    "another scheme, or leave --normals out",
                                                    command.normals, last.name));
}

Result<void> refine(const RefineCommand& command, const Session& session) {
  const auto precision = choose(kPrecisions, "--precision", command.precision);
  if (!precision) return tl::unexpected(precision.error());
  const auto normals = choose(kNormals, "--normals", command.normals);
  if (!normals) return tl::unexpected(normals.error());
  if (auto sound = checkCommand(command); !sound) return sound;
  const Result<SurfacePlan> plan = planSurface(command.surface, (*precision)->bytes, levelChoice(command));
  if (!plan) return tl::unexpected(plan.error());
  Result<CentralPoints> central = readCentralPoints(command.surface.scheme, plan->mesh.input);
  if (!central) return tl::unexpected(central.error());
  printNotes(session, plan->mesh.input);
  const RefineJob job{command, *plan, std::move(*central), (*normals)->normals, (*precision)->bytes};
  Summary summary;
  const Result<Far::Refinement> refinement = produce(job, session, summary);
  if (!refinement) return tl::unexpected(refinement.error());
  return printSummary(job, session, *refinement, summary);
}

}  // namespace

void addRefine(CLI::App& app, Command& command) {
  const auto options = std::make_shared<RefineCommand>();
  CLI::App* subcommand = app.add_subcommand("refine", "Refine a mesh");
  subcommand->add_option("IN", options->surface.input, "Control mesh: " + meshInputNames())->required();
  subcommand->add_option("OUT", options->output, "Refined mesh (.obj, .ply, .glb)")->required();
  addSurfaceOptions(*subcommand, options->surface);
  subcommand->add_option("--precision", options->precision, "Arithmetic: " + names(kPrecisions))->capture_default_str();
  subcommand->add_option("--normals", options->normals, "Limit normals of the vertices: " + names(kNormals))
      ->capture_default_str();
  subcommand->add_option("--tessellate", options->pieces,
                         "Write the exact limit surface of the last level instead, each patch cut into this many "
                         "pieces along its edges, 1 to " +
                             std::to_string(Far::kMostPieces) + " [half-box; --levels may be 0]");
  addSessionOptions(*subcommand, command.session);
  subcommand->callback([options, &command] {
    command.action = [options](const Session& session) { return refine(*options, session); };
  });
}

}  // namespace honeycomb::Cli
