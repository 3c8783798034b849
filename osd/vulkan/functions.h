#pragma once

#include <volk.h>

#include "far/base/result.h"

namespace honeycomb::Osd {

/// The Vulkan functions of one instance and one device. Every evaluator and context has its own: volk's global pointers
/// belong to whoever loaded them last.
struct VulkanFunctions {
  PFN_vkGetPhysicalDeviceProperties2 getPhysicalDeviceProperties2 = nullptr;
  PFN_vkGetPhysicalDeviceMemoryProperties getPhysicalDeviceMemoryProperties = nullptr;
  VolkDeviceTable device{};

  /// Loads the functions. Fails with noDevice when the Vulkan loader isn't installed, invalidOption for null handles.
  /// May be called from several threads at once.
  static Result<VulkanFunctions> load(VkInstance instance, VkDevice device);
};

/// vkGetInstanceProcAddr of the Vulkan loader; noDevice when there is none.
Result<PFN_vkGetInstanceProcAddr> loadVulkan();

}  // namespace honeycomb::Osd
