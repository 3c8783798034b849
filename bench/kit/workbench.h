#pragma once

#include <cstdint>
#include <span>

#include "bench/kit/aligned_floats.h"
#include "bench/kit/evaluators.h"

namespace honeycomb::Bench {

/// A refinement and how it is to be evaluated.
struct Task {
  const Far::Refinement& refinement;
  std::span<const double> points;  ///< x y z per control vertex
  double tablesMs = 0;             ///< what the refinement took to build
  std::int64_t memory = 0;         ///< bytes that a flattened table may take
  Layout layout;
  Normals normals = Normals::none;
};

/// The memory that all evaluators of a task share, and the problem they are given. Stays in place: the problem points
/// into it.
class Workbench {
 public:
  explicit Workbench(const Task& task);
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  const Problem& problem() const { return problem_; }
  /// All of the memory for refined points: a whole number of cache lines.
  std::span<float> output() const { return refined_.all(); }

 private:
  AlignedFloats control_, refined_, normals_;
  FlatTable flat_;
  Problem problem_;
};

}  // namespace honeycomb::Bench
