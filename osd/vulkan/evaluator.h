#pragma once

#include <memory>
#include <span>

#include "far/tables/refinement.h"
#include "osd/vulkan/binding.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/device.h"
#include "osd/vulkan/table.h"

namespace honeycomb::Osd {

/// Applies tables by Vulkan compute on a device of the caller's, with function pointers of its own. Needs Vulkan 1.2
/// and no optional feature; a discrete GPU's memory is reached through staging. Bit-identical with the CPU evaluators
/// where the device rounds division and square root correctly and keeps denormals (lavapipe does; Vulkan promises 2.5
/// ulp).
///
/// Copies share pipelines. Safe from several threads, but see upload().
class VulkanEvaluator {
 public:
  /// Errors: noDevice without a Vulkan loader, invalidOption for null handles, unsupported below Vulkan 1.2 or when the
  /// device can't bind 14 storage buffers, outOfMemory.
  static Result<VulkanEvaluator> create(const VulkanDevice& device, const VulkanEvaluatorOptions& options = {});

  /// Brings the tables of levels options.firstLevel+1 .. options.lastLevel to the device, once per mesh. Where memory
  /// isn't shared it submits copies to the device's queue and waits, so nobody else may use the queue meanwhile.
  /// Errors: invalidOption (levels, descriptors, limits that aren't there), tooLarge (a level of 2^32 numbers, or one
  /// that is read of more than kSourcePages pages), outOfMemory, deviceLost.
  Result<VulkanTable> upload(const Far::Refinement& refinement, const VulkanTableOptions& options = {});
  /// The same of level tables from anywhere, each reading what the one before writes; `limits` of the last may be null.
  /// options.firstLevel and lastLevel are not looked at.
  Result<VulkanTable> upload(std::span<const Far::LevelTable* const> levels, const Far::LimitTable* limits,
                             const VulkanTableOptions& options = {});

  /// Prepares a table to work on the caller's buffers: descriptor sets and scratch. Errors: see VulkanBinding.
  Result<VulkanBinding> bind(const VulkanTable& table, const VulkanTargets& targets) const;

  /// Records the dispatches of all levels and limits, with one barrier between a level and the next. Only records:
  /// never submits, allocates or updates. The command buffer must be in the recording state outside a render pass, of a
  /// family with compute, and loses its bound compute pipeline, descriptor set 0 and push constants.
  ///     before   the caller makes the control points visible to COMPUTE_SHADER / SHADER_READ, and sees that what used
  ///              the target buffers is done (an execution dependency on COMPUTE_SHADER)
  ///     after    results were written by COMPUTE_SHADER / SHADER_WRITE; the caller's barrier makes them visible
  void record(VkCommandBuffer commands, const VulkanBinding& binding) const { binding.record(commands); }

  /// What the device allows.
  const VulkanLimits& limits() const { return core_->limits; }
  const std::shared_ptr<const VulkanCore>& core() const { return core_; }

 private:
  std::shared_ptr<const VulkanCore> core_;
  std::shared_ptr<VulkanPipelines> pipelines_;
};

}  // namespace honeycomb::Osd
