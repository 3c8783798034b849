#include "engine.h"

#include <dlfcn.h>

#include <stdexcept>

namespace honeycomb::VulkanTests {

namespace {

void require(VkResult result, const char* what) {
  if (result != VK_SUCCESS) throw std::runtime_error(std::string(what) + " failed: " + std::to_string(result));
}

VKAPI_ATTR VkBool32 VKAPI_CALL keepMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                           const VkDebugUtilsMessengerCallbackDataEXT* data, void* messages) {
  static_cast<std::vector<std::string>*>(messages)->emplace_back(data->pMessage);
  return VK_FALSE;
}

}  // namespace

Engine::Engine(bool validation, std::vector<std::string>& messages) : messages_(messages) {
  void* const library = dlopen("libvulkan.so.1", RTLD_NOW);
  if (library == nullptr) throw std::runtime_error("no Vulkan loader");
  getInstance_ = reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(library, "vkGetInstanceProcAddr"));
  makeInstance(validation);
  getDevice_ = ofInstance<PFN_vkGetDeviceProcAddr>("vkGetDeviceProcAddr");
  if (validation) makeMessenger();
  choosePhysicalDevice();
  makeDevice();
  makeCommands();
}

void Engine::makeInstance(bool validation) {
  const char* const layer = "VK_LAYER_KHRONOS_validation";
  const char* const extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.apiVersion = VK_API_VERSION_1_2;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;
  if (validation) {
    info.enabledLayerCount = info.enabledExtensionCount = 1;
    info.ppEnabledLayerNames = &layer;
    info.ppEnabledExtensionNames = &extension;
  }
  require(ofInstance<PFN_vkCreateInstance>("vkCreateInstance")(&info, nullptr, &instance_), "vkCreateInstance");
}

void Engine::makeMessenger() {
  VkDebugUtilsMessengerCreateInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  info.pfnUserCallback = keepMessage;
  info.pUserData = &messages_;
  require(ofInstance<PFN_vkCreateDebugUtilsMessengerEXT>("vkCreateDebugUtilsMessengerEXT")(instance_, &info, nullptr,
                                                                                           &messenger_),
          "vkCreateDebugUtilsMessengerEXT");
}

