#pragma once

#include <memory>
#include <span>

#include "far/tables/level_tables.h"
#include "far/tables/stencil_table.h"
#include "osd/vulkan/binding.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/device.h"
#include "osd/vulkan/table.h"

namespace honeycomb::Osd {

/// Applies tables by Vulkan compute on a device of the caller's, with function pointers of its own, looked up where the
/// caller says, and host memory from the caller's callbacks (VulkanDevice). No global state, and no exception. Needs
/// Vulkan 1.2 and no optional feature; a discrete GPU's memory is reached through staging. Bit-identical with the CPU
/// evaluators where the device rounds division and square root correctly and keeps denormals (lavapipe does; Vulkan
/// promises 2.5 ulp).
///
/// Copies share pipelines. Safe from several threads, but see upload().
class VulkanEvaluator {
 public:
  /// Errors: noDevice without a Vulkan loader, invalidOption for null handles, unsupported below Vulkan 1.2, when a
  /// function is missing (named) or the device can't bind 14 storage buffers, outOfMemory, deviceLost.
  static Result<VulkanEvaluator> create(const VulkanDevice& device, const VulkanEvaluatorOptions& options = {});

  /// Brings the tables of levels options.firstLevel+1 .. options.lastLevel to the device, once per mesh. Where memory
  /// isn't shared it submits copies to the device's queue and waits: where others use that queue meanwhile, the device
  /// has a VulkanDevice::queueLock.
  /// Errors: invalidOption (levels, descriptors, limits or normals that aren't there), tooLarge (a level of 2^32
  /// numbers, or one that is read of more than kSourcePages pages), outOfMemory, deviceLost.
  Result<VulkanTable> upload(const Far::Refinement& refinement, const VulkanTableOptions& options = {});
  /// The same of level tables from anywhere, without fast normals of vertices, which take the refinement's topology.
  Result<VulkanTable> upload(Far::LevelTables levels, const VulkanTableOptions& options = {});
  /// The same of single tables, each reading what the one before writes; `limits` of the last may be null.
  /// options.firstLevel and lastLevel are not looked at.
  Result<VulkanTable> upload(std::span<const Far::LevelTable* const> levels, const Far::LimitTable* limits,
                             const VulkanTableOptions& options = {});

  /// Brings a stencil table to the device, as one level of loose rows: `which` weights, from options.control to
  /// options.refined. Flattened tables, limits, patches, and OpenSubdiv's own (osd/interop). Errors: as of level
  /// tables.
  Result<VulkanTable> upload(const Far::StencilTable& table, Far::StencilWeights which = Far::StencilWeights::position,
                             const VulkanTableOptions& options = {});

  /// Brings tiles of a refinement to the device: one dispatch for all levels behind the tiles' root level, a workgroup
  /// a tile; levels up to the root and what is too large for a tile go before it. `levels` are those that the
  /// tiles were built from. Normals, where options.normals asks for them, are found in the same dispatch. Errors:
  /// invalidOption (level, descriptors, tiles or normals that there aren't), tooLarge (points at the root past a page,
  /// the wanted level and its normals past kSourcePages pages, tiles past shared memory that was asked for: the message
  /// says what helps; upload(levels) has no such limits), outOfMemory, deviceLost.
  Result<VulkanTable> uploadTiles(Far::LevelTables levels, const Far::TileTable& tiles,
                                  const VulkanTileOptions& options = {});

  /// Prepares a table to work on the caller's buffers: descriptor sets and scratch. Errors: see VulkanBinding.
  Result<VulkanBinding> bind(const VulkanTable& table, const VulkanTargets& targets,
                             const VulkanBindingOptions& options = {}) const;

  /// Records the dispatches of all levels and limits, with one barrier between a level and the next. Only records:
  /// never submits, allocates or updates. The command buffer must be in the recording state outside a render pass, of a
  /// family with compute, and loses its bound compute pipeline, descriptor set 0 and push constants.
  ///     waits for   COMPUTE_SHADER / SHADER_WRITE of all that comes before on the same queue: its first barrier makes
  ///                 that visible to COMPUTE_SHADER / SHADER_READ and SHADER_WRITE, so that control points from a
  ///                 kernel of the caller's, and the same binding once more, need nothing in between
  ///     the caller  makes copied control points visible to COMPUTE_SHADER / SHADER_READ (what the host wrote before
  ///     the
  ///                 submission is so), and lets COMPUTE_SHADER wait for those who still read the targets
  ///     leaves      results written by COMPUTE_SHADER / SHADER_WRITE and no barrier: the caller's makes them visible
  ///                 to those who read, at VERTEX_INPUT / VERTEX_ATTRIBUTE_READ or HOST / HOST_READ for instance
  void record(VkCommandBuffer commands, const VulkanBinding& binding) const { binding.record(commands); }

  /// The points a tile may keep on this device (Far::TileOptions::scratchPoints). In shared memory, which `automatic`
  /// takes unless the device is a CPU: three quarters of what a workgroup has, since tiles grow past what is asked for
  /// and fast normals stand beside the points; `automatic` takes the buffer for tiles that grow further.
  /// In a buffer: 30720, at which lavapipe takes 5 to 12 % less time than with 16384; tiles may grow past it by a
  /// fifteenth. Points come out the same whatever it is.
  std::int32_t tilePoints(TileScratch scratch = TileScratch::automatic) const;
  /// How tiles are cut for this device, normals aside: tilePoints(); for a CPU four a thread or more, and as many for
  /// each, where they keep points enough.
  Far::TileOptions tileOptions(TileScratch scratch = TileScratch::automatic) const;

  /// Pipelines so far, of all tables: where an upload makes it grow there was something to compile.
  std::size_t pipelineCount() const { return pipelines_->count(); }
  /// Did compiled pipelines come from the file VulkanEvaluatorOptions::pipelineCache names?
  bool pipelinesFromFile() const { return pipelines_->cache().startedFromFile(); }
  /// Writes that file now, if anything was compiled since the last time; upload() does so too and is silent about
  /// failures. Errors: unwritable, outOfMemory.
  Result<void> savePipelines() const;

  /// What the device allows.
  const VulkanLimits& limits() const { return core_->limits; }
  const std::shared_ptr<const VulkanCore>& core() const { return core_; }
  const std::shared_ptr<VulkanPipelines>& pipelines() const { return pipelines_; }

 private:
  Result<VulkanTable> uploadRange(Far::LevelTables levels, const Far::NormalTable* fast,
                                  const VulkanTableOptions& options);
  Result<VulkanTable> uploadLevels(std::span<const Far::LevelTable* const> levels, const Far::LimitTable* limits,
                                   const Far::NormalTable* fast, const VulkanTableOptions& options);

  std::shared_ptr<const VulkanCore> core_;
  std::shared_ptr<VulkanPipelines> pipelines_;
};

}  // namespace honeycomb::Osd
