#pragma once

#include <cstdint>
#include <vector>

#include "far/base/result.h"
#include "far/tables/level_tables.h"
#include "far/tables/tile_table.h"
#include "osd/buffer_descriptor.h"
#include "osd/cpu_evaluator.h"
#include "osd/piece.h"

namespace honeycomb::Osd {

/// What all tiles read, evaluated before them: the root level, the points too large for a tile; and the normals of
/// these.
template <class Real>
class TileShared {
 public:
  /// Up to level `level`; the points that no tile writes go to `refined` and their normals to `normals`, unless that
  /// is empty.
  Result<void> evaluate(CpuEvaluator& evaluator, Far::LevelTables levels, const Far::TileTable& tiles,
                        std::int32_t level, const Points<Real>& control, const PointsOut<Real>& refined,
                        const PointsOut<Real>& normals);

  const Points<Real>& root() const { return root_; }
  const std::vector<Real>& points() const { return shared_; }
  const std::vector<Real>& normals() const { return normals_; }

 private:
  Result<void> evaluateRoot(CpuEvaluator& evaluator, Far::LevelTables levels, const Far::TileTable& tiles,
                            bool normals);
  Result<void> evaluateSets(CpuEvaluator& evaluator, const Far::TileTable& tiles, std::int32_t level, std::int32_t last,
                            const PointsOut<Real>& refined);
  static void findNormals(const Far::LimitRows& rows, const Points<Real>& points, const View<Real>& normals);
  void writeNormals(const Far::TileTable& tiles, const PointsOut<Real>& normals) const;

  Points<Real> root_;
  std::vector<Real> levels_[2];
  std::vector<Real> shared_;
  std::vector<Real> normals_;
};

}  // namespace honeycomb::Osd
