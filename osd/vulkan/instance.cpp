#include "osd/vulkan/instance.h"

#include <algorithm>
#include <cstring>

#include "osd/vulkan/errors.h"
#include "osd/vulkan/loader.h"

namespace honeycomb::Osd {

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL receiveMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                              const VkDebugUtilsMessengerCallbackDataEXT* data, void* log) {
  static_cast<ValidationLog*>(log)->add(data->pMessage);
  return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationLog* log) {
  VkDebugUtilsMessengerCreateInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  info.pfnUserCallback = receiveMessage;
  info.pUserData = log;
  return info;
}

bool layerPresent(PFN_vkGetInstanceProcAddr getProc, const char* name) {
  const auto enumerate = reinterpret_cast<PFN_vkEnumerateInstanceLayerProperties>(
      getProc(VK_NULL_HANDLE, "vkEnumerateInstanceLayerProperties"));
  std::uint32_t count = 0;
  if (enumerate == nullptr || enumerate(&count, nullptr) != VK_SUCCESS) return false;
  std::vector<VkLayerProperties> layers(count);
  if (enumerate(&count, layers.data()) < VK_SUCCESS) return false;
  return std::any_of(layers.begin(), layers.end(),
                     [name](const VkLayerProperties& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

}  // namespace

Result<std::unique_ptr<VulkanInstance>> VulkanInstance::create(std::shared_ptr<ValidationLog> log,
                                                               const VulkanInstanceOptions& options) {
  const auto getProc = loadVulkan();
  if (!getProc) return tl::unexpected(getProc.error());
  if (log && !layerPresent(*getProc, kValidationLayer)) {
    return fail(ErrorCode::unsupported,
                "the layer VK_LAYER_KHRONOS_validation isn't installed: install vulkan-validationlayers, or create the "
                "context without validation");
  }
  std::unique_ptr<VulkanInstance> instance(new VulkanInstance(*getProc, std::move(log), options.allocator));
  if (const VkResult result = instance->makeInstance(options); result != VK_SUCCESS) {
    return vulkanFailure(result, "create an instance");
  }
  if (const VkResult result = instance->makeMessenger(); result != VK_SUCCESS) {
    return vulkanFailure(result, "create a debug messenger");
  }
  return instance;
}

VkResult VulkanInstance::makeInstance(const VulkanInstanceOptions& options) {
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.pEngineName = "honeycomb";
  application.apiVersion = VK_API_VERSION_1_3;
  std::vector<const char*> names = options.extensions;
  if (log_) names.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;

  // Chained to the instance, the messenger also hears what is said while the instance is made and destroyed.
  // Both at once the layer advises against.
  const VkValidationFeatureEnableEXT enabled = options.onDevice
                                                   ? VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT
                                                   : VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  VkValidationFeaturesEXT features{};
  features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = &enabled;
  VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(log_.get());
  if (log_) {
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &kValidationLayer;
    features.pNext = &messenger;
    info.pNext = &features;
  }
  info.enabledExtensionCount = static_cast<std::uint32_t>(names.size());
  info.ppEnabledExtensionNames = names.data();
  return function<PFN_vkCreateInstance>("vkCreateInstance")(&info, allocator_, &instance_);
}

VkResult VulkanInstance::makeMessenger() {
  if (!log_) return VK_SUCCESS;
  const auto createMessenger = function<PFN_vkCreateDebugUtilsMessengerEXT>("vkCreateDebugUtilsMessengerEXT");
  if (createMessenger == nullptr) return VK_ERROR_EXTENSION_NOT_PRESENT;
  const VkDebugUtilsMessengerCreateInfoEXT info = messengerInfo(log_.get());
  return createMessenger(instance_, &info, allocator_, &messenger_);
}

VulkanInstance::~VulkanInstance() {
  if (instance_ == VK_NULL_HANDLE) return;
  if (messenger_ != VK_NULL_HANDLE) {
    function<PFN_vkDestroyDebugUtilsMessengerEXT>("vkDestroyDebugUtilsMessengerEXT")(instance_, messenger_, allocator_);
  }
  function<PFN_vkDestroyInstance>("vkDestroyInstance")(instance_, allocator_);
}

Result<std::vector<VkPhysicalDevice>> VulkanInstance::physicalDevices() const {
  const auto enumerate = function<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices");
  std::uint32_t count = 0;
  if (const VkResult result = enumerate(instance_, &count, nullptr); result != VK_SUCCESS) {
    return vulkanFailure(result, "list the devices");
  }
  std::vector<VkPhysicalDevice> devices(count);
  if (const VkResult result = enumerate(instance_, &count, devices.data()); result < VK_SUCCESS) {
    return vulkanFailure(result, "list the devices");
  }
  devices.resize(count);
  return devices;
}

}  // namespace honeycomb::Osd
