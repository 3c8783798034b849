// Building tables and refining one frame: a torus of 10,000 quads, Akleman-Srinivasan, levels 2 to 5.
// Every frame benchmark reports time per final-level vertex (intermediate levels included) as per_vertex.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "far/schemes/akleman.h"
#include "far/tables/refinement.h"
#include "osd/cpu_evaluator.h"
#ifdef HONEYCOMB_VULKAN
#include "osd/vulkan/context.h"
#include "osd/vulkan/session.h"
#endif

namespace {

using namespace honeycomb;

constexpr std::int32_t kRings = 100;
constexpr std::int32_t kSectors = 100;

Far::Polygons torusPolygons() {
  Far::Polygons polygons;
  polygons.vertexCount = kRings * kSectors;
  const auto vertex = [](std::int32_t i, std::int32_t j) { return (i % kRings) * kSectors + j % kSectors; };
  for (std::int32_t i = 0; i < kRings; ++i) {
    for (std::int32_t j = 0; j < kSectors; ++j) {
      polygons.addFace({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)});
    }
  }
  return polygons;
}

std::vector<float> torusPoints() {
  std::vector<float> points;
  points.reserve(3 * kRings * kSectors);
  for (std::int32_t i = 0; i < kRings; ++i) {
    for (std::int32_t j = 0; j < kSectors; ++j) {
      const double a = 2 * std::numbers::pi * i / kRings;
      const double b = 2 * std::numbers::pi * j / kSectors;
      const double radius = 2 + std::cos(b);
      for (const double x : {radius * std::cos(a), std::sin(b), radius * std::sin(a)}) {
        points.push_back(static_cast<float>(x));
      }
    }
  }
  return points;
}

Far::Refinement torusRefinement(std::int32_t levels) {
  const auto topology = Far::Topology::create(torusPolygons());
  return *Far::refine(*topology, *Far::akleman(), levels);
}

void perVertex(benchmark::State& state, std::int64_t vertices) {
  using benchmark::Counter;
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["ns_per_vertex"] =
      Counter(static_cast<double>(vertices) * 1e-9, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void BM_Topology(benchmark::State& state) {
  const Far::Polygons polygons = torusPolygons();
  for (auto _ : state) benchmark::DoNotOptimize(Far::Topology::create(polygons));
  perVertex(state, polygons.vertexCount);
}

void BM_Tables(benchmark::State& state) {
  const auto topology = Far::Topology::create(torusPolygons());
  const auto scheme = Far::akleman();
  std::int64_t vertices = 0;
  for (auto _ : state) {
    const auto refinement = Far::refine(*topology, *scheme, static_cast<std::int32_t>(state.range(0)));
    vertices = refinement->last().topology.vertexCount();
  }
  perVertex(state, vertices);
}

template <class Evaluator>
void BM_Frame(benchmark::State& state) {
  const auto levels = static_cast<std::int32_t>(state.range(0));
  const Far::Refinement refinement = torusRefinement(levels);
  const std::vector<float> control = torusPoints();
  const std::int64_t vertices = refinement.last().topology.vertexCount();
  std::vector<float> refined(3 * static_cast<std::size_t>(refinement.last().pointCount()));
  Evaluator evaluator;
  for (auto _ : state) {
    (void)evaluator.template evaluate<float>(refinement, levels, {control, {}}, {refined, {}});
    benchmark::ClobberMemory();
  }
  perVertex(state, vertices);
}

#ifdef HONEYCOMB_VULKAN
void BM_FrameVulkan(benchmark::State& state) {
  auto context = Osd::VulkanContext::create();
  if (!context) return state.SkipWithError(context.error().message.c_str());
  auto evaluator = Osd::VulkanEvaluator::create(context->device());
  if (!evaluator) return state.SkipWithError(evaluator.error().message.c_str());
  const Far::Refinement refinement = torusRefinement(static_cast<std::int32_t>(state.range(0)));
  auto session = Osd::VulkanSession::create(*evaluator, refinement);
  if (!session) return state.SkipWithError(session.error().message.c_str());
  const std::vector<float> control = torusPoints();
  std::copy(control.begin(), control.end(), session->control().begin());
  for (auto _ : state) {
    if (auto run = session->run(); !run) return state.SkipWithError(run.error().message.c_str());
  }
  perVertex(state, refinement.last().topology.vertexCount());
}
BENCHMARK(BM_FrameVulkan)->DenseRange(2, 5)->Unit(benchmark::kMillisecond)->UseRealTime();
#endif

BENCHMARK(BM_Topology)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_Tables)->DenseRange(2, 5)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_Frame<Osd::SerialEvaluator>)->DenseRange(2, 5)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_Frame<Osd::TbbEvaluator>)->DenseRange(2, 5)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
