#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "apps/cli/bake_frames.h"
#include "apps/cli/central_points.h"
#include "apps/cli/commands.h"
#include "apps/cli/formats.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/json_text.h"
#include "apps/cli/primvars.h"
#include "apps/cli/surface_options.h"
#include "far/base/index.h"
#include "far/base/stopwatch.h"
#include "io/pc2.h"

namespace honeycomb::Cli {
namespace {

struct BakeCommand {
  SurfaceOptions surface;
  AnimationOptions animation;
  std::string output;
  std::string mesh;  ///< refined mesh to write beside the cache; empty: none
};

Result<void> checkFiles(const BakeCommand& command) {
  if (const auto known = checkCacheFormat(command.output); !known) return known;
  std::vector<std::filesystem::path> taken{command.surface.input};
  if (!command.animation.cache.empty()) taken.emplace_back(command.animation.cache);
  if (command.surface.scheme.given(kCentralFileOption))
    taken.emplace_back(command.surface.scheme.text(kCentralFileOption));
  if (const auto writable = checkOutput(command.output, taken); !writable) return writable;
  if (command.mesh.empty()) return {};
  if (const auto known = meshFormat(command.mesh); !known) return tl::unexpected(known.error());
  taken.emplace_back(command.output);
  return checkOutput(command.mesh, taken);
}

Result<void> writeMesh(const BakeCommand& command, const BakeFrames& job, const std::vector<float>& points) {
  const Result<const MeshFormat*> format = meshFormat(command.mesh);
  if (!format) return tl::unexpected(format.error());
  const auto primvars =
      refinePrimvars<float>(job.input, job.refinement, job.central.given, *job.evaluators.each.front());
  if (!primvars) return tl::unexpected(inFile(job.input.file, primvars.error()));
  const Far::Topology& topology = job.refinement.last().topology;
  Io::ObjContent<float> content{points, {}, topology.faceOffsets(), topology.vert()};
  primvars->addTo(content);
  return (*format)->write(command.mesh, content);
}

/// Both files or neither: the mesh is written first, and removed again where the cache can't be finished.
Result<void> writeFiles(const BakeCommand& command, const BakeFrames& job, Io::Pc2Writer& writer,
                        const Session& session) {
  std::vector<float> firstFrame;
  if (const auto baked = bakeFrames(job, session, writer, command.mesh.empty() ? nullptr : &firstFrame); !baked)
    return baked;
  if (!command.mesh.empty())
    if (const auto written = writeMesh(command, job, firstFrame); !written) return written;
  const Result<void> finished = writer.finish();
  std::error_code ignored;
  if (!finished && !command.mesh.empty()) std::filesystem::remove(command.mesh, ignored);
  return finished;
}

Result<void> printSummary(const BakeCommand& command, const Session& session, const SurfacePlan& plan,
                          const BakeFrames& job, std::int64_t tileBytes, double buildMs, double bakeMs) {
  const Far::Topology& refined = job.refinement.last().topology;
  if (!session.json) {
    printNote(session, fmt::format("{}: {} of {} vertices at level {}", command.output,
                                   counted(job.animation.range.count(), "frame"), grouped(refined.vertexCount()),
                                   plan.mesh.chain.levels()));
    return {};
  }
  const nlohmann::ordered_json json{{"input", command.surface.input},
                                    {"cache", job.animation.file},
                                    {"output", command.output},
                                    {"scheme", command.surface.scheme.scheme},
                                    {"steps", stepNames(plan.mesh.chain)},
                                    {"levels", plan.mesh.chain.levels()},
                                    {"backend", plan.backend->name()},
                                    {"dropped_vertices", plan.mesh.input.dropped()},
                                    {"frames", job.animation.range.count()},
                                    {"frames_at_once", job.atOnce()},
                                    {"vertices", refined.vertexCount()},
                                    {"faces", refined.faceCount()},
                                    {"table_bytes", job.refinement.byteCount()},
                                    {"tile_bytes", tileBytes},
                                    {"build_ms", buildMs},
                                    {"bake_ms", bakeMs},
                                    {"ms_per_frame", bakeMs / job.animation.range.count()}};
  return printResult(jsonText(json));
}

Result<void> bake(const BakeCommand& command, const Session& session) {
  if (const auto checked = checkFiles(command); !checked) return checked;
  const Result<SurfacePlan> plan = planSurface(command.surface, sizeof(float));
  if (!plan) return tl::unexpected(plan.error());
  printNotes(session, plan->mesh.input);
  const Result<Animation> animation = openAnimation(command.animation, plan->mesh.input);
  if (!animation) return tl::unexpected(animation.error());
  const FrameRange range = animation->range;
  const Io::FrameInfo& frames = animation->frames->info();
  const Result<CentralPoints> central = readCentralCache(command.surface.scheme, plan->mesh.input, frames.frameCount);
  if (!central) return tl::unexpected(central.error());

  Stopwatch stopwatch;
  const int atOnce = std::min(plan->backend->framesAtOnce(), range.count());
  const Result<Far::Refinement> refinement = buildTables(*plan, {atOnce, sizeof(float), false, central->given});
  if (!refinement) return tl::unexpected(refinement.error());
  const auto evaluators = plan->backend->frameEvaluators(*refinement, range.count(), atOnce);
  if (!evaluators) return tl::unexpected(evaluators.error());
  const double buildMs = stopwatch.lap();

  const BakeFrames job{*animation, plan->mesh.input, *central, *refinement, *evaluators};
  const Io::FrameInfo info{refinement->last().topology.vertexCount(), range.count(),
                           frames.start + static_cast<float>(range.begin) * frames.rate, frames.rate,
                           frames.framesPerSecond};
  const InterruptScope interruptible;
  Result<Io::Pc2Writer> writer = Io::Pc2Writer::create(command.output, info);
  if (!writer) return tl::unexpected(inFile(command.output, writer.error()));
  if (const auto written = writeFiles(command, job, *writer, session); !written) return written;
  return printSummary(command, session, *plan, job, evaluators->tileBytes, buildMs, stopwatch.lap());
}

}  // namespace

void addBake(CLI::App& app, Command& command) {
  const auto options = std::make_shared<BakeCommand>();
  CLI::App* subcommand = app.add_subcommand("bake", "Refine every frame of an animated mesh");
  subcommand->add_option("IN", options->surface.input, "Control mesh (.obj)")->required();
  subcommand->add_option("OUT", options->output, "Refined point cache (.pc2)")->required();
  subcommand->add_option("--mesh", options->mesh, "Also write the refined mesh of the first frame baked (.obj)");
  addAnimationOptions(*subcommand, options->animation);
  addSurfaceOptions(*subcommand, options->surface);
  addSessionOptions(*subcommand, command.session);
  subcommand->callback(
      [options, &command] { command.action = [options](const Session& session) { return bake(*options, session); }; });
}

}  // namespace honeycomb::Cli
