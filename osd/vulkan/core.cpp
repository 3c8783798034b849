#include "osd/vulkan/core.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "osd/vulkan/memory_pool.h"

namespace honeycomb::Osd {

namespace {

Result<VulkanLimits> limitsOf(const VkPhysicalDeviceLimits& device, const VulkanEvaluatorOptions& options) {
  std::uint64_t range = device.maxStorageBufferRange;
  if (options.maxStorageBufferRange != 0) range = std::min(range, options.maxStorageBufferRange);
  VulkanLimits limits;
  limits.pageBytes = std::bit_floor(range);
  // Also a multiple of the records in the tables, so that ranges begin at whole records.
  constexpr std::uint64_t kRecordBytes = 32;
  limits.alignment = std::max<std::uint64_t>(device.minStorageBufferOffsetAlignment, kRecordBytes);
  limits.groupsInRow = device.maxComputeWorkGroupCount[0];
  if (options.maxWorkgroupsInRow != 0) limits.groupsInRow = std::min(limits.groupsInRow, options.maxWorkgroupsInRow);
  limits.groupRows = device.maxComputeWorkGroupCount[1];
  limits.texels = device.maxTexelBufferElements;
  if (options.maxTexels != 0) limits.texels = std::min(limits.texels, options.maxTexels);
  limits.sharedBytes = device.maxComputeSharedMemorySize;
  limits.groupSize = std::min(device.maxComputeWorkGroupInvocations, device.maxComputeWorkGroupSize[0]);
  if (limits.pageBytes < 4 * limits.alignment) {
    return fail(
        ErrorCode::invalidOption,
        fmt::format("a storage buffer range of {} bytes is too small: {} is the least for this device's alignment",
                    range, 4 * limits.alignment));
  }
  return limits;
}

// Bindings of one kernel: the pages of its source and six buffers.
constexpr std::uint32_t kStorageBuffers = kSourcePages + 6;

Result<void> checkDevice(const VkPhysicalDeviceProperties& properties) {
  if (properties.apiVersion < VK_API_VERSION_1_2) {
    return fail(ErrorCode::unsupported,
                fmt::format("the Vulkan device '{}' is older than version 1.2: update its driver, "
                            "choose another device or use a CPU backend",
                            properties.deviceName));
  }
  const VkPhysicalDeviceLimits& limits = properties.limits;
  const std::uint32_t buffers =
      std::min(limits.maxPerStageDescriptorStorageBuffers, limits.maxDescriptorSetStorageBuffers);
  if (buffers < kStorageBuffers || limits.maxComputeWorkGroupInvocations < kWorkgroupSize) {
    return fail(
        ErrorCode::unsupported,
        fmt::format(
            "the Vulkan device '{}' binds {} storage buffers and runs {} invocations a workgroup, {} and {} are "
            "needed: choose another device or use a CPU backend",
            properties.deviceName, buffers, limits.maxComputeWorkGroupInvocations, kStorageBuffers, kWorkgroupSize));
  }
  return {};
}

// A property of the physical device may be asked for where it has the extension, whether the device enabled it or not.
Result<bool> hasExtension(const VulkanCore& core, const char* name) {
  std::uint32_t count = 0;
  const auto list = core.vk().vkEnumerateDeviceExtensionProperties;
  if (const VkResult result = list(core.device.physicalDevice, nullptr, &count, nullptr); result != VK_SUCCESS) {
    return vulkanFailure(result, "list the device's extensions");
  }
  std::vector<VkExtensionProperties> extensions(count);
  if (const VkResult result = list(core.device.physicalDevice, nullptr, &count, extensions.data());
      result < VK_SUCCESS) {
    return vulkanFailure(result, "list the device's extensions");
  }
  return std::any_of(extensions.begin(), extensions.end(), [name](const VkExtensionProperties& extension) {
    return std::strcmp(extension.extensionName, name) == 0;
  });
}

}  // namespace

Result<VulkanCore> VulkanCore::create(const VulkanDevice& device, const VulkanEvaluatorOptions& options) {
  if (device.physicalDevice == VK_NULL_HANDLE || device.queue == VK_NULL_HANDLE) {
    return fail(ErrorCode::invalidOption, "a VulkanDevice needs a physical device and a queue");
  }
  if ((device.queueLock.take == nullptr) != (device.queueLock.give == nullptr)) {
    return fail(ErrorCode::invalidOption,
                "the lock of the Vulkan device's queue has one function of two: give both, or neither");
  }
  auto functions = VulkanFunctions::load(device);
  if (!functions) return tl::unexpected(functions.error());
  VkPhysicalDeviceSubgroupProperties subgroups{};
  subgroups.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &subgroups;
  functions->vkGetPhysicalDeviceProperties2(device.physicalDevice, &properties);
  if (const auto sound = checkDevice(properties.properties); !sound) return tl::unexpected(sound.error());
  const auto limits = limitsOf(properties.properties.limits, options);
  if (!limits) return tl::unexpected(limits.error());
  VulkanCore core;
  core.device = device;
  core.functions = *functions;
  core.options = options;
  core.limits = *limits;
  core.subgroupSize = subgroups.subgroupSize;
  core.type = properties.properties.deviceType;
  core.pool = std::make_shared<MemoryPool>();
  const auto tellsBudget = hasExtension(core, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
  if (!tellsBudget) return tl::unexpected(tellsBudget.error());
  core.tellsBudget = *tellsBudget;
  VkPhysicalDeviceMemoryProperties2 memory{};
  memory.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2;
  core.functions.vkGetPhysicalDeviceMemoryProperties2(device.physicalDevice, &memory);
  core.memory = memory.memoryProperties;
  return core;
}

}  // namespace honeycomb::Osd
