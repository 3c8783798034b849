// Google benchmarks of what `honeycomb bench` compares: building tables, and refining one frame by every evaluator of
// bench/kit. A torus of 10,000 quads, Akleman-Srinivasan, levels 2 to 5. Every benchmark reports time per final-level
// vertex (intermediate levels included) as time_per_vertex; evaluators that aren't there are reported as skipped.

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "bench/kit/meshes.h"
#include "bench/kit/workbench.h"
#include "far/schemes/akleman.h"
#include "far/tables/refinement.h"
#include "far/tables/stencil_table.h"

namespace {

using namespace honeycomb;

constexpr std::int64_t kFaces = 10'000;
constexpr std::int64_t kFirstLevel = 2, kLastLevel = 5;
constexpr std::int64_t kFlatBytes = 4'000'000'000;

Far::Topology torusTopology() {
  return *Far::Topology::create(Bench::torus(kFaces).polygons);
}

void perVertex(benchmark::State& state, std::int64_t vertices) {
  using benchmark::Counter;
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["time_per_vertex"] =
      Counter(static_cast<double>(vertices), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void BM_Topology(benchmark::State& state) {
  const Bench::Mesh mesh = Bench::torus(kFaces);
  while (state.KeepRunning()) benchmark::DoNotOptimize(Far::Topology::create(mesh.polygons));
  perVertex(state, mesh.polygons.vertexCount);
}

void BM_Tables(benchmark::State& state) {
  const Far::Topology topology = torusTopology();
  const auto scheme = Far::akleman();
  std::int64_t vertices = 0;
  while (state.KeepRunning()) {
    const auto refinement = Far::refine(topology, *scheme, static_cast<std::int32_t>(state.range(0)));
    vertices = refinement->last().topology.vertexCount();
  }
  perVertex(state, vertices);
}

void BM_Flattened(benchmark::State& state) {
  const auto refinement = Far::refine(torusTopology(), *Far::akleman(), static_cast<std::int32_t>(state.range(0)));
  while (state.KeepRunning()) benchmark::DoNotOptimize(Far::StencilTable::build(*refinement));
  perVertex(state, refinement->last().topology.vertexCount());
}

void BM_Frame(benchmark::State& state, const Bench::EvaluatorEntry& entry, const Bench::Layout& layout) {
  const Bench::Mesh mesh = Bench::torus(kFaces);
  const auto refinement = Far::refine(torusTopology(), *Far::akleman(), static_cast<std::int32_t>(state.range(0)));
  const Bench::Workbench workbench({*refinement, mesh.points, 0, kFlatBytes, layout, Bench::Normals::none});
  const Result<Bench::Prepared> prepared = entry.prepare(workbench.problem());
  if (!prepared) return state.SkipWithError(prepared.error().message.c_str());
  while (state.KeepRunning()) {
    if (auto done = prepared->frame(); !done) return state.SkipWithError(done.error().message.c_str());
    benchmark::ClobberMemory();
  }
  perVertex(state, prepared->vertices);
}

void registerFrames() {
#ifndef __clang_analyzer__  // which takes the library's list of benchmarks for a leak
  for (const Bench::Layout& layout : Bench::layouts()) {
    for (const Bench::EvaluatorEntry& entry : Bench::evaluators()) {
      const std::string name = "BM_Frame/" + std::string(entry.name) + "/" + std::string(layout.name);
      benchmark::RegisterBenchmark(name.c_str(), [&](benchmark::State& state) { BM_Frame(state, entry, layout); })
          ->DenseRange(kFirstLevel, kLastLevel)
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    }
  }
#endif
}

BENCHMARK(BM_Topology)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_Tables)->DenseRange(kFirstLevel, kLastLevel)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_Flattened)->DenseRange(kFirstLevel, kLastLevel - 1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int argumentCount, char** arguments) {
  registerFrames();
  benchmark::Initialize(&argumentCount, arguments);
  if (benchmark::ReportUnrecognizedArguments(argumentCount, arguments)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
