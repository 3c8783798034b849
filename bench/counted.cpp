// What bench/counts runs under callgrind: one kernel, one frame, everything else uncounted.
//   honeycomb_counted EVALUATOR SCHEME LEVELS FACES [fast|exact]
//                                                       a frame of one of bench/kit's evaluators, four numbers a point,
//                                                       with normals of that kind
//   honeycomb_counted topology|tables|flattened ...     what is built once per mesh
// Prints the number of refined vertices that the counted instructions made. Without an evaluator's tables or device it
// prints why and exits 3.

#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/kit/building_steps.h"
#include "bench/kit/meshes.h"
#include "bench/kit/workbench.h"
#include "far/base/parallel.h"
#include "far/schemes/akleman.h"
#include "far/schemes/half_box.h"
#include "far/schemes/midpoint.h"

using namespace honeycomb;

/// callgrind counts what happens inside this function (--toggle-collect).
extern "C" [[gnu::noinline]] bool honeycombCounted(const std::function<Result<void>()>& frame) {
  return frame().has_value();
}

namespace {

constexpr int kAbsent = 3, kWrong = 2;
constexpr std::int64_t kFlatBytes = 2'000'000'000;

struct Job {
  std::string_view kernel;
  std::vector<Far::Scheme> steps;
  const Bench::Mesh& mesh;
  const Far::Topology& control;
  Bench::Normals normals;
};

int counted(const Bench::Prepared& prepared) {
  // The first frame allocates what is kept between frames.
  if (!prepared.frame() || !honeycombCounted(prepared.frame)) return kWrong;
  std::printf("%lld\n", static_cast<long long>(prepared.vertices));
  return 0;
}

int absent(std::string_view why) {
  std::printf("%.*s\n", static_cast<int>(why.size()), why.data());
  return kAbsent;
}

int countBuilding(const Job& job) {
  const auto steps = Bench::buildSteps({job.mesh.polygons, job.control, job.steps, kFlatBytes, {}});
  if (!steps) return absent(steps.error().message);
  for (const Bench::BuildStep& step : *steps) {
    if (step.time.library != "honeycomb" || step.time.what != job.kernel) continue;
    Bench::Prepared prepared = step.build;
    prepared.vertices = step.time.vertices;
    return counted(prepared);
  }
  return absent("there is no such kernel");
}

int count(const Job& job) {
  for (const Bench::EvaluatorEntry& entry : Bench::evaluators()) {
    if (entry.name != job.kernel) continue;
    const bool limits = job.normals == Bench::Normals::exact;
    const Result<Far::Refinement> refinement = Far::refine(job.control, job.steps, {.limits = limits});
    if (!refinement) return absent(refinement.error().message);
    const Bench::Workbench workbench(
        {*refinement, job.mesh.points, 0, kFlatBytes, Bench::layouts().back(), job.normals});
    const Result<Bench::Prepared> prepared = entry.prepare(workbench.problem());
    return prepared ? counted(*prepared) : absent(prepared.error().message);
  }
  return countBuilding(job);
}

Bench::Normals normalsOf(std::string_view name) {
  if (name == "fast") return Bench::Normals::fast;
  return name == "exact" ? Bench::Normals::exact : Bench::Normals::none;
}

/// Circulants alone; circulants and dense rows of four; dense rows of two alone. None for another name.
std::vector<Far::Scheme> stepsOf(std::string_view scheme, const Far::Topology& control, std::int32_t levels) {
  if (scheme == "akleman") return {static_cast<std::size_t>(levels), *Far::akleman()};
  if (scheme == "half-box") return *Far::halfBox(control, levels);
  if (scheme == "midpoint") return {static_cast<std::size_t>(levels), Far::midpoint()};
  return {};
}

}  // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount < 5 || argumentCount > 6)
    return absent("usage: honeycomb_counted KERNEL SCHEME LEVELS FACES [fast|exact]");
  const Bench::Normals normals = normalsOf(argumentCount == 6 ? arguments[5] : "none");
  // callgrind runs one thread at a time.
  const Parallel::ThreadLimit limit(1);
  const Bench::Mesh mesh = Bench::torus(std::stoll(arguments[4]));
  const Far::Topology control = *Far::Topology::create(mesh.polygons);
  const auto steps = stepsOf(arguments[2], control, std::stoi(arguments[3]));
  return steps.empty() ? absent("there is no such scheme") : count({arguments[1], steps, mesh, control, normals});
}
