#include "osd/vulkan/functions.h"

#include <mutex>

namespace honeycomb::Osd {

namespace {

// volk keeps what it loads in globals; everything that touches them happens under this lock.
std::mutex& volkMutex() {
  static std::mutex mutex;
  return mutex;
}

Result<PFN_vkGetInstanceProcAddr> initializeVolk() {
  if (volkInitialize() != VK_SUCCESS) {
    return fail(
        ErrorCode::noDevice,
        "no Vulkan loader found: install libvulkan1 and a driver such as mesa-vulkan-drivers, or use a CPU backend");
  }
  return vkGetInstanceProcAddr;
}

template <class Function>
void loadInstanceFunction(PFN_vkGetInstanceProcAddr get, VkInstance instance, const char* name, Function& function) {
  function = reinterpret_cast<Function>(get(instance, name));
}

}  // namespace

Result<PFN_vkGetInstanceProcAddr> loadVulkan() {
  const std::lock_guard lock(volkMutex());
  return initializeVolk();
}

Result<VulkanFunctions> VulkanFunctions::load(VkInstance instance, VkDevice device) {
  if (instance == VK_NULL_HANDLE || device == VK_NULL_HANDLE) {
    return fail(ErrorCode::invalidOption, "a VulkanDevice needs an instance and a device");
  }
  const std::lock_guard lock(volkMutex());
  const auto get = initializeVolk();
  if (!get) return tl::unexpected(get.error());
  volkLoadInstanceOnly(instance);
  VulkanFunctions functions;
  loadInstanceFunction(*get, instance, "vkGetPhysicalDeviceProperties2", functions.getPhysicalDeviceProperties2);
  loadInstanceFunction(*get, instance, "vkGetPhysicalDeviceMemoryProperties",
                       functions.getPhysicalDeviceMemoryProperties);
  volkLoadDeviceTable(&functions.device, device);
  if (functions.getPhysicalDeviceProperties2 == nullptr || functions.device.vkCreateBuffer == nullptr) {
    return fail(ErrorCode::unsupported,
                "the Vulkan instance must be of version 1.1 or later: update the Vulkan driver");
  }
  return functions;
}

}  // namespace honeycomb::Osd
