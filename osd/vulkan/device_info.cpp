#include "osd/vulkan/device_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "osd/vulkan/guard.h"
#include "osd/vulkan/instance.h"

namespace honeycomb::Osd {

const char* deviceTypeName(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "cpu";
    default:
      return "other";
  }
}

DeviceInfo VulkanInstance::describe(VkPhysicalDevice device) const {
  VkPhysicalDeviceSubgroupProperties subgroup{};
  subgroup.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &subgroup;
  function<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2")(device, &properties);
  VkPhysicalDeviceMemoryProperties memory{};
  function<PFN_vkGetPhysicalDeviceMemoryProperties>("vkGetPhysicalDeviceMemoryProperties")(device, &memory);
  const VkPhysicalDeviceProperties& p = properties.properties;
  DeviceInfo info{.name = p.deviceName,
                  .type = p.deviceType,
                  .apiVersion = p.apiVersion,
                  .maxStorageBufferRange = p.limits.maxStorageBufferRange,
                  .subgroupSize = subgroup.subgroupSize,
                  .maxWorkgroupInvocations = p.limits.maxComputeWorkGroupInvocations,
                  .sharedMemorySize = p.limits.maxComputeSharedMemorySize};
  for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
    if ((memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) == 0) continue;
    info.heapSize = std::max<std::uint64_t>(info.heapSize, memory.memoryHeaps[i].size);
  }
  return info;
}

Result<std::vector<DeviceInfo>> listDevices() {
  return guarded([&]() -> Result<std::vector<DeviceInfo>> {
    const auto instance = VulkanInstance::create(nullptr, {});
    if (!instance) return tl::unexpected(instance.error());
    const auto devices = (*instance)->physicalDevices();
    if (!devices) return tl::unexpected(devices.error());
    std::vector<DeviceInfo> infos;
    for (const VkPhysicalDevice device : *devices) infos.push_back((*instance)->describe(device));
    return infos;
  });
}

namespace {

// Smaller is preferred.
int rankOf(VkPhysicalDeviceType type) {
  constexpr std::array kOrder = {VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU,
                                 VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU, VK_PHYSICAL_DEVICE_TYPE_CPU};
  return static_cast<int>(std::find(kOrder.begin(), kOrder.end(), type) - kOrder.begin());
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string namesOf(const std::vector<DeviceInfo>& devices) {
  std::string names;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    names += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, devices[i].name);
  }
  return names;
}

}  // namespace

Result<std::size_t> chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& wanted) {
  if (devices.empty()) {
    return fail(ErrorCode::noDevice,
                "no Vulkan device found: install a driver such as mesa-vulkan-drivers, or use a CPU backend");
  }
  if (wanted == "auto") {
    const auto better = [](const DeviceInfo& a, const DeviceInfo& b) { return rankOf(a.type) < rankOf(b.type); };
    return static_cast<std::size_t>(std::min_element(devices.begin(), devices.end(), better) - devices.begin());
  }
  std::size_t index = 0;
  const auto [end, status] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (status == std::errc() && end == wanted.data() + wanted.size() && index < devices.size()) return index;
  for (std::size_t i = 0; i < devices.size() && !wanted.empty(); ++i) {
    if (lower(devices[i].name).find(lower(wanted)) != std::string::npos) return i;
  }
  return fail(ErrorCode::noDevice,
              fmt::format("no Vulkan device matches '{}': give 'auto', an index or a part of a name of {}", wanted,
                          namesOf(devices)));
}

}  // namespace honeycomb::Osd
