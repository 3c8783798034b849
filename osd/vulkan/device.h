#pragma once

#include <volk.h>

#include <cstdint>

namespace honeycomb::Osd {

/// A Vulkan device somebody owns: the caller's engine, or a VulkanContext. All handles outlive what is created from
/// them.
struct VulkanDevice {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;  ///< supports compute, and graphics where pictures are drawn
  std::uint32_t queueFamily = 0;
};

}  // namespace honeycomb::Osd
