#include "osd/vulkan/commands.h"

#include <cstdint>
#include <mutex>
#include <utility>

#include "osd/vulkan/errors.h"

namespace honeycomb::Osd {

void memoryBarrier(const VulkanCore& core, VkCommandBuffer commands, const MemoryAccess& before,
                   const MemoryAccess& after) {
  VkMemoryBarrier barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  barrier.srcAccessMask = before.access;
  barrier.dstAccessMask = after.access;
  core.vk().vkCmdPipelineBarrier(commands, before.stages, after.stages, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

VkResult submitTo(const VulkanCore& core, const VkSubmitInfo& info, VkFence fence) {
  const std::lock_guard turn(core.device.queueLock);
  return core.vk().vkQueueSubmit(core.device.queue, 1, &info, fence);
}

Result<CommandRunner> CommandRunner::create(const std::shared_ptr<const VulkanCore>& core) {
  CommandRunner runner;
  runner.core_ = core;
  VkCommandPoolCreateInfo poolInfo{};
  poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  poolInfo.queueFamilyIndex = core->device.queueFamily;
  auto pool =
      core->make(core->vk().vkCreateCommandPool, core->vk().vkDestroyCommandPool, poolInfo, "create a command pool");
  if (!pool) return tl::unexpected(pool.error());
  runner.pool_ = std::move(*pool);

  VkCommandBufferAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  info.commandPool = runner.pool_.get();
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  const VkResult result = core->vk().vkAllocateCommandBuffers(core->device.device, &info, &runner.commands_);
  if (result != VK_SUCCESS) return vulkanFailure(result, "allocate a command buffer");

  VkFenceCreateInfo fenceInfo{};
  fenceInfo.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  auto fence = core->make(core->vk().vkCreateFence, core->vk().vkDestroyFence, fenceInfo, "create a fence");
  if (!fence) return tl::unexpected(fence.error());
  runner.fence_ = std::move(*fence);
  return runner;
}

CommandRunner::CommandRunner(CommandRunner&& other) noexcept
    : core_(std::move(other.core_)),
      pool_(std::move(other.pool_)),
      fence_(std::move(other.fence_)),
      commands_(std::exchange(other.commands_, VK_NULL_HANDLE)),
      running_(std::exchange(other.running_, false)) {}

CommandRunner& CommandRunner::operator=(CommandRunner&& other) noexcept {
  std::swap(core_, other.core_);
  std::swap(pool_, other.pool_);
  std::swap(fence_, other.fence_);
  std::swap(commands_, other.commands_);
  std::swap(running_, other.running_);
  return *this;
}

CommandRunner::~CommandRunner() {
  // There is nothing more to be done about a failure here.
  if (core_) static_cast<void>(wait());
}

Result<void> CommandRunner::begin(VkCommandBufferUsageFlags usage) {
  VkCommandBufferBeginInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  info.flags = usage;
  const VkResult result = core_->vk().vkBeginCommandBuffer(commands_, &info);
  if (result != VK_SUCCESS) return vulkanFailure(result, "begin a command buffer");
  return {};
}

Result<void> CommandRunner::end() {
  const VkResult result = core_->vk().vkEndCommandBuffer(commands_);
  if (result != VK_SUCCESS) return vulkanFailure(result, "record a command buffer");
  return {};
}

Result<void> CommandRunner::submit() {
  if (auto waited = wait(); !waited) return waited;
  // Here and not after the wait: if it fails, nothing is under way, and the next submission tries again.
  const VkFence fence = fence_.get();
  VkResult result = core_->vk().vkResetFences(core_->device.device, 1, &fence);
  if (result != VK_SUCCESS) return vulkanFailure(result, "reset a fence");
  VkSubmitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  info.commandBufferCount = 1;
  info.pCommandBuffers = &commands_;
  result = submitTo(*core_, info, fence);
  if (result != VK_SUCCESS) return vulkanFailure(result, "submit commands");
  running_ = true;
  return {};
}

Result<void> CommandRunner::wait() {
  if (!running_) return {};
  const VkFence fence = fence_.get();
  const VkResult result = core_->vk().vkWaitForFences(core_->device.device, 1, &fence, VK_TRUE, UINT64_MAX);
  // A lost device runs nothing any more; after any other failure the commands may still be running.
  running_ = result != VK_SUCCESS && result != VK_ERROR_DEVICE_LOST;
  if (result != VK_SUCCESS) return vulkanFailure(result, "finish the submitted commands");
  return {};
}

}  // namespace honeycomb::Osd
