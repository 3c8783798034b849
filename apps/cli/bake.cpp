#include <fmt/format.h>
#include <sys/stat.h>

#include <CLI/CLI.hpp>

#include "apps/cli/bake_formats.h"
#include "apps/cli/bake_frames.h"
#include "apps/cli/bake_output.h"
#include "apps/cli/bake_tables.h"
#include "apps/cli/catching.h"
#include "apps/cli/central_points.h"
#include "apps/cli/commands.h"
#include "apps/cli/formats.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/json_text.h"
#include "apps/cli/primvars.h"
#include "apps/cli/ranks.h"
#include "apps/cli/surface_options.h"
#include "far/base/stopwatch.h"
#include "io/checksum.h"

namespace honeycomb::Cli {
namespace {

struct BakeCommand {
  SurfaceOptions surface;
  AnimationOptions animation;
  std::string output;
  std::string mesh;   ///< refined mesh to write beside the frames; empty: none
  std::string table;  ///< table file to go by; empty: tables are built
  bool restart = false;
};

Result<void> checkFiles(const BakeCommand& command) {
  if (auto known = checkBakeFormat(command.output); !known) return known;
  std::vector<std::filesystem::path> taken{command.surface.input};
  if (!command.animation.cache.empty()) taken.emplace_back(command.animation.cache);
  if (command.surface.scheme.given(kCentralFileOption))
    taken.emplace_back(command.surface.scheme.text(kCentralFileOption));
  if (!command.table.empty()) taken.emplace_back(command.table);
  if (auto writable = checkOutput(command.output, taken); !writable) return writable;
  if (command.mesh.empty()) return {};
  if (const auto known = meshOutput(command.mesh); !known) return tl::unexpected(known.error());
  taken.emplace_back(command.output);
  return checkOutput(command.mesh, taken);
}

/// All that a rank needs to bake frames, and the first frame.
struct Bake {
  const BakeCommand& command;
  SurfacePlan plan;
  Animation animation;
  CentralPoints central;
  BakeTables tables;
  FrameEvaluators evaluators;
  std::vector<float> firstPoints;
  Primvars<float> primvars;
  BakedMesh mesh;
  double buildMs = 0;

