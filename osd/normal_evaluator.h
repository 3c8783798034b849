#pragma once

#include <cstdint>
#include <vector>

#include "far/base/result.h"
#include "far/tables/level_tables.h"
#include "far/tables/normal_rule.h"
#include "osd/buffer_descriptor.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Osd {

/// Points and fast normals level after level: the reference of those that tiles give, which are several times faster.
/// One evaluator belongs to one thread at a time.
class NormalEvaluator {
 public:
  explicit NormalEvaluator(CpuEvaluator::Threads threads)
      : threads_(threads), levels_(threads, CpuEvaluator::Instructions::plain) {}

  /// From the control points (length 3 or 4) to the points and unit normals (length 3) of level table.level; a zero
  /// vector where there is no direction. Errors: buffers too small, other lengths.
  template <class Real>
  Result<void> evaluate(Far::LevelTables levels, const Far::NormalTable& table, const Points<Real>& control,
                        const PointsOut<Real>& refined, const PointsOut<Real>& normals);

 private:
  CpuEvaluator::Threads threads_;
  CpuEvaluator levels_;
};

}  // namespace honeycomb::Osd
