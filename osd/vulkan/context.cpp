#include "osd/vulkan/context.h"

#include <fmt/format.h>

#include <utility>

#include "osd/vulkan/errors.h"
#include "osd/vulkan/guard.h"
#include "osd/vulkan/instance.h"

namespace honeycomb::Osd {

namespace {

// The features that are switched on where present, as one chain.
struct FeatureChain {
  VkPhysicalDeviceFeatures2 core{};
  VkPhysicalDeviceVulkan12Features v12{};
  VkPhysicalDeviceVulkan13Features v13{};

  explicit FeatureChain(std::uint32_t apiVersion) {
    core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    core.pNext = &v12;
    if (apiVersion >= VK_API_VERSION_1_3) v12.pNext = &v13;
  }
  FeatureChain(const FeatureChain&) = delete;
  FeatureChain& operator=(const FeatureChain&) = delete;

  void enableWhatOf(const FeatureChain& present) {
    core.features.fillModeNonSolid = present.core.features.fillModeNonSolid;
    core.features.wideLines = present.core.features.wideLines;
    core.features.shaderInt64 = present.core.features.shaderInt64;
    v12.timelineSemaphore = present.v12.timelineSemaphore;
    v12.scalarBlockLayout = present.v12.scalarBlockLayout;
    v13.dynamicRendering = present.v13.dynamicRendering;
    v13.synchronization2 = present.v13.synchronization2;
    v13.subgroupSizeControl = present.v13.subgroupSizeControl;
    v13.computeFullSubgroups = present.v13.computeFullSubgroups;
  }
};

}  // namespace

bool longStoresPay() {
#if defined(__x86_64__)
  return __builtin_cpu_is("intel") == 0 || __builtin_cpu_supports("avx512f") == 0;
#else
  return true;
#endif
}

Result<VulkanContext> VulkanContext::create(const VulkanContextOptions& options) {
  return guarded([&]() -> Result<VulkanContext> {
    VulkanContext context;
    if (options.validation || options.deviceValidation) context.log_ = std::make_shared<ValidationLog>();
    auto instance = VulkanInstance::create(context.log_, {.extensions = options.instanceExtensions,
                                                          .allocator = options.allocator,
                                                          .onDevice = options.deviceValidation});
    if (!instance) return tl::unexpected(instance.error());
    context.instance_ = std::move(*instance);
    context.device_.instance = context.instance_->handle();
    context.device_.allocator = options.allocator;
    context.device_.getInstanceProcAddr = context.instance_->getProcAddr();

    const auto physical = context.instance_->physicalDevices();
    if (!physical) return tl::unexpected(physical.error());
    std::vector<DeviceInfo> infos;
    for (const VkPhysicalDevice device : *physical) infos.push_back(context.instance_->describe(device));
    const auto chosen = chooseDevice(infos, options.device);
    if (!chosen) return tl::unexpected(chosen.error());
    context.info_ = infos[*chosen];
    context.device_.physicalDevice = (*physical)[*chosen];
    if (const auto family = context.chooseQueueFamily(); !family) return tl::unexpected(family.error());
    if (const auto made = context.makeDevice(options); !made) return tl::unexpected(made.error());
    context.makeQueueLock();
    return context;
  });
}

Result<void> VulkanContext::chooseQueueFamily() {
  if (info_.apiVersion < VK_API_VERSION_1_2) {
    return fail(
        ErrorCode::unsupported,
        fmt::format("the Vulkan device '{}' is older than version 1.2: update its driver, or choose another device",
                    info_.name));
  }
  const auto query =
      instance_->function<PFN_vkGetPhysicalDeviceQueueFamilyProperties>("vkGetPhysicalDeviceQueueFamilyProperties");
  std::uint32_t count = 0;
  query(device_.physicalDevice, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  query(device_.physicalDevice, &count, families.data());
  bool found = false;
  for (std::uint32_t i = 0; i < count && !graphics_; ++i) {
    const VkQueueFlags flags = families[i].queueFlags;
    if ((flags & VK_QUEUE_COMPUTE_BIT) == 0) continue;
    graphics_ = (flags & VK_QUEUE_GRAPHICS_BIT) != 0;
    if (!found || graphics_) device_.queueFamily = i;
    found = true;
  }
  if (!found) {
    return fail(ErrorCode::noDevice,
                fmt::format("the Vulkan device '{}' has no compute queue: choose another device", info_.name));
  }
  return {};
}

void VulkanContext::makeQueueLock() {
  queueMutex_ = std::make_unique<std::mutex>();
  device_.queueLock = {[](void* mutex) { static_cast<std::mutex*>(mutex)->lock(); },
                       [](void* mutex) { static_cast<std::mutex*>(mutex)->unlock(); }, queueMutex_.get()};
}

Result<void> VulkanContext::makeDevice(const VulkanContextOptions& options) {
  FeatureChain present(info_.apiVersion);
  instance_->function<PFN_vkGetPhysicalDeviceFeatures2>("vkGetPhysicalDeviceFeatures2")(device_.physicalDevice,
                                                                                        &present.core);
  FeatureChain enabled(info_.apiVersion);
  enabled.enableWhatOf(present);
  dynamicRendering_ = enabled.v13.dynamicRendering == VK_TRUE;
  device_.timelineSemaphore = enabled.v12.timelineSemaphore == VK_TRUE;
  device_.fullSubgroups = enabled.v13.subgroupSizeControl == VK_TRUE && enabled.v13.computeFullSubgroups == VK_TRUE;
  device_.longStores =
      enabled.core.features.shaderInt64 == VK_TRUE && enabled.v12.scalarBlockLayout == VK_TRUE && longStoresPay();

  const float priority = 1.0F;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = device_.queueFamily;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &enabled.core;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(options.deviceExtensions.size());
  info.ppEnabledExtensionNames = options.deviceExtensions.data();
  const VkResult result = instance_->function<PFN_vkCreateDevice>("vkCreateDevice")(device_.physicalDevice, &info,
                                                                                    device_.allocator, &device_.device);
  if (result != VK_SUCCESS) return vulkanFailure(result, "create a device");
  instance_->function<PFN_vkGetDeviceQueue>("vkGetDeviceQueue")(device_.device, device_.queueFamily, 0, &device_.queue);
  VkPhysicalDeviceProperties properties{};
  instance_->function<PFN_vkGetPhysicalDeviceProperties>("vkGetPhysicalDeviceProperties")(device_.physicalDevice,
                                                                                          &properties);
  limits_ = properties.limits;
  return {};
}

VulkanContext::VulkanContext(VulkanContext&& other) noexcept
    : log_(std::move(other.log_)),
      instance_(std::move(other.instance_)),
      queueMutex_(std::move(other.queueMutex_)),
      device_(std::exchange(other.device_, {})),
      info_(std::move(other.info_)),
      limits_(other.limits_),
      graphics_(other.graphics_),
      dynamicRendering_(other.dynamicRendering_) {}

VulkanContext& VulkanContext::operator=(VulkanContext&& other) noexcept {
  std::swap(log_, other.log_);
  std::swap(instance_, other.instance_);
  std::swap(queueMutex_, other.queueMutex_);
  std::swap(device_, other.device_);
  std::swap(info_, other.info_);
  std::swap(limits_, other.limits_);
  std::swap(graphics_, other.graphics_);
  std::swap(dynamicRendering_, other.dynamicRendering_);
  return *this;
}

VulkanContext::~VulkanContext() {
  if (device_.device == VK_NULL_HANDLE) return;
  instance_->function<PFN_vkDestroyDevice>("vkDestroyDevice")(device_.device, device_.allocator);
}

std::vector<std::string> VulkanContext::messages() const {
  return log_ ? log_->messages() : std::vector<std::string>{};
}

}  // namespace honeycomb::Osd
