#include "apps/viewer/gpu.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <mutex>

#include "osd/vulkan/errors.h"

namespace honeycomb::Viewer {
namespace {

/// The first memory type among `allowed` that has all of `wanted`.
std::optional<std::uint32_t> memoryType(const VkPhysicalDeviceMemoryProperties& memory, std::uint32_t allowed,
                                        VkMemoryPropertyFlags wanted) {
  for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
    const bool usable = ((allowed >> type) & 1u) != 0;
    if (usable && (memory.memoryTypes[type].propertyFlags & wanted) == wanted) return type;
  }
  return std::nullopt;
}

constexpr VkMemoryPropertyFlags kShared = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr std::array<VkMemoryPropertyFlags, 2> kForDevice{kShared | VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, kShared};
constexpr std::array<VkMemoryPropertyFlags, 2> kForReadback{kShared | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, kShared};
constexpr std::array<VkMemoryPropertyFlags, 2> kForImages{VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};

}  // namespace

Result<Gpu> openGpu(const Osd::VulkanDevice& device) {
  const auto calls = Calls::load(device);
  if (!calls) return tl::unexpected(calls.error());
  Gpu gpu;
  gpu.device = device;
  gpu.call = *calls;
  VkPhysicalDeviceProperties properties{};
  calls->vkGetPhysicalDeviceProperties(device.physicalDevice, &properties);
  gpu.limits = properties.limits;
  calls->vkGetPhysicalDeviceMemoryProperties(device.physicalDevice, &gpu.memory);
  return gpu;
}

void Maker::fail(Error error) {
  if (!error_) error_ = std::move(error);
}

void Maker::check(VkResult result, const char* what) {
  if (result != VK_SUCCESS) fail(Osd::vulkanError(result, what));
}

Owned<VkDeviceMemory> Maker::allocate(const VkMemoryRequirements& needs,
                                      std::span<const VkMemoryPropertyFlags> wishes) {
  for (const VkMemoryPropertyFlags wish : wishes) {
    const auto type = memoryType(gpu_.memory, needs.memoryTypeBits, wish);
    if (!type) continue;
    auto info = structure<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    info.allocationSize = needs.size;
    info.memoryTypeIndex = *type;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    const VkResult result = gpu_.call.vkAllocateMemory(gpu_.device.device, &info, gpu_.device.allocator, &memory);
    if (result == VK_SUCCESS) return {gpu_.device.device, memory, gpu_.call.vkFreeMemory, gpu_.device.allocator};
  }
  fail(Error{ErrorCode::outOfMemory, fmt::format("the Vulkan device has no {} bytes to spare for the picture; "
                                                 "try smaller pictures or fewer levels",
                                                 needs.size)});
  return {};
}

Buffer Maker::buffer(VkDeviceSize bytes, VkBufferUsageFlags usage, Residence residence) {
  auto info = structure<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
  info.size = bytes;
  info.usage = usage;
  Buffer made;
  made.size = bytes;
  made.buffer = own(gpu_.call.vkCreateBuffer, gpu_.call.vkDestroyBuffer, info, "create a buffer");
  if (!ok()) return {};
  VkMemoryRequirements needs;
  gpu_.call.vkGetBufferMemoryRequirements(gpu_.device.device, made.get(), &needs);
  made.memory = allocate(needs, residence == Residence::device ? kForDevice : kForReadback);
  if (!ok()) return {};
  check(gpu_.call.vkBindBufferMemory(gpu_.device.device, made.get(), made.memory.get(), 0), "bind a buffer");
  void* mapped = nullptr;
  check(gpu_.call.vkMapMemory(gpu_.device.device, made.memory.get(), 0, VK_WHOLE_SIZE, 0, &mapped), "map a buffer");
  made.mapped = static_cast<std::byte*>(mapped);
  return ok() ? std::move(made) : Buffer{};
}

Buffer Maker::buffer(std::span<const std::byte> content, VkBufferUsageFlags usage) {
  Buffer made = buffer(std::max<VkDeviceSize>(content.size(), 1), usage, Residence::device);
  if (ok() && !content.empty()) std::memcpy(made.mapped, content.data(), content.size());
  return made;
}

Image Maker::image(VkFormat format, VkExtent2D extent, VkSampleCountFlagBits samples, VkImageUsageFlags usage,
                   VkImageAspectFlags aspect) {
  auto info = structure<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {extent.width, extent.height, 1};
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = samples;
  info.usage = usage;
  Image made;
  made.image = own(gpu_.call.vkCreateImage, gpu_.call.vkDestroyImage, info, "create an image");
  if (!ok()) return {};
  VkMemoryRequirements needs;
  gpu_.call.vkGetImageMemoryRequirements(gpu_.device.device, made.image.get(), &needs);
  made.memory = allocate(needs, kForImages);
  if (!ok()) return {};
  check(gpu_.call.vkBindImageMemory(gpu_.device.device, made.image.get(), made.memory.get(), 0), "bind an image");
  auto view = structure<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
  view.image = made.image.get();
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = format;
  view.subresourceRange = {aspect, 0, 1, 0, 1};
  made.view = own(gpu_.call.vkCreateImageView, gpu_.call.vkDestroyImageView, view, "create an image view");
  return made;
}

VkCommandBuffer allocateCommandBuffer(Maker& make, const Gpu& gpu, VkCommandPool pool) {
  auto info = structure<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
  info.commandPool = pool;
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  VkCommandBuffer buffer = VK_NULL_HANDLE;
  if (make.ok()) {
    make.check(gpu.call.vkAllocateCommandBuffers(gpu.device.device, &info, &buffer), "allocate a command buffer");
  }
  return buffer;
}

VkResult submit(const Gpu& gpu, const VkSubmitInfo& info, VkFence done) {
  const std::lock_guard turn(gpu.device.queueLock);
  return gpu.call.vkQueueSubmit(gpu.device.queue, 1, &info, done);
}

void submitAndWait(Maker& make, const Gpu& gpu, VkCommandBuffer commands, VkFence done) {
  auto info = structure<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
  info.commandBufferCount = 1;
  info.pCommandBuffers = &commands;
  make.check(gpu.call.vkResetFences(gpu.device.device, 1, &done), "reset a fence");
  if (make.ok()) make.check(submit(gpu, info, done), "submit a picture");
  constexpr auto kForever = std::numeric_limits<std::uint64_t>::max();
  if (make.ok()) {
    make.check(gpu.call.vkWaitForFences(gpu.device.device, 1, &done, VK_TRUE, kForever), "finish a picture");
  }
}

}  // namespace honeycomb::Viewer
