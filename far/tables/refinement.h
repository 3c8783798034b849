#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/schemes/scheme.h"
#include "far/tables/level_table.h"
#include "far/tables/limit_table.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// What refine() makes besides levels, and of what.
struct RefineOptions {
  bool centralPoints = false;    ///< the control points are [vertices | one central control vertex a face, in the
                                 ///< caller's order]; false: vertices, and a scheme that wants them takes barycentres
  bool limits = false;           ///< also build the LimitTable of the last level (costs about three times its tables)
  std::int64_t memoryLimit = 0;  ///< bytes the tables may take; 0: no limit
};

/// The control face or control vertex a refined face or vertex descends from, and the level it first appeared at.
struct Origin {
  std::int32_t element = 0;  ///< face or vertex of level 0 (Topology::inputFace leads to the caller's face number)
  std::int32_t level = 0;    ///< level of birth of the face, or of the face the vertex sits in
  bool vertex = false;       ///< element is a vertex
  bool operator==(const Origin&) const = default;
};

/// One level: its connectivity, and how to get its points from those of the level before (empty at level 0).
struct Level {
  Topology topology;
  LevelTable table;
  CentralPoints central = CentralPoints::none;  ///< what the level's points are beside its vertices
  /// The first so many vertices are the corner points of whole faces of the level before: see SplitResult. They lie
  /// beside those faces' edges or in their corners.
  std::int32_t cornerPoints = 0;
  CornerPlace cornerPlace = CornerPlace::corner;

  /// [vertices | central control vertices, where there are any].
  SourceLevel points() const { return SourceLevel(topology, central); }
  std::int32_t pointCount() const { return points().pointCount(); }
};

/// All levels of a mesh under a chain of schemes, built once; evaluators apply the tables every frame. Immutable.
class Refinement {
 public:
  Refinement(std::vector<Level> levels, LimitTable limits) : levels_(std::move(levels)), limits_(std::move(limits)) {}

  /// The number of refinement steps L; levels are 0..L.
  std::int32_t levelCount() const { return static_cast<std::int32_t>(levels_.size()) - 1; }
  /// Level k, 0 .. levelCount().
  const Level& level(std::int32_t k) const { return levels_[static_cast<std::size_t>(k)]; }
  const Level& last() const { return levels_.back(); }
  /// Limits of the last level; empty unless RefineOptions::limits.
  const LimitTable& limits() const { return limits_; }

  /// Index buffers of level k. Triangles fan out from each face's first corner: 3 (sides - 2) indices a face.
  std::vector<std::int32_t> triangles(std::int32_t k) const;
  /// Two indices an edge, each edge once.
  std::vector<std::int32_t> lines(std::int32_t k) const;
  /// Face f is vert()[faceOffsets[f]] .. of the level's topology.
  std::span<const std::int32_t> faceOffsets(std::int32_t k) const { return level(k).topology.faceOffsets(); }

  /// Where each face of level k comes from.
  std::vector<Origin> faceOrigins(std::int32_t k) const;
  /// Where each vertex of level k comes from: the origin of the face of level k-1 it was made in.
  std::vector<Origin> vertexOrigins(std::int32_t k) const;

  /// This refinement, without limits, and a last level that is given, such as a tessellation of the limit surface. Its
  /// table reads the points of the level that was last; its faces have origins, and face-varying values, if its
  /// topology's parents are of that level.
  Refinement followedBy(Level level) &&;

  /// Bytes of level k: the corners that its table shares with the level before are counted there.
  std::int64_t byteCount(std::int32_t k) const;
  /// Of all levels and the limits.
  std::int64_t byteCount() const;

 private:
  std::vector<Level> levels_;
  LimitTable limits_;
};

/// Builds `perLevel.size()` levels (at most kMaxLevels), level k+1 by perLevel[k].
/// Errors: tooLarge when a level would pass 2^31 - 1 half-edges, or the tables options.memoryLimit, before any is
/// built.
Result<Refinement> refine(const Topology& control, std::span<const Scheme> perLevel, const RefineOptions& options = {});
/// The same scheme at every level.
Result<Refinement> refine(const Topology& control, const Scheme& scheme, std::int32_t levels,
                          const RefineOptions& options = {});

/// The longest chain of steps.
constexpr std::int32_t kMaxLevels = 20;

/// What a level will have, known before anything is built.
struct LevelCounts {
  std::int64_t vertices = 0, edges = 0, faces = 0, halfEdges = 0, boundaryEdges = 0;
  std::int64_t points = 0;   ///< vertices, and central control vertices where the step to this level makes them
  std::int64_t scratch = 0;  ///< bytes that building this level takes for a while, about
  std::int64_t bytes = 0;    ///< topology and table of this level, without:
  std::int64_t links = 0;    ///< bytes of links that come when they are asked for (Topology)
  bool exact = true;  ///< false: an upper bound (the erosion of `drop` and `eq16` depends on the boundary's shape)
};
/// Counts of levels 0..perLevel.size(), without building any.
std::vector<LevelCounts> predict(const Topology& control, std::span<const Scheme> perLevel);

/// About what refine() takes.
struct BuildBytes {
  std::int64_t tables = 0;   ///< of all levels and the limits
  std::int64_t scratch = 0;  ///< besides them while the largest level is made
};
/// `levels`: predicted, from level 0. With limits its last is one behind the refinement's, which the limits read.
BuildBytes buildBytes(std::span<const LevelCounts> levels, bool limits);

}  // namespace honeycomb::Far
