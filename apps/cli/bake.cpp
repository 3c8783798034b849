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
  std::string cache;
  std::string output;
  std::string mesh;    ///< refined mesh to write beside the cache; empty: none
  std::string frames;  ///< a:b; empty: all
};

Result<void> checkFiles(const BakeCommand& command) {
  if (command.cache.empty())
    return fail(
        ErrorCode::invalidOption,
        fmt::format("{}: holds one pose only; name its animation with --cache FILE.pc2", command.surface.input));
  for (const std::string& cache : {command.cache, command.output})
    if (const auto known = checkCacheFormat(cache); !known) return known;
  std::vector<std::filesystem::path> taken{command.surface.input, command.cache};
  if (command.surface.scheme.given(kCentralFileOption))
    taken.emplace_back(command.surface.scheme.text(kCentralFileOption));
  if (const auto writable = checkOutput(command.output, taken); !writable) return writable;
  if (command.mesh.empty()) return {};
  if (const auto known = meshFormat(command.mesh); !known) return tl::unexpected(known.error());
  taken.emplace_back(command.output);
  return checkOutput(command.mesh, taken);
}

Result<Io::Pc2Reader> openCache(const BakeCommand& command, const MeshInput& input) {
  Result<Io::Pc2Reader> cache = Io::Pc2Reader::open(command.cache);
  if (!cache) return tl::unexpected(inFile(command.cache, cache.error()));
  if (cache->info().pointCount != input.fileVertices)
    return fail(ErrorCode::invalidFile,
                fmt::format("{}: has {} points a frame, but {} has {} vertices; bake the mesh the cache was made for",
                            command.cache, cache->info().pointCount, command.surface.input, input.fileVertices));
  return cache;
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
    printNote(session,
              fmt::format("{}: {} of {} vertices at level {}", command.output, counted(job.range.count(), "frame"),
                          grouped(refined.vertexCount()), plan.mesh.chain.levels()));
    return {};
  }
  const nlohmann::ordered_json json{{"input", command.surface.input},
                                    {"cache", command.cache},
                                    {"output", command.output},
                                    {"scheme", command.surface.scheme.scheme},
                                    {"steps", stepNames(plan.mesh.chain)},
                                    {"levels", plan.mesh.chain.levels()},
                                    {"backend", plan.backend->name()},
                                    {"dropped_vertices", plan.mesh.input.dropped()},
                                    {"frames", job.range.count()},
                                    {"frames_at_once", job.atOnce()},
                                    {"vertices", refined.vertexCount()},
                                    {"faces", refined.faceCount()},
                                    {"table_bytes", job.refinement.byteCount()},
                                    {"tile_bytes", tileBytes},
                                    {"build_ms", buildMs},
                                    {"bake_ms", bakeMs},
                                    {"ms_per_frame", bakeMs / job.range.count()}};
  return printResult(jsonText(json));
}

Result<void> bake(const BakeCommand& command, const Session& session) {
  if (const auto checked = checkFiles(command); !checked) return checked;
  const Result<SurfacePlan> plan = planSurface(command.surface, sizeof(float));
  if (!plan) return tl::unexpected(plan.error());
  const Result<Io::Pc2Reader> cache = openCache(command, plan->mesh.input);
  if (!cache) return tl::unexpected(cache.error());
  const Result<FrameRange> range = parseFrameRange(command.frames, cache->info().frameCount);
  if (!range) return tl::unexpected(range.error());

  const Result<CentralPoints> central =
      readCentralCache(command.surface.scheme, plan->mesh.input, cache->info().frameCount);
  if (!central) return tl::unexpected(central.error());

  Stopwatch stopwatch;
  const int atOnce = std::min(plan->backend->framesAtOnce(), range->count());
  const Result<Far::Refinement> refinement = buildTables(*plan, {atOnce, sizeof(float), false, central->given});
  if (!refinement) return tl::unexpected(refinement.error());
  const auto evaluators = plan->backend->frameEvaluators(*refinement, range->count(), atOnce);
  if (!evaluators) return tl::unexpected(evaluators.error());
  const double buildMs = stopwatch.lap();

  const BakeFrames job{*cache, *range, plan->mesh.input, *central, *refinement, *evaluators, command.cache};
  const Io::Pc2Info info{refinement->last().topology.vertexCount(), range->count(),
                         cache->info().start + static_cast<float>(range->begin) * cache->info().rate,
                         cache->info().rate};
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
  subcommand->add_option("--cache", options->cache, "Point cache that animates IN (.pc2)");
  subcommand->add_option("--mesh", options->mesh, "Also write the refined mesh of the first frame baked (.obj)");
  subcommand->add_option("--frames", options->frames, "Frames a:b of the cache, b not included (default: all)");
  addSurfaceOptions(*subcommand, options->surface);
  addSessionOptions(*subcommand, command.session);
  subcommand->callback(
      [options, &command] { command.action = [options](const Session& session) { return bake(*options, session); }; });
}

}  // namespace honeycomb::Cli
