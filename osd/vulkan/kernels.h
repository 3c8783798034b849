#pragma once

#include <array>
#include <cstdint>
#include <tuple>

namespace honeycomb::Osd {

/// The kernels, one file each in shaders/.
enum class Kernel : std::uint32_t {
  circulant,
  projectedBlocks,
  projectedSums,
  projected,
  dense,
  summed,
  loose,
  limits,
  normals,
  tileBuffer,
  tileLong,
  tileShared,
  // Of connectivity, without arithmetic of points: VulkanTopology's.
  zipFaceOf,
  zipAround,
  zipTurns,
  least,
  scanSums,
  scanPieces,
  sortCounts,
  sortPlaces,
  zipPlaces,
  zipLoops,
  zipNumbers,
  zipHexagons,
  zipTwins
};
constexpr std::uint32_t kKernelCount = 25;

/// How tiles write a point: see shaders/tile.glsl.
enum class TilePlacing : std::uint32_t { numbers, whole, pairs, fours, threes, sixes, eights };

/// The specialisation constants of shaders/evaluate.glsl, then those of shaders/tile.glsl, by constant_id.
struct Specialization {
  std::uint32_t workgroupSize = 64;
  std::uint32_t length = 3;
  std::uint32_t sourceStride = 3;
  std::uint32_t targetStride = 3;
  std::uint32_t normalStride = 3;
  std::uint32_t sides = 6;  ///< or the width of dense rows
  std::uint32_t pageShift = 0;
  std::uint32_t windowed = 0;
  std::uint32_t form = 0;           ///< Far::CirculantForm
  std::uint32_t scratchPoints = 1;  ///< in shared memory
  std::uint32_t cases = 0;          ///< TileImage::cases, the lower half
  TilePlacing placing = TilePlacing::numbers;
  std::uint32_t shares = 0;       ///< tiles import shared points
  std::uint32_t otherCases = 0;   ///< TileImage::cases, the upper half
  std::uint32_t normalPage = 1;   ///< pages of points, behind which are those of normals
  std::uint32_t normalPairs = 0;  ///< two normals are written together
  std::uint32_t sameWeights = 0;  ///< TileImage::sameWeights
  std::uint32_t oneSubgroup = 0;  ///< a workgroup is one full subgroup, which the pipeline is then made to require
  std::uint32_t dealt = 0;        ///< workgroups ask for their next tile
  std::uint32_t packedRoot = 0;   ///< a point of the root is read as one vector
  /// All of them in order, to be compared.
  auto constants() const {
    return std::tie(workgroupSize, length, sourceStride, targetStride, normalStride, sides, pageShift, windowed, form,
                    scratchPoints, cases, placing, shares, otherCases, normalPage, normalPairs, sameWeights,
                    oneSubgroup, dealt, packedRoot);
  }
  bool operator<(const Specialization& other) const { return constants() < other.constants(); }
};
constexpr std::uint32_t kSpecializationCount = 20;
static_assert(sizeof(Specialization) == kSpecializationCount * sizeof(std::uint32_t));

/// Up to this many sides the loops of a kernel are unrolled and a circulant's weights are push constants. Unrolling
/// grows with the square of the sides: at 64 lavapipe compiles for a minute.
constexpr std::int32_t kUnrolledSides = 16;

/// The push constants of shaders/evaluate.glsl, which says what they are.
struct PushConstants {
  std::uint32_t count = 0;
  std::uint32_t rowLength = 0;
  std::uint32_t sides = 0;
  std::uint32_t firstIndex = 0;
  std::uint32_t firstWeight = 0;
  std::uint32_t firstRecord = 0;
  std::uint32_t firstTask = 0;
  std::uint32_t firstOutput = 0;
  std::uint32_t sourceOffset = 0;
  std::uint32_t targetOffset = 0;
  std::uint32_t windowBegin = 0;
  std::uint32_t windowSize = 0;
  std::uint32_t normalOffset = 0;
  std::uint32_t normalBegin = 0;
  std::uint32_t normalSize = 0;
  std::array<float, kUnrolledSides> weights{};
};
static_assert(sizeof(PushConstants) <= 128, "no more push constants are sure to be there");

/// The bindings of the kernels beside the source's pages (binding 0), in order from binding 1.
enum class Slot : std::uint32_t { indices, weights, target, second, records, tasks };
constexpr std::uint32_t kSlotCount = 6;

/// The bindings behind the slots, which only tile kernels have: the table and the tiles' points as texels.
constexpr std::uint32_t kTableTexels = 1 + kSlotCount;
constexpr std::uint32_t kScratchTexels = 2 + kSlotCount;

/// The buffers a stage touches; a table's plan names them, a binding says which they are.
enum class Role : std::uint32_t { table, target, normals, partials, source, sharedPoints, sharedNormals, tileScratch };

/// A range of a buffer, bytes; size 0: nothing.
struct BoundRange {
  Role role = Role::table;
  std::uint64_t offset = 0;
  std::uint64_t size = 0;
  bool operator<(const BoundRange& other) const {
    return std::tie(role, offset, size) < std::tie(other.role, other.offset, other.size);
  }
};
using BoundRanges = std::array<BoundRange, kSlotCount>;

/// One dispatch: everything but the buffers themselves.
struct Dispatch {
  Kernel kernel = Kernel::circulant;
  Specialization specialization;
  PushConstants push;
  BoundRanges ranges;
  std::uint32_t groups = 1;  ///< in a row
  std::uint32_t groupRows = 1;
};

}  // namespace honeycomb::Osd
