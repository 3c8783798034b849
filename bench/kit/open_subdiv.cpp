#include "bench/kit/open_subdiv.h"

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/cpuEvaluator.h>
#include <opensubdiv/osd/ompEvaluator.h>

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>

#include "bench/kit/evaluators.h"
#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/base/stopwatch.h"
#include "osd/cpu_evaluator.h"
#include "osd/interop/stencil_tables.h"

namespace honeycomb::Bench {

namespace {

namespace Foreign = OpenSubdiv;

std::int64_t bytesOf(const ForeignTable& table) {
  // Sizes and offsets a stencil, an index and a weight an entry; the arrays may be longer, by what was reserved.
  const std::int64_t stencils = table.GetNumStencils();
  const std::int64_t entries = stencils == 0 ? 0 : table.GetOffsets().back() + table.GetSizes().back();
  return 4 * (2 * stencils + 2 * entries);
}

/// Stencils, and where the points they read and write are.
struct ForeignJob {
  std::shared_ptr<const ForeignTable> table;
  Osd::BufferDescriptor desc;
  std::span<const float> control;
  std::span<float> refined;
};

template <class Evaluator>
Result<void> evaluate(const ForeignJob& job) {
  const Foreign::Osd::BufferDescriptor desc(job.desc.offset, job.desc.length, job.desc.stride);
  const ForeignTable& table = *job.table;
  const bool done = Evaluator::EvalStencils(job.control.data(), desc, job.refined.data(), desc, table.GetSizes().data(),
                                            table.GetOffsets().data(), table.GetControlIndices().data(),
                                            table.GetWeights().data(), 0, table.GetNumStencils());
  if (!done) return fail(ErrorCode::unsupported, "OpenSubdiv's evaluator refuses the stencils");
  return {};
}

/// Errors: unsupported where the number of threads can't be set.
Result<void> setThreads() {
#ifdef _OPENMP
  omp_set_num_threads(Parallel::threadCount());
  return {};
#else
  return fail(ErrorCode::unsupported, "this build has no OpenMP to set the number of threads with");
#endif
}

Result<void> evaluateOnAll(const ForeignJob& job) {
  if (auto set = setThreads(); !set) return set;
  return evaluate<Foreign::Osd::OmpEvaluator>(job);
}

Result<Prepared> prepare(const Problem& problem, Result<void> (*evaluate)(const ForeignJob&)) {
  if (auto ok = withoutNormals(problem); !ok) return tl::unexpected(ok.error());
  const Result<const Far::StencilTable*> rows = problem.flat.get();
  if (!rows) return tl::unexpected(rows.error());
  const Stopwatch stopwatch;
  auto stencils = Osd::toOpenSubdiv(**rows);
  if (!stencils) return tl::unexpected(stencils.error());
  const ForeignJob job{std::move(*stencils), problem.layout.desc, problem.control, problem.refined};
  Prepared prepared;
  prepared.frame = [job, evaluate] { return evaluate(job); };
  prepared.refined = problem.refined;
  prepared.buildMs = problem.tablesMs + problem.flat.buildMs() + stopwatch.milliseconds();
  prepared.tableBytes = bytesOf(*job.table);
  prepared.vertices = problem.refinement.last().topology.vertexCount();
  return prepared;
}

/// A surface of its own: the points it reads, and those it makes where the problem's memory is too small for them.
struct CatmarkState {
  std::vector<float> control, refined;
};

std::vector<float> controlOf(const Mesh& mesh, const Layout& layout) {
  std::vector<float> control(at(layout.desc.extent(mesh.polygons.vertexCount)), 1.0F);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    control[i / 3 * at(layout.desc.stride) + i % 3] = static_cast<float>(mesh.points[i]);
  }
  return control;
}

/// The same stencils by our serial evaluator.
Result<std::vector<float>> expectedOf(const ForeignJob& job) {
  const Result<Far::LevelTable> table = Osd::fromOpenSubdiv(*job.table);
  if (!table) return tl::unexpected(table.error());
  std::vector<float> expected(job.refined.size());
  Osd::SerialEvaluator serial;
  const auto done = serial.evaluate<float>(*table, {job.control, job.desc}, {expected, job.desc});
  if (!done) return tl::unexpected(done.error());
  return expected;
}

}  // namespace

