#pragma once

#include <memory>

#include "far/base/result.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/handles.h"

namespace honeycomb::Osd {

/// One side of a memory barrier.
struct MemoryAccess {
  VkPipelineStageFlags stages = 0;
  VkAccessFlags access = 0;
};

/// Records a barrier over all memory.
void memoryBarrier(const VulkanCore& core, VkCommandBuffer commands, const MemoryAccess& before,
                   const MemoryAccess& after);

/// Submits to the core's queue, under its lock.
VkResult submitTo(const VulkanCore& core, const VkSubmitInfo& info, VkFence fence);

/// One command buffer with a pool and a fence of its own: recorded once or anew, submitted as often as wanted.
/// Waits for what is still running when it is destroyed.
class CommandRunner {
 public:
  /// Errors: outOfMemory, deviceLost.
  static Result<CommandRunner> create(const std::shared_ptr<const VulkanCore>& core);
  CommandRunner() = default;
  ~CommandRunner();
  CommandRunner(CommandRunner&& other) noexcept;
  CommandRunner& operator=(CommandRunner&& other) noexcept;

  VkCommandBuffer commandBuffer() const { return commands_; }
  Result<void> begin(VkCommandBufferUsageFlags usage);
  Result<void> end();
  /// To the core's queue, under its lock; after the submission before, where that still runs.
  Result<void> submit();
  /// Returns when the submission has run; at once when none is running. After an error other than deviceLost it may
  /// still be running: wait again.
  Result<void> wait();

 private:
  std::shared_ptr<const VulkanCore> core_;
  DeviceHandle<VkCommandPool> pool_;
  DeviceHandle<VkFence> fence_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  bool running_ = false;
};

}  // namespace honeycomb::Osd
