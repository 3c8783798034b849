#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "far/base/result.h"
#include "far/tables/refinement.h"
#include "far/tables/stencil_table.h"
#include "far/tables/tile_table.h"
#include "osd/buffer_descriptor.h"
#include "osd/cpu_evaluator.h"

namespace honeycomb::Bench {

/// The table from the control points straight to the last level, made when the first evaluator asks for it.
class FlatTable {
 public:
  /// `memory`: bytes it may take.
  FlatTable(const Far::Refinement& refinement, std::int64_t memory) : refinement_(refinement), memory_(memory) {}

  /// Errors: tooLarge.
  Result<const Far::StencilTable*> get();
  double buildMs() const { return buildMs_; }

 private:
  const Far::Refinement& refinement_;
  std::int64_t memory_;
  double buildMs_ = 0;
  std::optional<Result<Far::StencilTable>> table_;
};

/// How the points lie in memory.
struct Layout {
  std::string_view name;
  Osd::BufferDescriptor desc;
};
/// Three packed numbers a point, and four with a 1 at the end.
std::span<const Layout> layouts();

/// Unit normals of the vertices beside the points.
enum class Normals : std::uint8_t {
  none,
  fast,  ///< from the limit normals of the two faces at the vertex
  exact  ///< of the limit surface
};

/// What all evaluators of a comparison do: the last level of a refinement from the same control points. Evaluators on
/// the CPU write to the same memory, so that none has better pages than the others.
struct Problem {
  const Far::Refinement& refinement;
  Layout layout;
  Normals normals = Normals::none;
  std::span<const float> control;
  std::span<float> refined;        ///< for all points of the last level
  std::span<float> vertexNormals;  ///< x y z per point of the last level; empty without normals
  double tablesMs = 0;             ///< what the refinement took to build
  FlatTable& flat;
};

/// What a level of a frame took, or the limits of the last, by a device's own clock.
struct LevelMs {
  std::int32_t level = 0;
  bool limits = false;
  double ms = 0;
};

/// Processor time that a frame takes of the thread that asks a device for it.
struct HostUs {
  double record = 0;  ///< into a command buffer, which may be kept for all frames
  double submit = 0;
};

/// An evaluator with its tables built.
struct Prepared {
  std::function<Result<void>()> frame;   ///< evaluates the points of a frame
  std::span<const float> refined = {};   ///< where frame() leaves them, in the problem's layout
  std::span<const float> normals = {};   ///< and the normals
  double buildMs = 0;                    ///< from the control mesh to the first frame, topology included
  std::int64_t tableBytes = 0;           ///< read in a frame, beside the points
  std::int64_t vertices = 0;             ///< that a frame makes
  std::vector<std::int32_t> order = {};  ///< order[i] is the level's number of the point that comes out i-th; empty: i
  std::vector<float> expected = {};      ///< what is to come out, where that is another surface than the problem's
  /// Evaluates another frame and says what its levels took; absent where nobody can tell. Beside the timed frames,
  /// which timestamps would slow down. Errors: unsupported, when the device has no clock.
  std::function<Result<std::vector<LevelMs>>()> levels = {};
  /// Records and submits another frame and waits for it; absent where there is no device. Errors: unsupported, when the
  /// device can't have frames in flight.
  std::function<Result<HostUs>()> host = {};
  bool spins = false;  ///< its threads keep the processors busy for a while after a frame
};

/// How an evaluator's points agree with the serial one's.
enum class Agreement : std::uint8_t {
  bits,     ///< they are the same
  rounding  ///< they differ by rounding: another order of operations
};

enum class Threads : std::uint8_t { one, all, device };

/// An evaluator that can be measured: a new one is one line of the table in evaluators.cpp.
struct EvaluatorEntry {
  std::string_view name;
  Agreement agreement = Agreement::bits;
  Threads threads = Threads::all;
  /// Errors: unsupported or noDevice for what this build or this machine hasn't, or what the evaluator can't do;
  /// tooLarge, outOfMemory.
  Result<Prepared> (*prepare)(const Problem& problem) = nullptr;
};
std::span<const EvaluatorEntry> evaluators();

/// The functions behind the table that have a file of their own.
Result<Prepared> prepareSimdTiled(const Problem& problem);
Result<Prepared> prepareTbbTiled(const Problem& problem);
Result<Prepared> prepareTbbTileOrder(const Problem& problem);
/// Level after level, with fast normals.
Result<Prepared> prepareFastNormals(const Problem& problem, Osd::CpuEvaluator::Threads threads);
Result<Prepared> prepareCsr(const Problem& problem);
Result<Prepared> prepareVulkan(const Problem& problem);
Result<Prepared> prepareVulkanTiled(const Problem& problem);
Result<Prepared> prepareVulkanCsr(const Problem& problem);
Result<Prepared> prepareOpenSubdivCpu(const Problem& problem);
Result<Prepared> prepareOpenSubdivOmp(const Problem& problem);
Result<Prepared> prepareOpenSubdivCatmark(const Problem& problem);
Result<Prepared> prepareEigen(const Problem& problem);

/// What tiles are built with.
Far::TileNormalKind tileNormals(Normals normals);

/// Errors: unsupported, saying who has no normals, when the problem wants some.
Result<void> withoutNormals(const Problem& problem);

}  // namespace honeycomb::Bench
