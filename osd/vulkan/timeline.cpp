#include "osd/vulkan/timeline.h"

#include <utility>

#include "osd/vulkan/errors.h"

namespace honeycomb::Osd {

Result<Timeline> Timeline::create(const std::shared_ptr<const VulkanCore>& core) {
  Timeline timeline;
  timeline.core_ = core;
  VkSemaphoreTypeCreateInfo type{};
  type.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO;
  type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
  VkSemaphoreCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
  info.pNext = &type;
  auto semaphore =
      core->make(core->vk().vkCreateSemaphore, core->vk().vkDestroySemaphore, info, "create a timeline semaphore");
  if (!semaphore) return tl::unexpected(semaphore.error());
  timeline.semaphore_ = std::move(*semaphore);
  return timeline;
}

Timeline::~Timeline() {
  // A lost device runs nothing any more: there is nothing to be done about a failure here.
  if (semaphore_) static_cast<void>(wait(count_));
}

Result<void> Timeline::wait(std::uint64_t submission) const {
  const VkSemaphore semaphore = semaphore_.get();
  VkSemaphoreWaitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO;
  info.semaphoreCount = 1;
  info.pSemaphores = &semaphore;
  info.pValues = &submission;
  const VkResult result = core_->vk().vkWaitSemaphores(core_->device.device, &info, UINT64_MAX);
  if (result != VK_SUCCESS) return vulkanFailure(result, "finish a frame");
  return {};
}

Result<bool> Timeline::reached(std::uint64_t submission) const {
  std::uint64_t value = 0;
  const VkResult result = core_->vk().vkGetSemaphoreCounterValue(core_->device.device, semaphore_.get(), &value);
  if (result != VK_SUCCESS) return vulkanFailure(result, "ask for the frames that are done");
  return value >= submission;
}

}  // namespace honeycomb::Osd
