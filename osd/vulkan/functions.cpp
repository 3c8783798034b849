#include "osd/vulkan/functions.h"

#include <fmt/format.h>

#include "osd/vulkan/loader.h"

namespace honeycomb::Osd {

Result<FunctionLoader> FunctionLoader::create(const VulkanDevice& device) {
  if (device.instance == VK_NULL_HANDLE || device.device == VK_NULL_HANDLE) {
    return fail(ErrorCode::invalidOption, "a VulkanDevice needs an instance and a device");
  }
  FunctionLoader loader;
  loader.instance_ = device.instance;
  loader.device_ = device.device;
  loader.getInstance_ = device.getInstanceProcAddr;
  if (loader.getInstance_ == nullptr) {
    const auto get = loadVulkan();
    if (!get) return tl::unexpected(get.error());
    loader.getInstance_ = *get;
  }
  loader.getDevice_ = device.getDeviceProcAddr;
  if (loader.getDevice_ == nullptr) loader.ofInstance("vkGetDeviceProcAddr", loader.getDevice_);
  if (const auto found = loader.found(); !found) return tl::unexpected(found.error());
  return loader;
}

Result<void> FunctionLoader::found() const {
  if (missing_.empty()) return {};
  return fail(ErrorCode::unsupported,
              fmt::format("the Vulkan device has no function {}: update its driver to Vulkan 1.2 or later, check the "
                          "getInstanceProcAddr and getDeviceProcAddr given, or use a CPU backend",
                          missing_));
}

Result<VulkanFunctions> VulkanFunctions::load(const VulkanDevice& device) {
  auto loader = FunctionLoader::create(device);
  if (!loader) return tl::unexpected(loader.error());
  VulkanFunctions functions;
#define HONEYCOMB_LOAD(name) loader->ofInstance(#name, functions.name);
  HONEYCOMB_VULKAN_INSTANCE_FUNCTIONS(HONEYCOMB_LOAD)
#undef HONEYCOMB_LOAD
#define HONEYCOMB_LOAD(name) loader->ofDevice(#name, functions.name);
  HONEYCOMB_VULKAN_DEVICE_FUNCTIONS(HONEYCOMB_LOAD)
#undef HONEYCOMB_LOAD
  if (const auto found = loader->found(); !found) return tl::unexpected(found.error());
  return functions;
}

}  // namespace honeycomb::Osd
