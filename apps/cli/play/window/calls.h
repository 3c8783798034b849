#pragma once

#include <vulkan/vulkan_core.h>

#include "far/base/result.h"
#include "osd/vulkan/device.h"

/// X(name) for every function of the device that the window calls beyond the renderer's.
#define HONEYCOMB_WINDOW_FUNCTIONS(X) \
  X(vkAcquireNextImageKHR)            \
  X(vkCmdCopyImage)                   \
  X(vkCreateSemaphore)                \
  X(vkCreateSwapchainKHR)             \
  X(vkDestroySemaphore)               \
  X(vkDestroySwapchainKHR)            \
  X(vkGetSwapchainImagesKHR)          \
  X(vkQueuePresentKHR)                \
  X(vkQueueWaitIdle)

/// The same of the instance.
#define HONEYCOMB_WINDOW_INSTANCE_FUNCTIONS(X) \
  X(vkDestroySurfaceKHR)                       \
  X(vkGetPhysicalDeviceSurfaceCapabilitiesKHR) \
  X(vkGetPhysicalDeviceSurfaceFormatsKHR)      \
  X(vkGetPhysicalDeviceSurfaceSupportKHR)

namespace honeycomb::Cli::Play {

/// The window's own table of Vulkan functions.
struct WindowCalls {
#define HONEYCOMB_MEMBER(name) PFN_##name name = nullptr;
  HONEYCOMB_WINDOW_FUNCTIONS(HONEYCOMB_MEMBER)
  HONEYCOMB_WINDOW_INSTANCE_FUNCTIONS(HONEYCOMB_MEMBER)
#undef HONEYCOMB_MEMBER

  /// Errors: of Osd::FunctionLoader.
  static Result<WindowCalls> load(const Osd::VulkanDevice& device);
};

}  // namespace honeycomb::Cli::Play
