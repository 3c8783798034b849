// honeycomb_demo: refines every frame of an animation on every evaluator, compares them bit for bit, prints one table
// and writes pictures.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "apps/demo/animation.h"
#include "apps/demo/contest.h"
#include "apps/demo/vulkan_part.h"
#include "far/base/stopwatch.h"
#include "far/schemes/akleman.h"
#include "far/tables/refinement.h"

namespace honeycomb::Demo {
namespace {

struct Options {
  std::filesystem::path mesh = std::filesystem::path(HONEYCOMB_ASSETS) / "creature.obj";
  std::filesystem::path cache = std::filesystem::path(HONEYCOMB_ASSETS) / "creature.pc2";
  std::filesystem::path output = "demo-pictures";
  std::int32_t levels = 4;
  std::int32_t frames = 0;  ///< 0: all
};

/// What the evaluators work on.
struct Subject {
  Animation animation;
  Far::Scheme scheme;
  Far::Topology control;
  Far::Refinement refinement;
  double buildTime = 0;  ///< ms of topology and tables
  std::int32_t frameCount = 0;
};

Result<Subject> load(const Options& options) {
  auto animation = loadAnimation(options.mesh, options.cache);
  if (!animation) return tl::unexpected(animation.error());
  auto scheme = Far::akleman();
  if (!scheme) return tl::unexpected(scheme.error());
  const Stopwatch watch;
  auto control = Far::Topology::create(animation->mesh.polygons);
  if (!control) {
    Error error = control.error();
    error.message = options.mesh.string() + ": " + error.message;
    return tl::unexpected(error);
  }
  auto refinement = Far::refine(*control, *scheme, options.levels);
  if (!refinement) return tl::unexpected(refinement.error());
  const double buildTime = watch.milliseconds();
  const std::int32_t all = animation->cache.info().frameCount;
  const std::int32_t frameCount = options.frames == 0 ? all : std::min(options.frames, all);
  return Subject{std::move(*animation),  std::move(*scheme), std::move(*control),
                 std::move(*refinement), buildTime,          frameCount};
}

void introduce(const Subject& subject) {
  const Far::Topology& last = subject.refinement.last().topology;
  std::cout << fmt::format("{}: {} faces, {} vertices, {} frames; level {}: {} faces, {} vertices\n",
                           subject.animation.name, subject.control.faceCount(), subject.control.vertexCount(),
                           subject.frameCount, subject.refinement.levelCount(), last.faceCount(), last.vertexCount());
}

Result<void> compete(const Subject& subject, const Result<VulkanPart>& vulkan) {
  std::vector<Contestant> contestants{serialContestant(subject.refinement), threadedContestant(subject.refinement)};
  auto tiled = tiledContestant(subject.refinement);
  if (!tiled) return tl::unexpected(tiled.error());
  contestants.push_back(std::move(*tiled));
  if (vulkan) {
    auto contestant = vulkan->contestant(subject.refinement);
    if (!contestant) return tl::unexpected(contestant.error());
    contestants.push_back(std::move(*contestant));
  }
  const auto standings = runContest(contestants, subject.animation, subject.frameCount, subject.buildTime);
  if (!standings) return tl::unexpected(standings.error());
  std::cout << '\n' << tableOf(*standings) << '\n' << std::flush;
  return {};
}

Result<void> paint(const Subject& subject, const Options& options, const VulkanPart& vulkan) {
  std::error_code failure;
  std::filesystem::create_directories(options.output, failure);
  if (failure) {
    return fail(ErrorCode::unwritable,
                fmt::format("{}: {}; give another folder with --output", options.output.string(), failure.message()));
  }
  const auto files = vulkan.paint(subject.animation, subject.control, subject.scheme,
                                  {options.output, options.levels, subject.frameCount});
  if (!files) return tl::unexpected(files.error());
  for (const auto& file : *files) std::cout << "wrote " << file.string() << '\n';
  return {};
}

Result<void> run(const Options& options) {
  const auto subject = load(options);
  if (!subject) return tl::unexpected(subject.error());
  introduce(*subject);
  const auto vulkan = VulkanPart::open();
  if (vulkan) {
    std::cout << "vulkan device: " << vulkan->deviceName() << '\n';
  } else {
    std::cout << "no vulkan evaluator and no pictures: " << vulkan.error().message << '\n';
  }
  if (auto competed = compete(*subject, vulkan); !competed) return competed;
  return vulkan ? paint(*subject, options, *vulkan) : Result<void>();
}

/// The program, with its exit status.
int start(int argumentCount, char** arguments) {
  Options options;
  CLI::App app("Refines every frame of an animation on every evaluator, compares them and draws pictures.",
               "honeycomb_demo");
  app.add_option("--mesh", options.mesh, "the control mesh, an OBJ file");
  app.add_option("--cache", options.cache, "how it moves, a PC2 file");
  app.add_option("--levels", options.levels, "steps of refinement")->check(CLI::Range(1, 8));
  app.add_option("--frames", options.frames, "how many frames, from the first (0: all)")->check(CLI::NonNegativeNumber);
  app.add_option("--output", options.output, "the folder for pictures");
  try {
    app.parse(argumentCount, arguments);
  } catch (const CLI::ParseError& wrong) {
    return app.exit(wrong) == 0 ? 0 : 2;
  }
  const Result<void> done = run(options);
  if (done) return 0;
  std::cerr << "error: " << done.error().message << '\n';
  return 1;
}

}  // namespace
}  // namespace honeycomb::Demo

int main(int argumentCount, char** arguments) {
  try {
    return honeycomb::Demo::start(argumentCount, arguments);
  } catch (const std::exception& failure) {
    std::cerr << "error: " << failure.what() << '\n';
    return 1;
  }
}
