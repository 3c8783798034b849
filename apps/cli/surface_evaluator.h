#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "far/base/result.h"
#include "far/tables/level_tables.h"
#include "far/tables/tile_table.h"

namespace honeycomb::Cli {

/// The points of the last level of a refinement, x y z packed, and unit normals of its vertices or none.
template <class Real>
struct Surface {
  std::vector<Real> points;  ///< [vertices | what else the level's table makes]
  std::vector<Real> normals;
  std::int32_t vertexCount = 0;

  std::span<const Real> vertices() const { return std::span(points).first(3 * static_cast<std::size_t>(vertexCount)); }
};

/// fast: see Far::NormalRule.
enum class Normals { none, exact, fast };

/// Refines one frame after another. Belongs to one thread at a time.
class SurfaceEvaluator {
 public:
  virtual ~SurfaceEvaluator() = default;
  /// `control`: 3 numbers a control point: vertices, then central control vertices where the refinement reads them.
  /// Fills the surface, whose storage is kept from frame to frame.
  virtual Result<void> evaluate(std::span<const float> control, Surface<float>& surface) = 0;
  virtual Result<void> evaluate(std::span<const double> control, Surface<double>& surface) = 0;
};

/// Refines frames that follow one another, several of them on their way at a time: what an evaluator is whose work is
/// done elsewhere. Belongs to one thread at a time.
class FrameStream {
 public:
  virtual ~FrameStream() = default;
  /// Frames that may be submitted before the first of them is collected.
  virtual int depth() const = 0;
  /// Sends a frame off; `control` as for SurfaceEvaluator::evaluate, read before this returns.
  virtual Result<void> submit(std::span<const float> control) = 0;
  /// Waits for the oldest frame that is on its way; there must be one.
  virtual Result<void> collect(Surface<float>& surface) = 0;
};

/// What refines the frames of a bake.
struct FrameEvaluators {
  std::vector<std::unique_ptr<SurfaceEvaluator>> each;  ///< one for each frame that is refined at the same time
  FrameStream* stream = nullptr;                        ///< one of these that the frames go through; null: tasks
  std::int64_t tileBytes = 0;                           ///< of the tiles that they share; 0: they go level after level
};

/// Tables to bake by: of a refinement, which tiles are built from where they pay, or of a table file with those it has.
struct SurfaceTables {
  Far::LevelTables levels;
  std::int32_t vertexCount = 0;                 ///< of the last level
  const Far::Refinement* refinement = nullptr;  ///< null: tables of a file
  const Far::TileTable* tiles = nullptr;        ///< of the last level, in its order; null: none are there

  SurfaceTables(const Far::Refinement& built)
      : levels(built), vertexCount(built.last().topology.vertexCount()), refinement(&built) {}
  SurfaceTables(Far::LevelTables of, std::int32_t vertices, const Far::TileTable* ready)
      : levels(of), vertexCount(vertices), tiles(ready) {}
};

/// An opened backend: whatever it needs from the machine is there.
class Backend {
 public:
  virtual ~Backend() = default;
  virtual std::string_view name() const = 0;
  /// An evaluator that has the machine to itself, with such normals. The refinement outlives it.
  virtual Result<std::unique_ptr<SurfaceEvaluator>> evaluator(const Far::Refinement& refinement, Normals normals) = 0;
  /// How many frames of a bake are refined at the same time.
  virtual int framesAtOnce() const = 0;
  /// Evaluators for a bake of `frames` frames, `atOnce` (1 .. framesAtOnce()) of them refined at the same time: a lone
  /// one has the machine to itself. What the tables are views of outlives them.
  virtual Result<FrameEvaluators> frameEvaluators(const SurfaceTables& tables, std::int32_t frames, int atOnce) = 0;
};

/// The backends, `auto` among them. A new one is one line of the table in backends.cpp.
struct BackendEntry {
  std::string_view name;
  bool doublePrecision;
  /// Errors: noDevice and the like, saying what to do.
  Result<std::unique_ptr<Backend>> (*open)();
};
std::span<const BackendEntry> backends();

/// The openers behind the table.
Result<std::unique_ptr<Backend>> openSerial();
Result<std::unique_ptr<Backend>> openSimd();
Result<std::unique_ptr<Backend>> openTbb();
Result<std::unique_ptr<Backend>> openVulkan();

}  // namespace honeycomb::Cli
