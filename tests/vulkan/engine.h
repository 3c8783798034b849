#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace honeycomb::VulkanTests {

/// A tiny engine with a device, buffers and a command buffer of its own, written in plain Vulkan: nothing of honeycomb
/// is included here, and the functions come from the loader by dlsym. Throws where Vulkan fails.
class Engine {
 public:
  struct Buffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    std::uint64_t bytes = 0;
    float* numbers = nullptr;  ///< mapped for good
  };

  /// `validation`: under the validation layer, which says in `messages` what it hears to the engine's very end.
  Engine(bool validation, std::vector<std::string>& messages);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  VkInstance instance() const { return instance_; }
  VkPhysicalDevice physicalDevice() const { return physicalDevice_; }
  VkDevice device() const { return device_; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queueFamily() const { return family_; }
  PFN_vkGetInstanceProcAddr getInstanceProcAddr() const { return getInstance_; }
  PFN_vkGetDeviceProcAddr getDeviceProcAddr() const { return getDevice_; }

  /// A storage buffer, kept until the engine's end.
  Buffer makeBuffer(std::uint64_t bytes);
  /// Begins the engine's command buffer, makes what the host wrote visible to compute, lets `work` record, makes what
  /// compute wrote visible to the host, submits and waits.
  void frame(const std::function<void(VkCommandBuffer)>& work);

 private:
  template <class Function>
  Function ofInstance(const char* name) const {
    return reinterpret_cast<Function>(getInstance_(instance_, name));
  }
  template <class Function>
  Function ofDevice(const char* name) const {
    return reinterpret_cast<Function>(getDevice_(device_, name));
  }
  void makeInstance(bool validation);
  void makeMessenger();
  void choosePhysicalDevice();
  void makeDevice();
  void makeCommands();
  std::uint32_t mappableType(std::uint32_t allowed) const;
  void barrier(VkPipelineStageFlags before, VkAccessFlags written, VkPipelineStageFlags after,
               VkAccessFlags wanted) const;

  PFN_vkGetInstanceProcAddr getInstance_ = nullptr;
  PFN_vkGetDeviceProcAddr getDevice_ = nullptr;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::uint32_t family_ = 0;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  std::vector<Buffer> buffers_;
  std::vector<std::string>& messages_;
};

}  // namespace honeycomb::VulkanTests
