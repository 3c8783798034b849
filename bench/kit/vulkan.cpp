#include <time.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "bench/kit/evaluators.h"
#include "far/base/stopwatch.h"
#include "io/cache_folder.h"
#include "osd/vulkan/commands.h"
#include "osd/vulkan/context.h"
#include "osd/vulkan/frames.h"
#include "osd/vulkan/pipeline_cache_file.h"
#include "osd/vulkan/session.h"

namespace honeycomb::Bench {

namespace {

/// Microseconds of processor time that this thread has had.
double threadUs() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

/// Frames in flight, and a command buffer that is recorded beside them.
struct Engine {
  Osd::VulkanFrames frames;
  Osd::CommandRunner commands;

  static Result<Engine> create(const Osd::VulkanEvaluator& evaluator, const Osd::VulkanTable& table) {
    auto frames = Osd::VulkanFrames::create(evaluator, table, {.framesInFlight = 2, .frame = {.readback = false}});
    if (!frames) return tl::unexpected(frames.error());
    auto commands = Osd::CommandRunner::create(evaluator.core());
    if (!commands) return tl::unexpected(commands.error());
    return Engine{std::move(*frames), std::move(*commands)};
  }
};

/// A device and what is on it; destroyed from the last to the first.
struct OnDevice {
  Osd::VulkanContext context;
  Osd::VulkanEvaluator evaluator;
  Osd::VulkanSession session;
  std::optional<Osd::VulkanSession> timed;  ///< made when times are asked for
  std::optional<Engine> engine;             ///< the same

  Result<double> recordUs() {
    if (const auto begun = engine->commands.begin(0); !begun) return tl::unexpected(begun.error());
    const double start = threadUs();
    evaluator.record(engine->commands.commandBuffer(), session.binding());
    const double taken = threadUs() - start;
    if (const auto ended = engine->commands.end(); !ended) return tl::unexpected(ended.error());
    return taken;
  }
  Result<double> submitUs(std::span<const float> control) {
    const auto target = engine->frames.begin();
    if (!target) return tl::unexpected(target.error());
    std::copy(control.begin(), control.end(), target->begin());
    const double start = threadUs();
    const auto ticket = engine->frames.submit();
    const double taken = threadUs() - start;
    if (!ticket) return tl::unexpected(ticket.error());
    if (const auto done = engine->frames.wait(*ticket); !done) return tl::unexpected(done.error());
    return taken;
  }
  Result<HostUs> hostFrame(std::span<const float> control) {
    if (!engine) {
      auto made = Engine::create(evaluator, session.table());
      if (!made) return tl::unexpected(made.error());
      engine.emplace(std::move(*made));
    }
    const auto record = recordUs();
    if (!record) return tl::unexpected(record.error());
    const auto submit = submitUs(control);
    if (!submit) return tl::unexpected(submit.error());
    return HostUs{*record, *submit};
  }

  /// A frame with timestamps between its levels.
  Result<std::vector<LevelMs>> timedFrame(std::span<const float> control) {
    if (!timed) {
      auto made = Osd::VulkanSession::create(evaluator, session.table(), {.timing = true});
      if (!made) return tl::unexpected(made.error());
      timed.emplace(std::move(*made));
    }
    std::copy(control.begin(), control.end(), timed->control().begin());
    if (const auto ran = timed->run(); !ran) return tl::unexpected(ran.error());
    const auto times = timed->binding().levelTimes();
    if (!times) return tl::unexpected(times.error());
    std::vector<LevelMs> levels;
    for (const Osd::LevelTime& time : *times) levels.push_back({time.level, time.limits, time.milliseconds});
    return levels;
  }
};

using Upload = Result<Osd::VulkanTable> (*)(Osd::VulkanEvaluator&, const Problem&);

Osd::VulkanTableOptions optionsOf(const Problem& problem) {
  Osd::VulkanTableOptions options;
  options.control = options.refined = problem.layout.desc;
  if (problem.normals != Normals::none) options.vertexLimits.normals = Osd::BufferDescriptor{};
  options.normalKind = tileNormals(problem.normals);
  return options;
}

Result<Osd::VulkanTable> uploadLevels(Osd::VulkanEvaluator& evaluator, const Problem& problem) {
  return evaluator.upload(problem.refinement, optionsOf(problem));
}

Result<Osd::VulkanTable> uploadTiles(Osd::VulkanEvaluator& evaluator, const Problem& problem) {
  Far::TileOptions cut = evaluator.tileOptions();
  cut.normals = tileNormals(problem.normals);
  const Result<Far::TileTable> tiles = Far::buildTileTable(problem.refinement, cut);
  if (!tiles) return tl::unexpected(tiles.error());
  Osd::VulkanTileOptions options;
  options.control = options.refined = problem.layout.desc;
  if (problem.normals != Normals::none) options.normals = Osd::BufferDescriptor{};
  return evaluator.uploadTiles(problem.refinement, *tiles, options);
}

Result<Osd::VulkanTable> uploadFlat(Osd::VulkanEvaluator& evaluator, const Problem& problem) {
  const Result<const Far::StencilTable*> table = problem.flat.get();
  if (!table) return tl::unexpected(table.error());
  return evaluator.upload(**table, Far::StencilWeights::position, optionsOf(problem));
}

/// The control points are written to the device's memory in every frame, as an animation does; results stay there.
Result<Prepared> prepare(const Problem& problem, Upload upload) {
  Result<Osd::VulkanContext> context = Osd::VulkanContext::create();
  if (!context) return tl::unexpected(context.error());
  const Osd::VulkanEvaluatorOptions options{.pipelineCache =
                                                Osd::pipelineCacheIn(Io::cacheFolder(), context->deviceName())};
  Result<Osd::VulkanEvaluator> evaluator = Osd::VulkanEvaluator::create(context->device(), options);
  if (!evaluator) return tl::unexpected(evaluator.error());
  const Stopwatch stopwatch;
  Result<Osd::VulkanTable> table = upload(*evaluator, problem);
  if (!table) return tl::unexpected(table.error());
  Prepared prepared;
  prepared.tableBytes = static_cast<std::int64_t>(table->byteCount());
  Result<Osd::VulkanSession> session = Osd::VulkanSession::create(*evaluator, *table);
  if (!session) return tl::unexpected(session.error());
  const auto device =
      std::make_shared<OnDevice>(OnDevice{std::move(*context), std::move(*evaluator), std::move(*session), {}, {}});
  prepared.frame = [device, control = problem.control]() -> Result<void> {
    std::copy(control.begin(), control.end(), device->session.control().begin());
    return device->session.run();
  };
  // A flattened table has a single step, which is no level.
  if (upload == uploadLevels)
    prepared.levels = [device, control = problem.control] { return device->timedFrame(control); };
  prepared.host = [device, control = problem.control] { return device->hostFrame(control); };
  prepared.refined = device->session.refined();
  prepared.normals = device->session.vertexNormals();
  prepared.buildMs = problem.tablesMs + stopwatch.milliseconds();
  prepared.vertices = problem.refinement.last().topology.vertexCount();
  return prepared;
}

}  // namespace

Result<Prepared> prepareVulkan(const Problem& problem) {
  return prepare(problem, uploadLevels);
}

Result<Prepared> prepareVulkanTiled(const Problem& problem) {
  return prepare(problem, uploadTiles);
}

Result<Prepared> prepareVulkanCsr(const Problem& problem) {
  if (auto ok = withoutNormals(problem); !ok) return tl::unexpected(ok.error());
  return prepare(problem, uploadFlat);
}

}  // namespace honeycomb::Bench
