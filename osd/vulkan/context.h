#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "osd/vulkan/device.h"
#include "osd/vulkan/device_info.h"

namespace honeycomb::Osd {

class VulkanInstance;
class ValidationLog;

/// What a VulkanContext is made of.
struct VulkanContextOptions {
  std::string device = "auto";  ///< see chooseDevice
  bool validation = false;      ///< run under the validation layer with synchronization checks
  /// Run under the validation layer with checks of every access by the device itself instead (GPU-assisted): slow, but
  /// sees what a kernel reads and writes past its buffers. robustBufferAccess, which would hide it, is never on.
  bool deviceValidation = false;
  std::vector<const char*> instanceExtensions{};  ///< more than the context needs itself, such as for a window
  std::vector<const char*> deviceExtensions{};
  /// Host memory of instance and device, and of what is created from device(); outlives them. Null: the driver's own.
  const VkAllocationCallbacks* allocator = nullptr;
};

/// An instance, a device and a queue for those who have none. The queue supports compute, and graphics where the device
/// has such a family. Of the optional features those are on, where present, that drawing from the results needs:
/// dynamicRendering, synchronization2, timelineSemaphore, scalarBlockLayout, fillModeNonSolid, wideLines; and those
/// that tiles are faster with (VulkanDevice::fullSubgroups, longStores): subgroupSizeControl, computeFullSubgroups,
/// shaderInt64.
/// Outlives everything created from device().
class VulkanContext {
 public:
  /// Errors: noDevice (no loader, no device, no match, no compute queue), unsupported (validation layer or an extension
  /// missing, Vulkan older than 1.2).
  static Result<VulkanContext> create(const VulkanContextOptions& options = {});
  ~VulkanContext();
  VulkanContext(VulkanContext&& other) noexcept;
  VulkanContext& operator=(VulkanContext&& other) noexcept;

  /// With a queueLock: several threads may submit to the queue, each under std::lock_guard(device().queueLock).
  const VulkanDevice& device() const { return device_; }
  const DeviceInfo& info() const { return info_; }
  const std::string& deviceName() const { return info_.name; }
  /// Limits of the device.
  const VkPhysicalDeviceLimits& limits() const { return limits_; }
  /// Does the queue also draw?
  bool supportsGraphics() const { return graphics_; }
  /// Is dynamicRendering on?
  bool supportsDynamicRendering() const { return dynamicRendering_; }

  /// Warnings and errors of the validation layer so far; empty without validation. Safe from any thread.
  std::vector<std::string> messages() const;
  /// The log itself, which outlives the context and so also has what was said at its end. Null without validation.
  std::shared_ptr<const ValidationLog> validationLog() const { return log_; }

 private:
  VulkanContext() = default;
  Result<void> chooseQueueFamily();
  void makeQueueLock();
  Result<void> makeDevice(const VulkanContextOptions& options);

  std::shared_ptr<ValidationLog> log_;
  std::unique_ptr<VulkanInstance> instance_;
  std::unique_ptr<std::mutex> queueMutex_;
  VulkanDevice device_;
  DeviceInfo info_;
  VkPhysicalDeviceLimits limits_{};
  bool graphics_ = false;
  bool dynamicRendering_ = false;
};

}  // namespace honeycomb::Osd
