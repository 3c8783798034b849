#pragma once

#include <memory>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/tables/level_tables.h"
#include "far/tables/stencil_table.h"
#include "osd/buffer_descriptor.h"

namespace honeycomb::Osd {

/// Applies tables on the CPU. One evaluator belongs to one thread at a time; it keeps the points of the levels in
/// between from frame to frame, so that nothing is allocated once it is warm. Tables are only read and may be shared.
///
/// All evaluators give the same bits for the same table and input: the order of operations is written down with the
/// batches (far/tables/level_table.h).
class CpuEvaluator {
 public:
  /// How many threads an evaluation may take.
  enum class Threads { one, all };
  /// Which kernels it takes.
  enum class Instructions { plain, vectors };  ///< vectors: single precision only; double is plain in either
  CpuEvaluator(Threads threads, Instructions instructions) : threads_(threads), instructions_(instructions) {}

  /// One level: reads table.sourceCount points, writes table.targetCount. Source and target must not overlap.
  template <class Real>
  Result<void> evaluate(const Far::LevelTable& table, const Points<Real>& source, const PointsOut<Real>& target);

  /// From the control points to level `level` (1..levelCount) of a refinement.
  template <class Real>
  Result<void> evaluate(Far::LevelTables levels, std::int32_t level, const Points<Real>& control,
                        const PointsOut<Real>& refined);

  /// Limit positions (length 3) and unit normals (length 3) of all vertices of the level the limits were built for,
  /// from that level's points (length 3). Either output may be empty (data.empty()).
  template <class Real>
  Result<void> vertexLimits(const Far::LimitTable& limits, const Points<Real>& points, const PointsOut<Real>& positions,
                            const PointsOut<Real>& normals);

  /// The same of all faces.
  template <class Real>
  Result<void> faceLimits(const Far::LimitTable& limits, const Points<Real>& points, const PointsOut<Real>& positions,
                          const PointsOut<Real>& normals);

  /// Point r of the target from row r of a stencil table; limits have three arrays of weights to choose from. The same
  /// bits as table.asLevelTable(). Errors also: invalidOption for tangents of a table without.
  template <class Real>
  Result<void> evaluate(const Far::StencilTable& table, const Points<Real>& control, const PointsOut<Real>& target,
                        Far::StencilWeights which = Far::StencilWeights::position);

 private:
  template <class Real>
  std::vector<Real>& scratch(std::int32_t which);

  Threads threads_;
  Instructions instructions_;
  std::vector<float> single_[2];
  std::vector<double> double_[2];
};

/// The reference: one thread, plain loops.
class SerialEvaluator : public CpuEvaluator {
 public:
  SerialEvaluator() : CpuEvaluator(Threads::one, Instructions::plain) {}
};

/// One thread, in single precision by the best vector instructions that the CPU has when the program runs.
class SimdEvaluator : public CpuEvaluator {
 public:
  SimdEvaluator() : CpuEvaluator(Threads::one, Instructions::vectors) {}
};

/// What SimdEvaluator does, over ranges of faces and rows on all threads of the caller's oneTBB arena.
class TbbEvaluator : public CpuEvaluator {
 public:
  TbbEvaluator() : CpuEvaluator(Threads::all, Instructions::vectors) {}
};

}  // namespace honeycomb::Osd
