#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/tables/level_tables.h"
#include "far/tables/tile_table.h"
#include "osd/buffer_descriptor.h"
#include "osd/vulkan/memory.h"
#include "osd/vulkan/pipelines.h"
#include "osd/vulkan/plan.h"
#include "osd/vulkan/tile_options.h"

namespace honeycomb::Osd {

/// What is to be evaluated, and how the points lie in their buffers.
struct VulkanTableOptions {
  BufferDescriptor control{};  ///< points of firstLevel, which are read
  BufferDescriptor refined{};  ///< points of lastLevel, which are written; the same length as control
  std::int32_t firstLevel = 0;
  std::int32_t lastLevel = -1;  ///< above firstLevel; -1: the refinement's last
  LimitLayouts vertexLimits{};  ///< limits of the vertices of lastLevel; needs length 3 and the refinement's limits
  LimitLayouts faceLimits{};    ///< the same of its faces
  /// What vertexLimits.normals are. fast: Far::NormalTable of lastLevel, built with the table, for every point of the
  /// level (the zero vector of points that are not vertices); they need a refinement from firstLevel 0 and points of
  /// length 3 or 4, but no limits. Each point takes about 16 bytes of table, each face of the levels before 12 of
  /// scratch
  Far::TileNormalKind normalKind = Far::TileNormalKind::exact;

  bool fastNormals() const { return vertexLimits.normals && normalKind == Far::TileNormalKind::fast; }
  /// What is wanted of the vertices' limits: vertexLimits without normals that come from elsewhere.
  LimitLayouts exactVertexLimits() const {
    return {vertexLimits.positions, fastNormals() ? std::nullopt : vertexLimits.normals};
  }
};

/// The buffers a table reads and writes; those of the caller first.
enum class PointBuffer : std::uint32_t {
  control,
  refined,
  vertexPositions,
  vertexNormals,
  facePositions,
  faceNormals,
  scratchEven,
  scratchOdd,
  partials,
  setEven,  ///< one of Far::SharedPoints, and the next
  setOdd,
  sharedPoints,   ///< of all of them, packed
  sharedNormals,  ///< of faces, packed: what fast normals of tiles import
  tileScratch     ///< a slice of texels for each workgroup
};
constexpr std::size_t kCallerBuffers = 6;
constexpr std::size_t kScratchBuffers = 8;

/// One table on the device.
struct TableStage {
  VulkanBuffer buffer;
  PointBuffer source = PointBuffer::control;
  PointBuffer target = PointBuffer::refined;
  PointBuffer normals = PointBuffer::vertexNormals;
  PointBuffer paged = PointBuffer::control;  ///< what is bound as pages: the source of levels, the target of tiles
  std::uint64_t pagedBytes = 0;
  std::uint32_t normalPage = 0;       ///< the first page of `normals`, behind those of `paged`; 0: these aren't bound
  DeviceHandle<VkBufferView> texels;  ///< of tiles: the buffer's
};

/// A dispatch with the pipeline that it needs; stages follow each other behind barriers.
struct TableDispatch {
  Dispatch dispatch;
  VkPipeline pipeline = VK_NULL_HANDLE;
  std::uint32_t stage = 0;
};

/// What to compute, on the device: the tables of all levels, and the dispatches that apply them. Immutable; may serve
/// several bindings at once.
class VulkanTable {
 public:
  /// Bytes of a buffer of the caller; 0 when the table doesn't touch it.
  std::uint64_t bytesOf(PointBuffer points) const { return state_->bytes[static_cast<std::size_t>(points)]; }
  /// Points in a buffer of the caller.
  std::int64_t controlCount() const { return state_->controlCount; }
  std::int64_t refinedCount() const { return state_->refinedCount; }
  std::int64_t faceCount() const { return state_->faceCount; }
  const VulkanTableOptions& options() const { return state_->options; }
  /// Bytes of device memory the tables take.
  std::uint64_t byteCount() const;
  /// Dispatches a frame.
  std::size_t dispatchCount() const;

 private:
  friend class TableBuilder;
  friend class VulkanBinding;
  struct State {
    VulkanTableOptions options;
    std::vector<TableStage> stages;
    std::vector<std::vector<TableDispatch>> phases;  ///< a barrier between one and the next
    std::vector<std::size_t> levelEnds;              ///< phases up to the end of each level; limits come behind
    std::array<std::uint64_t, kCallerBuffers + kScratchBuffers> bytes{};
    std::int64_t controlCount = 0, refinedCount = 0, faceCount = 0;
  };
  std::shared_ptr<const State> state_;
};

/// Uploads the tables of consecutive levels, and what the options want of `limits` and `fast`, both of the last; either
/// may be null. Errors: invalidOption, tooLarge, outOfMemory, deviceLost.
Result<VulkanTable> buildTable(const std::shared_ptr<const VulkanCore>& core, VulkanPipelines& pipelines,
                               std::span<const Far::LevelTable* const> levels, const Far::LimitTable* limits,
                               const Far::NormalTable* fast, const VulkanTableOptions& options);

/// Uploads tiles, and the levels that are evaluated before them. Errors: as above, unsupported.
Result<VulkanTable> buildTable(const std::shared_ptr<const VulkanCore>& core, VulkanPipelines& pipelines,
                               Far::LevelTables levels, const Far::TileTable& tiles, const VulkanTileOptions& options);

}  // namespace honeycomb::Osd
