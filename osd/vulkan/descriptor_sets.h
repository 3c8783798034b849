#pragma once

#include <cstdint>
#include <vector>

#include "osd/vulkan/core.h"
#include "osd/vulkan/handles.h"

namespace honeycomb::Osd {

/// Descriptor sets of the layout that all kernels share, with the pool they are from. They may be written and used as
/// long as it lives.
struct DescriptorSets {
  DeviceHandle<VkDescriptorPool> pool;
  std::vector<VkDescriptorSet> sets;

  /// Errors: outOfMemory.
  static Result<DescriptorSets> create(const VulkanCore& core, VkDescriptorSetLayout layout, std::uint32_t count);
};

}  // namespace honeycomb::Osd
