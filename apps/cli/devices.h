#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "far/base/result.h"

namespace honeycomb::Cli {

/// A Vulkan device and the limits that bound what it can refine.
struct VulkanDeviceInfo {
  std::string name;
  std::string type;                     ///< "discrete", "integrated", "virtual", "cpu" or "other"
  std::string version;                  ///< of Vulkan, "1.3.239"
  std::int64_t memory = 0;              ///< bytes of its largest device-local heap
  std::int64_t storageBufferRange = 0;  ///< bytes a shader sees of one buffer at a time
  std::int64_t workgroupInvocations = 0;
  std::int64_t subgroupSize = 0;  ///< invocations
  std::int64_t sharedMemory = 0;  ///< bytes a workgroup
};

/// The Vulkan devices of the machine. Errors: noDevice, when there is no loader, no driver, or this build has no
/// Vulkan.
Result<std::vector<VulkanDeviceInfo>> vulkanDevices();

}  // namespace honeycomb::Cli