Refiner catmarkRefiner(const Far::Polygons& polygons) {
  std::vector<int> sides;
  for (std::int64_t f = 0; f < polygons.faceCount(); ++f) {
    sides.push_back(static_cast<int>(polygons.faceOffsets[at(f) + 1] - polygons.faceOffsets[at(f)]));
  }
  Foreign::Far::TopologyDescriptor descriptor;
  descriptor.numVertices = polygons.vertexCount;
  descriptor.numFaces = static_cast<int>(polygons.faceCount());
  descriptor.numVertsPerFace = sides.data();
  descriptor.vertIndicesPerFace = polygons.indices.data();
  using Factory = Foreign::Far::TopologyRefinerFactory<Foreign::Far::TopologyDescriptor>;
  return Refiner(Factory::Create(descriptor, Factory::Options(Foreign::Sdc::SCHEME_CATMARK)));
}

Stencils catmarkStencils(const Foreign::Far::TopologyRefiner& refiner, std::int32_t level) {
  using Factory = Foreign::Far::StencilTableFactoryReal<float>;
  Factory::Options options;
  options.generateIntermediateLevels = false;
  options.generateOffsets = true;
  options.maxLevel = static_cast<unsigned>(level) & 15U;  // a field of four bits
  return Stencils(Factory::Create(refiner, options));
}

Mesh catmarkMesh(std::int64_t refinedVertices, std::int32_t level) {
  return torus(std::max(kFewestFaces, refinedVertices >> (2 * level)));
}

Result<Prepared> prepareOpenSubdivCpu(const Problem& problem) {
  return prepare(problem, evaluate<Foreign::Osd::CpuEvaluator>);
}

Result<Prepared> prepareOpenSubdivOmp(const Problem& problem) {
  if (auto set = setThreads(); !set) return tl::unexpected(set.error());
  Result<Prepared> prepared = prepare(problem, evaluateOnAll);
  if (prepared) prepared->spins = true;
  return prepared;
}

Result<Prepared> prepareOpenSubdivCatmark(const Problem& problem) {
  if (auto set = setThreads(); !set) return tl::unexpected(set.error());
  if (auto ok = withoutNormals(problem); !ok) return tl::unexpected(ok.error());
  const std::int32_t level = problem.refinement.levelCount();
  const Mesh mesh = catmarkMesh(problem.refinement.last().topology.vertexCount(), level);
  const Stopwatch stopwatch;
  const Refiner refiner = catmarkRefiner(mesh.polygons);
  if (!refiner) return fail(ErrorCode::unsupported, "OpenSubdiv refuses the mesh");
  refiner->RefineUniform(Foreign::Far::TopologyRefiner::UniformOptions(level));
  ForeignJob job{catmarkStencils(*refiner, level), problem.layout.desc, {}, {}};
  Prepared prepared;
  prepared.buildMs = stopwatch.milliseconds();
  prepared.vertices = job.table->GetNumStencils();
  prepared.tableBytes = bytesOf(*job.table);
  const auto state = std::make_shared<CatmarkState>();
  state->control = controlOf(mesh, problem.layout);
  const std::size_t size = at(problem.layout.desc.extent(prepared.vertices));
  if (size > problem.refined.size()) state->refined.resize(size);
  job.control = state->control;
  job.refined = state->refined.empty() ? problem.refined.first(size) : state->refined;
  auto expected = expectedOf(job);
  if (!expected) return tl::unexpected(expected.error());
  prepared.expected = std::move(*expected);
  prepared.frame = [job, state] { return evaluateOnAll(job); };
  prepared.refined = job.refined;
  prepared.spins = true;
  return prepared;
}

}  // namespace honeycomb::Bench
