#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace honeycomb::Osd {

/// A Vulkan device somebody owns: the caller's engine, or a VulkanContext. All handles, and what `allocator` points to,
/// outlive what is created from them.
struct VulkanDevice {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;  ///< supports compute, and graphics where pictures are drawn
  std::uint32_t queueFamily = 0;
  bool timelineSemaphore = false;  ///< was this feature switched on with the device? VulkanFrames needs it
  /// Host memory of every object that is created from this device; null: the driver's own. Not for the device itself.
  const VkAllocationCallbacks* allocator = nullptr;
  /// Where functions are looked up; null: in the machine's Vulkan loader, opened when first needed.
  PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
  /// The same of the device's functions; null: what getInstanceProcAddr says.
  PFN_vkGetDeviceProcAddr getDeviceProcAddr = nullptr;
};

}  // namespace honeycomb::Osd
