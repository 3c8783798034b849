#pragma once

#include <vulkan/vulkan_core.h>

#include "far/base/result.h"
#include "osd/vulkan/device.h"

/// X(name) for every function of the device that the renderer calls.
#define HONEYCOMB_VIEWER_FUNCTIONS(X) \
  X(vkAllocateCommandBuffers)         \
  X(vkAllocateDescriptorSets)         \
  X(vkAllocateMemory)                 \
  X(vkBeginCommandBuffer)             \
  X(vkBindBufferMemory)               \
  X(vkBindImageMemory)                \
  X(vkCmdBeginRenderPass)             \
  X(vkCmdBindDescriptorSets)          \
  X(vkCmdBindIndexBuffer)             \
  X(vkCmdBindPipeline)                \
  X(vkCmdCopyImageToBuffer)           \
  X(vkCmdDraw)                        \
  X(vkCmdDrawIndexed)                 \
  X(vkCmdEndRenderPass)               \
  X(vkCmdPipelineBarrier)             \
  X(vkCmdPushConstants)               \
  X(vkCmdSetScissor)                  \
  X(vkCmdSetViewport)                 \
  X(vkCreateBuffer)                   \
  X(vkCreateCommandPool)              \
  X(vkCreateDescriptorPool)           \
  X(vkCreateDescriptorSetLayout)      \
  X(vkCreateFence)                    \
  X(vkCreateFramebuffer)              \
  X(vkCreateGraphicsPipelines)        \
  X(vkCreateImage)                    \
  X(vkCreateImageView)                \
  X(vkCreatePipelineLayout)           \
  X(vkCreateRenderPass)               \
  X(vkCreateSampler)                  \
  X(vkCreateShaderModule)             \
  X(vkDestroyBuffer)                  \
  X(vkDestroyCommandPool)             \
  X(vkDestroyDescriptorPool)          \
  X(vkDestroyDescriptorSetLayout)     \
  X(vkDestroyFence)                   \
  X(vkDestroyFramebuffer)             \
  X(vkDestroyImage)                   \
  X(vkDestroyImageView)               \
  X(vkDestroyPipeline)                \
  X(vkDestroyPipelineLayout)          \
  X(vkDestroyRenderPass)              \
  X(vkDestroySampler)                 \
  X(vkDestroyShaderModule)            \
  X(vkEndCommandBuffer)               \
  X(vkFreeMemory)                     \
  X(vkGetBufferMemoryRequirements)    \
  X(vkGetImageMemoryRequirements)     \
  X(vkMapMemory)                      \
  X(vkQueueSubmit)                    \
  X(vkResetFences)                    \
  X(vkUpdateDescriptorSets)           \
  X(vkWaitForFences)

namespace honeycomb::Viewer {

/// The renderer's own table of Vulkan functions, under their own names, so that several devices live side by side.
struct Calls {
#define HONEYCOMB_MEMBER(name) PFN_##name name = nullptr;
  HONEYCOMB_VIEWER_FUNCTIONS(HONEYCOMB_MEMBER)
#undef HONEYCOMB_MEMBER
  PFN_vkGetPhysicalDeviceFormatProperties vkGetPhysicalDeviceFormatProperties = nullptr;
  PFN_vkGetPhysicalDeviceMemoryProperties vkGetPhysicalDeviceMemoryProperties = nullptr;
  PFN_vkGetPhysicalDeviceProperties vkGetPhysicalDeviceProperties = nullptr;

  /// Errors: of Osd::FunctionLoader.
  static Result<Calls> load(const Osd::VulkanDevice& device);
};

}  // namespace honeycomb::Viewer