void Engine::choosePhysicalDevice() {
  std::uint32_t count = 1;
  if (ofInstance<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices")(instance_, &count, &physicalDevice_) <
          0 ||
      count == 0) {
    throw std::runtime_error("no Vulkan device");
  }
  std::uint32_t families = 0;
  const auto query =
      ofInstance<PFN_vkGetPhysicalDeviceQueueFamilyProperties>("vkGetPhysicalDeviceQueueFamilyProperties");
  query(physicalDevice_, &families, nullptr);
  std::vector<VkQueueFamilyProperties> properties(families);
  query(physicalDevice_, &families, properties.data());
  while (family_ + 1 < families && (properties[family_].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0) ++family_;
}

void Engine::makeDevice() {
  const float priority = 1.0F;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  require(ofInstance<PFN_vkCreateDevice>("vkCreateDevice")(physicalDevice_, &info, nullptr, &device_),
          "vkCreateDevice");
  ofDevice<PFN_vkGetDeviceQueue>("vkGetDeviceQueue")(device_, family_, 0, &queue_);
}

void Engine::makeCommands() {
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool.queueFamilyIndex = family_;
  require(ofDevice<PFN_vkCreateCommandPool>("vkCreateCommandPool")(device_, &pool, nullptr, &pool_),
          "vkCreateCommandPool");
  VkCommandBufferAllocateInfo buffer{};
  buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  buffer.commandPool = pool_;
  buffer.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  buffer.commandBufferCount = 1;
  require(ofDevice<PFN_vkAllocateCommandBuffers>("vkAllocateCommandBuffers")(device_, &buffer, &commands_),
          "vkAllocateCommandBuffers");
  VkFenceCreateInfo fence{};
  fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  require(ofDevice<PFN_vkCreateFence>("vkCreateFence")(device_, &fence, nullptr, &fence_), "vkCreateFence");
}

Engine::~Engine() {
  for (const Buffer& one : buffers_) {
    ofDevice<PFN_vkDestroyBuffer>("vkDestroyBuffer")(device_, one.buffer, nullptr);
    ofDevice<PFN_vkFreeMemory>("vkFreeMemory")(device_, one.memory, nullptr);
  }
  ofDevice<PFN_vkDestroyFence>("vkDestroyFence")(device_, fence_, nullptr);
  ofDevice<PFN_vkDestroyCommandPool>("vkDestroyCommandPool")(device_, pool_, nullptr);
  ofDevice<PFN_vkDestroyDevice>("vkDestroyDevice")(device_, nullptr);
  if (messenger_ != VK_NULL_HANDLE) {
    ofInstance<PFN_vkDestroyDebugUtilsMessengerEXT>("vkDestroyDebugUtilsMessengerEXT")(instance_, messenger_, nullptr);
  }
  ofInstance<PFN_vkDestroyInstance>("vkDestroyInstance")(instance_, nullptr);
}

std::uint32_t Engine::mappableType(std::uint32_t allowed) const {
  VkPhysicalDeviceMemoryProperties memory{};
  ofInstance<PFN_vkGetPhysicalDeviceMemoryProperties>("vkGetPhysicalDeviceMemoryProperties")(physicalDevice_, &memory);
  constexpr VkMemoryPropertyFlags kFlags = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  std::uint32_t type = 0;
  while ((allowed & (1U << type)) == 0 || (memory.memoryTypes[type].propertyFlags & kFlags) != kFlags) ++type;
  return type;
}

Engine::Buffer Engine::makeBuffer(std::uint64_t bytes) {
  Buffer& made = buffers_.emplace_back();
  made.bytes = bytes;
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes;
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  require(ofDevice<PFN_vkCreateBuffer>("vkCreateBuffer")(device_, &info, nullptr, &made.buffer), "vkCreateBuffer");
  VkMemoryRequirements needs{};
  ofDevice<PFN_vkGetBufferMemoryRequirements>("vkGetBufferMemoryRequirements")(device_, made.buffer, &needs);
  VkMemoryAllocateInfo memory{};
  memory.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  memory.allocationSize = needs.size;
  memory.memoryTypeIndex = mappableType(needs.memoryTypeBits);
  require(ofDevice<PFN_vkAllocateMemory>("vkAllocateMemory")(device_, &memory, nullptr, &made.memory),
          "vkAllocateMemory");
  require(ofDevice<PFN_vkBindBufferMemory>("vkBindBufferMemory")(device_, made.buffer, made.memory, 0),
          "vkBindBufferMemory");
  void* data = nullptr;
  require(ofDevice<PFN_vkMapMemory>("vkMapMemory")(device_, made.memory, 0, VK_WHOLE_SIZE, 0, &data), "vkMapMemory");
  made.numbers = static_cast<float*>(data);
  return made;
}

void Engine::barrier(VkPipelineStageFlags before, VkAccessFlags written, VkPipelineStageFlags after,
                     VkAccessFlags wanted) const {
  VkMemoryBarrier memory{};
  memory.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  memory.srcAccessMask = written;
  memory.dstAccessMask = wanted;
  ofDevice<PFN_vkCmdPipelineBarrier>("vkCmdPipelineBarrier")(commands_, before, after, 0, 1, &memory, 0, nullptr, 0,
                                                             nullptr);
}

void Engine::frame(const std::function<void(VkCommandBuffer)>& work) {
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  require(ofDevice<PFN_vkBeginCommandBuffer>("vkBeginCommandBuffer")(commands_, &begin), "vkBeginCommandBuffer");
  barrier(VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_WRITE_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
          VK_ACCESS_SHADER_READ_BIT);
  work(commands_);
  barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
          VK_ACCESS_HOST_READ_BIT);
  require(ofDevice<PFN_vkEndCommandBuffer>("vkEndCommandBuffer")(commands_), "vkEndCommandBuffer");
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands_;
  require(ofDevice<PFN_vkQueueSubmit>("vkQueueSubmit")(queue_, 1, &submit, fence_), "vkQueueSubmit");
  require(ofDevice<PFN_vkWaitForFences>("vkWaitForFences")(device_, 1, &fence_, VK_TRUE, UINT64_MAX),
          "vkWaitForFences");
  require(ofDevice<PFN_vkResetFences>("vkResetFences")(device_, 1, &fence_), "vkResetFences");
}

}  // namespace honeycomb::VulkanTests
