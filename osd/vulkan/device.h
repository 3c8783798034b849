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
  /// Supports compute, and graphics where pictures are drawn. Uploads, sessions and frames submit to it; record()
  /// doesn't: what it records may be submitted to any queue of the family. An engine that uploads while it draws gives
  /// another queue of the same family here than it draws with, uploads on a thread of its own, and uses the table once
  /// upload() has returned. A family with transfers alone is not made use of: buffers belong to this family throughout,
  /// and tables are uploaded once per mesh, not per frame.
  VkQueue queue = VK_NULL_HANDLE;
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
