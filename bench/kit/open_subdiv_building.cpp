#include "bench/kit/building_steps.h"
#include "bench/kit/open_subdiv.h"

namespace honeycomb::Bench {

namespace {

using Uniform = OpenSubdiv::Far::TopologyRefiner::UniformOptions;

/// The polygons, and a refiner whose levels may be made anew.
struct Source {
  Mesh mesh;
  Refiner refiner;
};

}  // namespace

void addOpenSubdivSteps(std::int64_t vertices, std::int32_t level, std::vector<BuildStep>& steps) {
  const auto source = std::make_shared<Source>(Source{catmarkMesh(vertices, level), {}});
  source->refiner = catmarkRefiner(source->mesh.polygons);
  if (!source->refiner) return;
  source->refiner->RefineUniform(Uniform(level));
  const Stencils stencils = catmarkStencils(*source->refiner, level);
  const std::int64_t refined = stencils->GetNumStencils();
  const auto bytes =
      static_cast<std::int64_t>(stencils->GetControlIndices().size() * 8 + stencils->GetSizes().size() * 8);
  const auto add = [&](std::string_view what, std::int64_t size, const std::function<void()>& build) {
    BuildStep step{{"opensubdiv", what, {}, refined, size}, {}};
    step.build.frame = [build]() -> Result<void> {
      build();
      return {};
    };
    steps.push_back(std::move(step));
  };
  add("control", 0, [source] { (void)catmarkRefiner(source->mesh.polygons); });
  const auto addTopology = [&](std::string_view what, bool full) {
    Uniform options(level);
    options.fullTopologyInLastLevel = full;
    add(what, 0, [source, options] {
      source->refiner->Unrefine();
      source->refiner->RefineUniform(options);
    });
  };
  addTopology("full-topology", true);
  addTopology("topology", false);  // the last: stencils are made of what it leaves
  add("stencils", bytes, [source, level] { (void)catmarkStencils(*source->refiner, level); });
}

}  // namespace honeycomb::Bench
