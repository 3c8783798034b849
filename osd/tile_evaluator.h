#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/tables/level_tables.h"
#include "far/tables/tile_table.h"
#include "osd/buffer_descriptor.h"
#include "osd/cpu_evaluator.h"
#include "osd/tile_shared.h"
#include "osd/tile_size.h"

namespace honeycomb::Osd {

/// What a TileEvaluator computes with.
struct TileEvaluatorOptions {
  CpuEvaluator::Threads threads = CpuEvaluator::Threads::all;
  CpuEvaluator::Instructions instructions = CpuEvaluator::Instructions::vectors;
  /// Points of this many bytes go past the caches, and so do normals: read for ownership first they would cost memory
  /// twice. Measured: from 20 MB on two to four times the bytes a second, below 4 MB half of them; at 17 to 20 MB
  /// beside a cache of 32 MB a fifth to a quarter more time.
  std::int64_t streamedBytes = Osd::streamedBytes();
  /// Both do where they take this many bytes together. Measured for 13 MB each: in a cache of 32 MB a third less time
  /// that way, in one of 100 MB a fifth more.
  std::int64_t cachedBytes = Osd::cachedBytes();
};

/// What else is wanted of an evaluation.
template <class Real>
struct TileRequest {
  /// Unit normals of the last level's points (length 3), of the kind that the tiles were built with; the zero vector
  /// of points that are not vertices. Empty: none.
  PointsOut<Real> normals = {};
  /// Ascending numbers of tiles: the points of these and those that no tile writes, at their cost; others are left
  /// untouched. Levels up to the tiles' root level are written whole. Exact normals of vertices that read too many
  /// points for a tile (kMostTileEntries) are written with any choice. None: all.
  std::optional<std::span<const std::int32_t>> only = {};
};

/// Evaluates refinements tile by tile: the bits of the evaluators that go level after level, several times as fast.
/// Threads of the caller's oneTBB arena take tiles as they come free, each those that it had the frame before if it
/// can. One evaluator belongs to one thread at a time; tables are only read and may be shared.
class TileEvaluator {
 public:
  explicit TileEvaluator(const TileEvaluatorOptions& options = {})
      : options_(options), chained_(options.threads, options.instructions) {}

  /// From the control points to level `level` (1 .. tiles.lastLevel) of the refinement that the tiles were built from;
  /// a lower level costs what it has.
  /// Errors: invalidOption for a level out of range, for TileOrder::tiles or normals a level before the last, buffers
  /// too small, tiles chosen that there aren't or out of order.
  template <class Real>
  Result<void> evaluate(Far::LevelTables levels, const Far::TileTable& tiles, std::int32_t level,
                        const Points<Real>& control, const PointsOut<Real>& refined,
                        const TileRequest<Real>& request = {});

 private:
  template <class Real>
  struct Memory {
    TileShared<Real> shared;
    std::vector<std::vector<Real>> scratch;  ///< a worker's own: it stays in its core's caches

    void reserve(int workers, std::size_t numbers) {
      if (scratch.size() < static_cast<std::size_t>(workers)) scratch.resize(static_cast<std::size_t>(workers));
      for (auto& own : scratch) {
        if (own.size() < numbers) own.resize(numbers);
      }
    }
  };
  template <class Real>
  struct Scratch;
  template <class Real>
  Memory<Real>& memory();
  template <class Real>
  Result<void> check(const Far::TileTable& tiles, std::int32_t level, const Points<Real>& control,
                     const PointsOut<Real>& refined, const TileRequest<Real>& request) const;
  template <class Real>
  void evaluateTile(const Far::TileTable& tiles, std::int32_t number, std::int32_t level,
                    const PointsOut<Real>& refined, const PointsOut<Real>& normals, const TileShared<Real>& shared,
                    const Scratch<Real>& scratch) const;

  TileEvaluatorOptions options_;
  CpuEvaluator chained_;
  Memory<float> single_;
  Memory<double> double_;
};

}  // namespace honeycomb::Osd
