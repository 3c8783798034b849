#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <string>
#include <vector>

#include "far/base/result.h"

namespace honeycomb::Osd {

/// One Vulkan device of the machine, as `honeycomb info` shows it.
struct DeviceInfo {
  std::string name{};
  VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
  std::uint32_t apiVersion = 0;             ///< as by VK_MAKE_API_VERSION
  std::uint64_t maxStorageBufferRange = 0;  ///< bytes
  std::uint64_t heapSize = 0;               ///< bytes of the largest device-local heap
  std::uint32_t subgroupSize = 0;           ///< invocations
  std::uint32_t maxWorkgroupInvocations = 0;
  std::uint32_t sharedMemorySize = 0;  ///< bytes a workgroup
};

/// "discrete", "integrated", "virtual", "cpu" or "other".
const char* deviceTypeName(VkPhysicalDeviceType type);

/// The Vulkan devices of the machine in the driver's order. An empty list is no error; a missing loader is noDevice.
Result<std::vector<DeviceInfo>> listDevices();

/// Which of the devices `wanted` means: "auto" (discrete before integrated, virtual and cpu; the first of equals), an
/// index into the list, or a part of a name in any case. Fails with noDevice and names what there is.
Result<std::size_t> chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& wanted);

}  // namespace honeycomb::Osd
