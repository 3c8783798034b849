#pragma once

#include <vulkan/vulkan_core.h>

#include <string>

#include "far/base/result.h"
#include "osd/vulkan/device.h"

/// X(name) for every function of the instance that evaluators call.
#define HONEYCOMB_VULKAN_INSTANCE_FUNCTIONS(X) \
  X(vkEnumerateDeviceExtensionProperties)      \
  X(vkGetPhysicalDeviceMemoryProperties2)      \
  X(vkGetPhysicalDeviceQueueFamilyProperties)  \
  X(vkGetPhysicalDeviceProperties2)

/// X(name) for every function of the device that evaluators call.
#define HONEYCOMB_VULKAN_DEVICE_FUNCTIONS(X) \
  X(vkAllocateCommandBuffers)                \
  X(vkAllocateDescriptorSets)                \
  X(vkAllocateMemory)                        \
  X(vkBeginCommandBuffer)                    \
  X(vkBindBufferMemory)                      \
  X(vkCmdBindDescriptorSets)                 \
  X(vkCmdBindPipeline)                       \
  X(vkCmdCopyBuffer)                         \
  X(vkCmdDispatch)                           \
  X(vkCmdFillBuffer)                         \
  X(vkCmdPipelineBarrier)                    \
  X(vkCmdPushConstants)                      \
  X(vkCmdResetQueryPool)                     \
  X(vkCmdWriteTimestamp)                     \
  X(vkCreateBuffer)                          \
  X(vkCreateBufferView)                      \
  X(vkCreateCommandPool)                     \
  X(vkCreateComputePipelines)                \
  X(vkCreateDescriptorPool)                  \
  X(vkCreateDescriptorSetLayout)             \
  X(vkCreateFence)                           \
  X(vkCreatePipelineCache)                   \
  X(vkCreatePipelineLayout)                  \
  X(vkCreateQueryPool)                       \
  X(vkCreateSemaphore)                       \
  X(vkCreateShaderModule)                    \
  X(vkDestroyBuffer)                         \
  X(vkDestroyBufferView)                     \
  X(vkDestroyCommandPool)                    \
  X(vkDestroyDescriptorPool)                 \
  X(vkDestroyDescriptorSetLayout)            \
  X(vkDestroyFence)                          \
  X(vkDestroyPipeline)                       \
  X(vkDestroyPipelineCache)                  \
  X(vkDestroyPipelineLayout)                 \
  X(vkDestroyQueryPool)                      \
  X(vkDestroySemaphore)                      \
  X(vkDestroyShaderModule)                   \
  X(vkEndCommandBuffer)                      \
  X(vkFreeMemory)                            \
  X(vkGetBufferMemoryRequirements2)          \
  X(vkGetPipelineCacheData)                  \
  X(vkGetQueryPoolResults)                   \
  X(vkGetSemaphoreCounterValue)              \
  X(vkMapMemory)                             \
  X(vkQueueSubmit)                           \
  X(vkResetFences)                           \
  X(vkUpdateDescriptorSets)                  \
  X(vkWaitForFences)                         \
  X(vkWaitSemaphores)

namespace honeycomb::Osd {

/// Looks functions up by their names, and remembers the first that isn't there.
class FunctionLoader {
 public:
  /// Errors: invalidOption for null handles, noDevice where the machine's Vulkan loader is needed and isn't installed.
  static Result<FunctionLoader> create(const VulkanDevice& device);

  /// Looks up a function of the instance.
  template <class Function>
  void ofInstance(const char* name, Function& function) {
    function = reinterpret_cast<Function>(getInstance_(instance_, name));
    if (function == nullptr) missed(name);
  }
  /// Looks up a function of the device.
  template <class Function>
  void ofDevice(const char* name, Function& function) {
    function = reinterpret_cast<Function>(getDevice_(device_, name));
    if (function == nullptr) missed(name);
  }
  /// `unsupported`, with the name of the first function that is missing.
  Result<void> found() const;

 private:
  void missed(const char* name) {
    if (missing_.empty()) missing_ = name;
  }

  PFN_vkGetInstanceProcAddr getInstance_ = nullptr;
  PFN_vkGetDeviceProcAddr getDevice_ = nullptr;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  std::string missing_;
};

/// The Vulkan functions of one instance and one device, under their own names: every evaluator has its own, and none is
/// called that isn't in the lists above.
struct VulkanFunctions {
#define HONEYCOMB_MEMBER(name) PFN_##name name = nullptr;
  HONEYCOMB_VULKAN_INSTANCE_FUNCTIONS(HONEYCOMB_MEMBER)
  HONEYCOMB_VULKAN_DEVICE_FUNCTIONS(HONEYCOMB_MEMBER)
#undef HONEYCOMB_MEMBER

  /// Errors: of FunctionLoader; `unsupported` names a function that is missing. May be called from several threads.
  static Result<VulkanFunctions> load(const VulkanDevice& device);
};

}  // namespace honeycomb::Osd
