#include <memory>

#include "bench/kit/evaluators.h"
#include "bench/kit/level_evaluator.h"
#include "far/base/bytes.h"
#include "far/base/stopwatch.h"
#include "far/tables/normal_rule.h"
#include "far/tables/tile_table.h"
#include "osd/normal_evaluator.h"
#include "osd/tile_evaluator.h"
#include "osd/tile_size.h"

namespace honeycomb::Bench {

namespace {

Result<Prepared> prepareTiles(const Problem& problem, Osd::CpuEvaluator::Threads threads,
                              Far::TileOrder order = Far::TileOrder::levels) {
  const Stopwatch stopwatch;
  Far::TileOptions options = Osd::cpuTileOptions(tileNormals(problem.normals));
  options.order = order;
  Result<Far::TileTable> built = Far::buildTileTable(problem.refinement, options);
  if (!built) return tl::unexpected(built.error());
  Prepared prepared;
  prepared.buildMs = problem.tablesMs + stopwatch.milliseconds();
  const auto tiles = std::make_shared<const Far::TileTable>(std::move(*built));
  const auto evaluator = std::make_shared<Osd::TileEvaluator>(Osd::TileEvaluatorOptions{threads});
  prepared.frame = [evaluator, tiles, problem] {
    const Osd::BufferDescriptor& desc = problem.layout.desc;
    Osd::TileRequest<float> request;
    if (problem.normals != Normals::none) request.normals = {problem.vertexNormals, {}};
    return evaluator->evaluate<float>(problem.refinement, *tiles, tiles->lastLevel, {problem.control, desc},
                                      {problem.refined, desc}, request);
  };
  prepared.refined = problem.refined;
  prepared.normals = problem.vertexNormals;
  prepared.order.assign(tiles->written.begin(), tiles->written.end());
  prepared.tableBytes = tiles->byteCount() - bytes(tiles->written);  // no frame reads that
  prepared.vertices = problem.refinement.last().topology.vertexCount();
  return prepared;
}

}  // namespace

Result<Prepared> prepareSimdTiled(const Problem& problem) {
  return prepareTiles(problem, Osd::CpuEvaluator::Threads::one);
}

Result<Prepared> prepareTbbTiled(const Problem& problem) {
  return prepareTiles(problem, Osd::CpuEvaluator::Threads::all);
}

Result<Prepared> prepareTbbTileOrder(const Problem& problem) {
  return prepareTiles(problem, Osd::CpuEvaluator::Threads::all, Far::TileOrder::tiles);
}

Result<Prepared> prepareFastNormals(const Problem& problem, Osd::CpuEvaluator::Threads threads) {
  Result<Far::NormalTable> built = Far::buildNormalTable(problem.refinement, problem.refinement.levelCount());
  if (!built) return tl::unexpected(built.error());
  const auto table = std::make_shared<const Far::NormalTable>(std::move(*built));
  const auto evaluator = std::make_shared<Osd::NormalEvaluator>(threads);
  Prepared prepared;
  prepared.frame = [evaluator, table, problem] {
    const Osd::BufferDescriptor& desc = problem.layout.desc;
    return evaluator->evaluate<float>(problem.refinement, *table, {problem.control, desc}, {problem.refined, desc},
                                      {problem.vertexNormals, {}});
  };
  prepared.refined = problem.refined;
  prepared.normals = problem.vertexNormals;
  prepared.buildMs = problem.tablesMs;
  prepared.tableBytes = levelTableBytes(problem.refinement) + table->byteCount();
  prepared.vertices = problem.refinement.last().topology.vertexCount();
  return prepared;
}

}  // namespace honeycomb::Bench
