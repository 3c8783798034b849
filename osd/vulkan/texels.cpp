#include "osd/vulkan/texels.h"

namespace honeycomb::Osd {

Result<DeviceHandle<VkBufferView>> viewTexels(const VulkanCore& core, const VulkanBuffer& buffer, VkFormat format,
                                              std::uint64_t texels) {
  VkBufferViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
  info.buffer = buffer.handle();
  info.format = format;
  info.range = texels * kTexelBytes;
  return core.make(core.vk().vkCreateBufferView, core.vk().vkDestroyBufferView, info, "create a view of a buffer");
}

}  // namespace honeycomb::Osd
