#pragma once

#include <vulkan/vulkan_core.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "osd/vulkan/device_info.h"

namespace honeycomb::Osd {

/// What the validation layer said. Threads may add and read at once.
class ValidationLog {
 public:
  void add(std::string message) {
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
  }
  std::vector<std::string> messages() const {
    const std::lock_guard lock(mutex_);
    return messages_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> messages_;
};

struct VulkanInstanceOptions {
  std::vector<const char*> extensions{};
  const VkAllocationCallbacks* allocator = nullptr;  ///< outlives the instance
  bool onDevice = false;                             ///< validation checks accesses on the device
};

/// A Vulkan instance and, when asked, its validation messenger. Stays where it was made: drivers point to it.
class VulkanInstance {
 public:
  /// With a log: validation, of synchronization or of accesses on the device, messages into the log; `unsupported`
  /// without the layer.
  static Result<std::unique_ptr<VulkanInstance>> create(std::shared_ptr<ValidationLog> log,
                                                        const VulkanInstanceOptions& options);
  ~VulkanInstance();
  VulkanInstance(const VulkanInstance&) = delete;
  VulkanInstance& operator=(const VulkanInstance&) = delete;

  VkInstance handle() const { return instance_; }
  PFN_vkGetInstanceProcAddr getProcAddr() const { return getProc_; }

  /// A function of this instance by its prototype's name; null when the instance lacks it.
  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(getProc_(instance_, name));
  }

  Result<std::vector<VkPhysicalDevice>> physicalDevices() const;
  DeviceInfo describe(VkPhysicalDevice device) const;

 private:
  VulkanInstance(PFN_vkGetInstanceProcAddr getProc, std::shared_ptr<ValidationLog> log,
                 const VkAllocationCallbacks* allocator)
      : getProc_(getProc), log_(std::move(log)), allocator_(allocator) {}
  VkResult makeInstance(const VulkanInstanceOptions& options);
  VkResult makeMessenger();

  PFN_vkGetInstanceProcAddr getProc_;
  std::shared_ptr<ValidationLog> log_;
  const VkAllocationCallbacks* allocator_ = nullptr;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

}  // namespace honeycomb::Osd