  BakeFrames frames() const { return {animation, plan.mesh.input, central, evaluators}; }
};

/// The first frame with its connectivity and, where a file has room for them, its colours and texture coordinates.
Result<void> setMesh(Bake& bake) {
  Result<std::vector<float>> points = bakeFirstFrame(bake.frames());
  if (!points) return tl::unexpected(points.error());
  bake.firstPoints = std::move(*points);
  const Io::TableMesh& mesh = bake.tables.mesh();
  bake.mesh = bakedTimes(bake.animation.frames->info(), bake.animation.range.begin, bake.animation.range.count(),
                         mesh.vertexCount);
  bake.mesh.content = {bake.firstPoints, {}, mesh.faceOffsets, mesh.faceVertices};
  const Far::Refinement* refinement = bake.tables.refinement();
  if (refinement == nullptr || (bake.command.mesh.empty() && !storesMesh(bake.command.output))) return {};
  const MeshInput& input = bake.plan.mesh.input;
  auto primvars = refinePrimvars<float>(input, *refinement, bake.central.given, *bake.evaluators.each.front());
  if (!primvars) return tl::unexpected(inFile(input.file, primvars.error()));
  bake.primvars = std::move(*primvars);
  bake.primvars.addTo(bake.mesh.content);
  return {};
}

/// A table file has no texture coordinates or colours of the last level.
Result<void> checkTableUse(const BakeCommand& command, const MeshInput& input) {
  const bool stored = !command.mesh.empty() || storesMesh(command.output);
  if (!stored || (input.mesh.texcoords.empty() && input.mesh.colours.empty())) return {};
  return fail(
      ErrorCode::invalidOption,
      fmt::format("--table: {} has colours or texture coordinates, which a table file can't refine; bake to .pc2 "
                  "or .mdd without --mesh, or leave --table out",
                  command.surface.input));
}

/// The input as far as a table needs it: the table has the scheme.
Result<SurfacePlan> planFor(const BakeCommand& command) {
  if (command.table.empty()) return planSurface(command.surface, sizeof(float));
  Result<SurfacePlan> plan = planByTable(command.surface);
  if (!plan) return plan;
  if (const auto usable = checkTableUse(command, plan->mesh.input); !usable) return tl::unexpected(usable.error());
  return plan;
}

Result<BakeTables> tablesFor(const BakeCommand& command, const SurfacePlan& plan, int atOnce, bool centralPoints) {
  if (!command.table.empty()) return BakeTables::open(command.table, plan.mesh.input);
  return BakeTables::build(plan, {atOnce, sizeof(float), false, centralPoints});
}

/// Frames that can't be written in any order are refined one at a time.
Result<std::unique_ptr<Bake>> prepare(const BakeCommand& command, const Session& session) {
  if (const auto checked = checkFiles(command); !checked) return tl::unexpected(checked.error());
  Result<SurfacePlan> plan = planFor(command);
  if (!plan) return tl::unexpected(plan.error());
  printNotes(session, plan->mesh.input);
  Result<Animation> animation = openAnimation(command.animation, plan->mesh.input);
  if (!animation) return tl::unexpected(animation.error());
  const std::int32_t frameCount = animation->frames->info().frameCount, baked = animation->range.count();
  Result<CentralPoints> central = readCentralCache(command.surface.scheme, plan->mesh.input, frameCount);
  if (!central) return tl::unexpected(central.error());

  Stopwatch stopwatch;
  const int atOnce = anyOrder(command.output) ? std::min(plan->backend->framesAtOnce(), baked) : 1;
  Result<BakeTables> tables = tablesFor(command, *plan, atOnce, central->given);
  if (!tables) return tl::unexpected(tables.error());
  std::unique_ptr<Bake> bake(new Bake{
      command, std::move(*plan), std::move(*animation), std::move(*central), std::move(*tables), {}, {}, {}, {}});
  auto evaluators = bake->plan.backend->frameEvaluators(bake->tables.view(), baked, atOnce);
  if (!evaluators) return tl::unexpected(evaluators.error());
  bake->evaluators = std::move(*evaluators);
  bake->buildMs = stopwatch.lap();
  if (const auto set = setMesh(*bake); !set) return tl::unexpected(set.error());
  return bake;
}

/// What file it is, as far as can be told without reading all of it.
void addFile(Io::Checksum& sum, const std::filesystem::path& file) {
  struct stat status {};
  if (file.empty() || stat(file.c_str(), &status) != 0) return;
  sum.addValue(status.st_size);
  sum.addValue(status.st_mtim.tv_sec);
  sum.addValue(status.st_mtim.tv_nsec);
}

template <class T>
void addArray(Io::Checksum& sum, std::span<const T> values) {
  sum.addValue(values.size());
  sum.add(std::as_bytes(values));
}

/// Tells this bake from others. The first frame stands for the mesh, the scheme and all its options: every backend
/// gives the same bits, so a bake may go on with another one.
std::uint64_t whatWasAsked(const Bake& bake) {
  Io::Checksum sum;
  sum.add(HONEYCOMB_VERSION);
  sum.add(std::filesystem::path(bake.command.output).extension().string());
  addFile(sum, bake.animation.file);
  if (bake.command.animation.cache.empty())
    for (const std::filesystem::path& file : bake.plan.mesh.input.files) addFile(sum, file);
  addFile(sum, bake.central.file);
  const Io::FrameInfo& info = bake.mesh.info;
  sum.addValue(bake.mesh.firstFrame);
  sum.addValue(info.frameCount);
  for (const double time : {double{info.start}, double{info.rate}, bake.mesh.framesPerSecond}) sum.addValue(time);
  const Io::ObjContent<float>& content = bake.mesh.content;
  for (const auto& values : {content.positions, content.colours, content.texcoords}) addArray(sum, values);
  for (const auto& values : {content.faceOffsets, content.faceVertices, content.cornerTexcoords}) addArray(sum, values);
  return sum.value();
}

/// Both files or neither: the mesh is written first, and removed again where the frames can't be put under their name.
Result<void> writeFiles(const Bake& bake, BakeOutput& output) {
  const std::string& mesh = bake.command.mesh;
  if (!mesh.empty()) {
    const Result<const MeshOutput*> format = meshOutput(mesh);
    if (!format) return tl::unexpected(format.error());
    if (auto written = (*format)->write(mesh, bake.mesh.content); !written) return written;
  }
  Result<void> finished = output.finish();
  std::error_code ignored;
  if (!finished && !mesh.empty()) std::filesystem::remove(mesh, ignored);
  return finished;
}

/// Frames on all ranks, then rank 0 puts the files under their names.
Result<void> produce(const Bake& bake, BakeOutput& output, Ranks& ranks, const Session& session) {
  BakeOutcome outcome;
  const auto baked = [&]() -> Result<void> {
    outcome = bakeFrames(bake.frames(), session, output.missing(), ranks, output.writer());
    return outcome.done;
  };
  // Whatever happens to a rank, the others are told.
  outcome.done = catching(baked);
  Result<void> done = ranks.agree(outcome.done, outcome.frame);
  if (done) done = output.close(ranks);
  if (!done) return done;
  if (ranks.rank() == 0) done = catching([&] { return writeFiles(bake, output); });
  return ranks.agree(done, 0);
}

Result<void> printSummary(const Bake& bake, const BakeOutput& output, const Ranks& ranks, const Session& session,
                          double bakeMs) {
  const BakeTables& tables = bake.tables;
  const BakeCommand& command = bake.command;
  const std::int32_t frames = bake.animation.range.count();
  const auto written = static_cast<std::int32_t>(output.missing().size());
  if (!session.json) {
    printNote(session, fmt::format("{}: {} of {} vertices at level {}", command.output, counted(frames, "frame"),
                                   grouped(tables.mesh().vertexCount), tables.levels()));
    return {};
  }
  const nlohmann::ordered_json json{{"input", command.surface.input},
                                    {"cache", bake.animation.file},
                                    {"output", command.output},
                                    {"scheme", command.table.empty() ? command.surface.scheme.scheme : std::string()},
                                    {"table", command.table},
                                    {"steps", tables.steps()},
                                    {"levels", tables.levels()},
                                    {"backend", bake.plan.backend->name()},
                                    {"ranks", ranks.size()},
                                    {"dropped_vertices", bake.plan.mesh.input.dropped()},
                                    {"frames", frames},
                                    {"frames_resumed", frames - written},
                                    {"frames_at_once", bake.frames().atOnce()},
                                    {"vertices", tables.mesh().vertexCount},
                                    {"faces", tables.faceCount()},
                                    {"table_bytes", tables.byteCount()},
                                    {"tile_bytes", bake.evaluators.tileBytes},
                                    {"build_ms", bake.buildMs},
                                    {"bake_ms", bakeMs},
                                    {"ms_per_frame", bakeMs / std::max(written, 1)}};
  return printResult(jsonText(json));
}

/// After an error, or a signal, which ends the program at once where other ranks might wait for it.
Error giveUp(BakeOutput& output, Error error, const Ranks& ranks, const Session& session) {
  const bool interrupted = interruptSignal() != 0, alone = ranks.size() == 1;
  if (interrupted)
    error.message = alone ? "stopped by a signal" : "stopped by a signal; one of the ranks may have died";
  if (ranks.rank() == 0) error = output.giveUp(std::move(error));
  if (!interrupted) return error;
  if (alone) {
    printNote(session, error.message);
    return error;
  }
  printError(error);
  dieOfInterrupt();
}

Result<void> bakeOn(Ranks& ranks, const BakeCommand& command, const Session& session) {
  const Result<std::unique_ptr<Bake>> prepared = catching([&] { return prepare(command, session); });
  if (auto sound = ranks.agree(prepared.map([](const auto&) {}), 0); !sound) return sound;
  const Bake& bake = **prepared;
  const Result<BakeFormat> format = bakeFormat(command.output, bake.mesh);
  if (!format) return tl::unexpected(format.error());

  const InterruptScope interruptible;
  Stopwatch stopwatch;
  Result<BakeOutput> output =
      BakeOutput::open(command.output, *format, {whatWasAsked(bake), command.restart}, ranks, session);
  if (!output) return tl::unexpected(inFile(command.output, output.error()));
  if (const auto done = produce(bake, *output, ranks, session); !done)
    return tl::unexpected(giveUp(*output, done.error(), ranks, session));
  return printSummary(bake, *output, ranks, session, stopwatch.lap());
}

/// Rank 0 has the others' errors too. They end well, or mpirun would end it before it has told.
Result<void> bake(const BakeCommand& command, const Session& session) {
  const auto ranks = openRanks();
  if (!ranks) return tl::unexpected(ranks.error());
  const Result<void> done = bakeOn(**ranks, command, session);
  return (*ranks)->rank() == 0 ? done : Result<void>{};
}

}  // namespace

void addBake(CLI::App& app, Command& command) {
  const auto options = std::make_shared<BakeCommand>();
  CLI::App* subcommand = app.add_subcommand("bake", "Refine every frame of an animated mesh");
  subcommand->add_option("IN", options->surface.input, animatedInputHelp())->required();
  subcommand->add_option("OUT", options->output, "Refined frames (.pc2, .mdd, .glb, or a mesh a frame: name_%04d.obj)")
      ->required();
  subcommand->add_option("--mesh", options->mesh,
                         "Also write the refined mesh of the first frame baked (.obj, .ply, .glb)");
  subcommand->add_option("--table", options->table,
                         "Table file (.hct) to go by, made for IN; it has the scheme, its options and the levels");
  subcommand->add_flag("--restart", options->restart, "Bake all frames, also those that an earlier run has left");
  addAnimationOptions(*subcommand, options->animation, options->surface.read);
  addSurfaceOptions(*subcommand, options->surface);
  addSessionOptions(*subcommand, command.session);
  subcommand->callback(
      [options, &command] { command.action = [options](const Session& session) { return bake(*options, session); }; });
}

}  // namespace honeycomb::Cli
