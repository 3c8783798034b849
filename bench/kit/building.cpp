#include "bench/kit/building.h"

#include <memory>

#include "bench/kit/building_steps.h"
#include "far/tables/refinement.h"
#include "far/tables/stencil_table.h"
#include "far/tables/tile_table.h"

namespace honeycomb::Bench {

namespace {

/// Each level's connectivity, that before it kept as a refinement keeps it.
Result<std::vector<Far::Topology>> refineTopology(const Building& building) {
  std::vector<Far::Topology> levels;
  levels.reserve(building.steps.size());
  const Far::Topology* parent = &building.control;
  for (const Far::Scheme& step : building.steps) {
    Result<Far::SplitResult> child = step.split.apply(*parent);
    if (!child) return tl::unexpected(child.error());
    levels.push_back(std::move(child->topology));
    parent = &levels.back();
  }
  return levels;
}

/// The same, the links of each level found.
Result<std::vector<Far::Topology>> refineFullTopology(const Building& building) {
  Result<std::vector<Far::Topology>> levels = refineTopology(building);
  if (!levels) return levels;
  for (const Far::Topology& level : *levels) (void)level.twin();
  return levels;
}

std::int64_t byteCount(const std::vector<Far::Topology>& levels) {
  std::int64_t bytes = 0;
  for (const Far::Topology& level : levels) bytes += level.byteCount();
  return bytes;
}

template <class Value>
Result<void> outcome(const Result<Value>& result) {
  if (!result) return tl::unexpected(result.error());
  return {};
}

BuildStep step(std::string_view what, std::int64_t vertices, std::int64_t bytes, std::function<Result<void>()> build) {
  BuildStep made{{"honeycomb", what, {}, vertices, bytes}, {}};
  made.build.frame = std::move(build);
  return made;
}

}  // namespace

Result<std::vector<BuildStep>> buildSteps(const Building& building) {
  Result<Far::Refinement> refined = Far::refine(building.control, building.steps);
  if (!refined) return tl::unexpected(refined.error());
  const auto refinement = std::make_shared<const Far::Refinement>(std::move(*refined));
  const std::int64_t vertices = refinement->last().topology.vertexCount();
  const Result<std::vector<Far::Topology>> lean = refineTopology(building);
  const Result<std::vector<Far::Topology>> full = refineFullTopology(building);
  if (!lean) return tl::unexpected(lean.error());
  if (!full) return tl::unexpected(full.error());
  std::vector<BuildStep> steps;
  steps.push_back(step("control", vertices, building.control.byteCount(),
                       [building] { return outcome(Far::Topology::create(building.polygons)); }));
  steps.push_back(
      step("topology", vertices, byteCount(*lean), [building] { return outcome(refineTopology(building)); }));
  steps.push_back(
      step("full-topology", vertices, byteCount(*full), [building] { return outcome(refineFullTopology(building)); }));
  steps.push_back(step("tables", vertices, refinement->byteCount(),
                       [building] { return outcome(Far::refine(building.control, building.steps)); }));
  if (const auto tiles = Far::buildTileTable(*refinement)) {
    steps.push_back(step("tiles", vertices, tiles->byteCount(),
                         [refinement] { return outcome(Far::buildTileTable(*refinement)); }));
  }
  Far::StencilOptions options;
  options.memoryLimit = building.memory;
  if (const auto flat = Far::StencilTable::build(*refinement, options)) {
    steps.push_back(step("flattened", vertices, flat->byteCount(),
                         [refinement, options] { return outcome(Far::StencilTable::build(*refinement, options)); }));
  }
  return steps;
}

Result<std::vector<BuildTime>> measureBuilding(const Building& building) {
  Result<std::vector<BuildStep>> steps = buildSteps(building);
  if (!steps) return tl::unexpected(steps.error());
#ifdef HONEYCOMB_BENCH_OPENSUBDIV
  addOpenSubdivSteps(steps->front().time.vertices, static_cast<std::int32_t>(building.steps.size()), *steps);
#endif
  std::vector<const Prepared*> all;
  for (const BuildStep& each : *steps) all.push_back(&each.build);
  const Result<std::vector<Timing>> timings = sampleInTurns(all, building.sampling);
  if (!timings) return tl::unexpected(timings.error());
  std::vector<BuildTime> times;
  for (std::size_t i = 0; i < steps->size(); ++i) {
    BuildTime time = (*steps)[i].time;
    time.nsPerVertex = 1e6 / static_cast<double>(time.vertices) * spreadOf((*timings)[i].frameMs);
    times.push_back(time);
  }
  return times;
}

}  // namespace honeycomb::Bench
