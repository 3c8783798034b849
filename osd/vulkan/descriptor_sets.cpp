#include "osd/vulkan/descriptor_sets.h"

#include <algorithm>
#include <array>

#include "osd/vulkan/errors.h"
#include "osd/vulkan/kernels.h"

namespace honeycomb::Osd {

namespace {

Result<DeviceHandle<VkDescriptorPool>> makePool(const VulkanCore& core, std::uint32_t sets) {
  const std::uint32_t count = std::max(1U, sets);
  const std::array sizes{VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, count * (kSourcePages + kSlotCount)},
                         VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, count},
                         VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER, count}};
  VkDescriptorPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  info.maxSets = count;
  info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  info.pPoolSizes = sizes.data();
  return core.make(core.vk().vkCreateDescriptorPool, core.vk().vkDestroyDescriptorPool, info,
                   "create a descriptor pool");
}

}  // namespace

Result<DescriptorSets> DescriptorSets::create(const VulkanCore& core, VkDescriptorSetLayout layout,
                                              std::uint32_t count) {
  DescriptorSets made;
  auto pool = makePool(core, count);
  if (!pool) return tl::unexpected(pool.error());
  made.pool = std::move(*pool);
  made.sets.resize(count);
  if (count == 0) return made;
  const std::vector<VkDescriptorSetLayout> layouts(count, layout);
  VkDescriptorSetAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  info.descriptorPool = made.pool.get();
  info.descriptorSetCount = count;
  info.pSetLayouts = layouts.data();
  const VkResult result = core.vk().vkAllocateDescriptorSets(core.device.device, &info, made.sets.data());
  if (result != VK_SUCCESS) return vulkanFailure(result, "allocate descriptor sets");
  return made;
}

}  // namespace honeycomb::Osd
