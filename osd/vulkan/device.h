#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace honeycomb::Osd {

/// How threads take turns at a queue. Vulkan wants a queue used by one thread at a time (external synchronization, in
/// vkQueueSubmit and vkQueuePresentKHR). Both functions or neither; they are called in pairs, never nested, from any
/// thread, with nothing but one vkQueueSubmit in between: no wait for the device. They must not throw.
struct VulkanQueueLock {
  void (*take)(void* owner) = nullptr;  ///< returns when nobody else uses the queue
  void (*give)(void* owner) = nullptr;  ///< others may use it again
  void* owner = nullptr;                ///< passed on to both

  bool given() const { return take != nullptr; }
  /// What std::lock_guard calls, on the caller's side as on ours.
  void lock() const {
    if (take != nullptr) take(owner);
  }
  void unlock() const {
    if (give != nullptr) give(owner);
  }
};

/// Is a device that is this machine's CPU faster with VulkanDevice::longStores? With lavapipe a tenth (AMD, AVX-512);
/// no where its 512-bit vectors are slow to read back from the stack in parts (Intel with AVX-512: 10 to 25 % slower).
bool longStoresPay();

/// A Vulkan device somebody owns: the caller's engine, or a VulkanContext. All handles, and what `allocator` points to,
/// outlive what is created from them.
struct VulkanDevice {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  /// Supports compute, and graphics where pictures are drawn. Uploads, sessions and frames submit to it; record()
  /// doesn't: what it records may be submitted to any queue of the family. An engine that uploads while it draws does
  /// so on a thread of its own and uses the table once upload() has returned; here it gives another queue of the same
  /// family than it draws with, or the same one with `queueLock`, which it takes around its own use. A family with
  /// transfers alone is not made use of: buffers belong to this family throughout, and tables are uploaded once per
  /// mesh, not per frame.
  VkQueue queue = VK_NULL_HANDLE;
  std::uint32_t queueFamily = 0;
  bool timelineSemaphore = false;  ///< was this feature switched on with the device? VulkanFrames needs it
  /// Were subgroupSizeControl and computeFullSubgroups (Vulkan 1.3) switched on with the device? Not needed; devices
  /// that are CPUs evaluate tiles with them in a tenth less time, since a workgroup is then sure to be one subgroup.
  bool fullSubgroups = false;
  /// Were shaderInt64 and scalarBlockLayout switched on with the device, and should they be used (longStoresPay())? Not
  /// needed; devices that are CPUs write the points of tiles two numbers a store with them.
  bool longStores = false;
  /// Host memory of every object that is created from this device; null: the driver's own. Not for the device itself.
  const VkAllocationCallbacks* allocator = nullptr;
  /// Where functions are looked up; null: in the machine's Vulkan loader, opened when first needed.
  PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
  /// The same of the device's functions; null: what getInstanceProcAddr says.
  PFN_vkGetDeviceProcAddr getDeviceProcAddr = nullptr;
  /// Taken around everything that is submitted to `queue`; none: nobody else may use the queue meanwhile.
  VulkanQueueLock queueLock{};
};

}  // namespace honeycomb::Osd
