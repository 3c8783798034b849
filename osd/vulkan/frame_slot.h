#pragma once

#include <array>
#include <memory>
#include <span>

#include "osd/vulkan/commands.h"
#include "osd/vulkan/evaluator.h"

namespace honeycomb::Osd {

/// What happens to the buffers of a frame besides its evaluation.
struct FrameSlotOptions {
  bool readback = true;  ///< bring the results to the host; off: they stay on the device
  bool timing = false;   ///< see VulkanBindingOptions
  /// Stages of the same queue that read the results behind the frame's commands, without a semaphore in between:
  /// results are made visible to them, and the next frame in the same buffers waits for what they did before.
  VkPipelineStageFlags readers = 0;
};

/// All that one frame needs: buffers (mapped all the time), a binding and commands that are recorded once. Submitting
/// them again and again allocates and updates nothing.
///     commands   [points in] -> levels and limits -> [results out]     copies only where memory isn't shared
class FrameSlot {
 public:
  /// `scratchOf`: a slot of the same table and queue to share scratch memory with. Errors: as of VulkanEvaluator::bind.
  static Result<FrameSlot> create(const VulkanEvaluator& evaluator, const VulkanTable& table,
                                  const FrameSlotOptions& options, const FrameSlot* scratchOf = nullptr);

  /// The host's view of a buffer, laid out by the table's options; empty when the table doesn't touch it or when it
  /// stays on the device.
  std::span<float> numbers(PointBuffer points) const;
  /// The buffer on the device, usable as storage and as vertex buffer.
  VulkanRange range(PointBuffer points) const { return buffer(points).range(); }

  /// Records the commands anew when kernels changed (VulkanEvaluatorOptions::kernelFolder); they must not be running.
  /// Errors: invalidFile.
  Result<void> refresh();

  /// The frame's own commands, recorded as it was made.
  CommandRunner& commands() { return commands_; }
  const VulkanTable& table() const { return table_; }
  const VulkanBinding& binding() const { return *binding_; }

 private:
  const SharedBuffer& buffer(PointBuffer points) const { return buffers_[static_cast<std::size_t>(points)]; }
  VulkanTargets targets() const;
  Result<void> makeBuffers();
  Result<void> clearUnmapped();
  Result<void> record();
  void recordInput() const;
  void recordOutput() const;

  std::shared_ptr<const VulkanCore> core_;
  VulkanTable table_;
  FrameSlotOptions options_;
  std::array<SharedBuffer, kCallerBuffers> buffers_;
  std::unique_ptr<VulkanBinding> binding_;
  std::uint64_t kernels_ = 0;  ///< the kernels recorded, by VulkanBinding::refreshKernels
  CommandRunner commands_;
};

}  // namespace honeycomb::Osd
