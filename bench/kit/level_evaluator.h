#pragma once

#include <memory>
#include <type_traits>

#include "bench/kit/evaluators.h"

namespace honeycomb::Bench {

/// Bytes of the tables of all levels.
inline std::int64_t levelTableBytes(const Far::Refinement& refinement) {
  std::int64_t bytes = 0;
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) bytes += refinement.level(k).table.byteCount();
  return bytes;
}

/// Level after level by one of Osd's evaluators on the CPU; exact normals in a second pass.
template <class Evaluator>
Result<Prepared> prepareLevels(const Problem& problem) {
  if (problem.normals == Normals::fast) {
    const bool alone = std::is_same_v<Evaluator, Osd::SerialEvaluator>;
    return prepareFastNormals(problem, alone ? Osd::CpuEvaluator::Threads::one : Osd::CpuEvaluator::Threads::all);
  }
  const auto evaluator = std::make_shared<Evaluator>();
  Prepared prepared;
  prepared.frame = [evaluator, problem]() -> Result<void> {
    const Far::Refinement& refinement = problem.refinement;
    const Osd::BufferDescriptor& desc = problem.layout.desc;
    const Result<void> done = evaluator->template evaluate<float>(refinement, refinement.levelCount(),
                                                                  {problem.control, desc}, {problem.refined, desc});
    if (!done || problem.normals == Normals::none) return done;
    return evaluator->template vertexLimits<float>(refinement.limits(), {problem.refined, {0, 3, desc.stride}}, {},
                                                   {problem.vertexNormals, {}});
  };
  prepared.refined = problem.refined;
  prepared.normals = problem.vertexNormals;
  prepared.buildMs = problem.tablesMs;
  prepared.tableBytes = levelTableBytes(problem.refinement);
  if (problem.normals == Normals::exact) prepared.tableBytes += problem.refinement.limits().byteCount();
  prepared.vertices = problem.refinement.last().topology.vertexCount();
  return prepared;
}

}  // namespace honeycomb::Bench
