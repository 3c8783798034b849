#include "osd/vulkan/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "osd/vulkan/commands.h"
#include "osd/vulkan/errors.h"

namespace honeycomb::Osd {

namespace {

constexpr VkMemoryPropertyFlags kMappable = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;

// Memory is shared for good on integrated GPUs and CPUs; what a discrete GPU lets the host map is slow or small.
bool sharesMemory(const VulkanCore& core) {
  const bool unified = core.type == VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU || core.type == VK_PHYSICAL_DEVICE_TYPE_CPU;
  return unified && !core.options.stageEverything;
}

struct Wish {
  VkMemoryPropertyFlags required = 0;
  VkMemoryPropertyFlags preferred = 0;
};

Wish wishFor(const VulkanCore& core, MemoryUse use) {
  switch (use) {
    case MemoryUse::upload:
      return {kMappable, 0};
    case MemoryUse::readback:
      return {kMappable, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
    default:
      break;
  }
  VkMemoryPropertyFlags preferred = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
  if (sharesMemory(core)) preferred |= kMappable | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
  return {0, preferred};
}

std::optional<std::uint32_t> findType(const VulkanCore& core, std::uint32_t allowed, VkMemoryPropertyFlags flags) {
  for (std::uint32_t i = 0; i < core.memory.memoryTypeCount; ++i) {
    const bool usable = (allowed & (1U << i)) != 0;
    if (usable && (core.memory.memoryTypes[i].propertyFlags & flags) == flags) return i;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> chooseType(const VulkanCore& core, std::uint32_t allowed, Wish wish) {
  if (const auto best = findType(core, allowed, wish.required | wish.preferred)) return best;
  const VkMemoryPropertyFlags local = wish.preferred & VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
  if (const auto good = findType(core, allowed, wish.required | local)) return good;
  return findType(core, allowed, wish.required);
}

Error outOfMemory(std::uint64_t bytes, std::uint64_t heap) {
  return {ErrorCode::outOfMemory,
          fmt::format(
              "out of Vulkan device memory: {} bytes asked for, the device's heap holds {} in all; refine fewer levels "
              "or use a CPU backend",
              bytes, heap)};
}

// The size of the heap the memory type is taken from.
std::uint64_t heapSize(const VulkanCore& core, std::uint32_t type) {
  return core.memory.memoryHeaps[core.memory.memoryTypes[type].heapIndex].size;
}

Result<DeviceHandle<VkDeviceMemory>> allocate(const VulkanCore& core, VkDeviceSize bytes, std::uint32_t type) {
  // Asking for more than the heap has is against the rules of vkAllocateMemory.
  if (bytes > heapSize(core, type)) return tl::unexpected(outOfMemory(bytes, heapSize(core, type)));
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.allocationSize = bytes;
  info.memoryTypeIndex = type;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  const VkResult result = core.vk().vkAllocateMemory(core.device.device, &info, core.device.allocator, &memory);
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) {
    return tl::unexpected(outOfMemory(bytes, heapSize(core, type)));
  }
  if (result != VK_SUCCESS) return vulkanFailure(result, "allocate memory");
  return core.own(memory, core.vk().vkFreeMemory);
}

Result<DeviceHandle<VkBuffer>> makeBuffer(const VulkanCore& core, std::uint64_t bytes, VkBufferUsageFlags usage) {
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes;
  info.usage = usage;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  return core.make(core.vk().vkCreateBuffer, core.vk().vkDestroyBuffer, info, "create a buffer");
}

// The largest heap: what no buffer can pass, known before the driver is asked.
std::uint64_t largestHeap(const VulkanCore& core) {
  std::uint64_t largest = 0;
  for (std::uint32_t i = 0; i < core.memory.memoryHeapCount; ++i) {
    largest = std::max<std::uint64_t>(largest, core.memory.memoryHeaps[i].size);
  }
  return largest;
}

}  // namespace

Result<VulkanBuffer> VulkanBuffer::create(const std::shared_ptr<const VulkanCore>& core, std::uint64_t bytes,
                                          VkBufferUsageFlags usage, MemoryUse use) {
  if (bytes > largestHeap(*core)) return tl::unexpected(outOfMemory(bytes, largestHeap(*core)));
  VulkanBuffer result;
  result.core_ = core;
  // Vulkan has no buffers of no bytes, and kernels read whole numbers.
  result.size_ = std::max<std::uint64_t>(bytes, 2 * sizeof(float));
  auto buffer = makeBuffer(*core, result.size_, usage);
  if (!buffer) return tl::unexpected(buffer.error());
  VkMemoryRequirements needs{};
  core->vk().vkGetBufferMemoryRequirements(core->device.device, buffer->get(), &needs);
  const auto type = chooseType(*core, needs.memoryTypeBits, wishFor(*core, use));
  if (!type)
    return fail(ErrorCode::unsupported, "the Vulkan device has no memory that the host can map: choose another device");
  auto memory = allocate(*core, needs.size, *type);
  if (!memory) return tl::unexpected(memory.error());
  VkResult status = core->vk().vkBindBufferMemory(core->device.device, buffer->get(), memory->get(), 0);
  if (status != VK_SUCCESS) return vulkanFailure(status, "bind memory to a buffer");
  result.memory_ = std::move(*memory);
  result.buffer_ = std::move(*buffer);
  const bool mappable = (core->memory.memoryTypes[*type].propertyFlags & kMappable) == kMappable;
  if (mappable && (use != MemoryUse::device || sharesMemory(*core))) {
    void* data = nullptr;
    status = core->vk().vkMapMemory(core->device.device, result.memory_.get(), 0, VK_WHOLE_SIZE, 0, &data);
    if (status != VK_SUCCESS) return vulkanFailure(status, "map memory");
    result.data_ = static_cast<std::byte*>(data);
  }
  return result;
}

Result<SharedBuffer> SharedBuffer::create(const std::shared_ptr<const VulkanCore>& core, std::uint64_t bytes,
                                          VkBufferUsageFlags usage, MemoryUse use) {
  const VkBufferUsageFlags copied = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  SharedBuffer shared;
  auto device = VulkanBuffer::create(core, bytes, usage | copied, MemoryUse::device);
  if (!device) return tl::unexpected(device.error());
  shared.device_ = std::move(*device);
  if (shared.device_.mapped()) return shared;
  auto host = VulkanBuffer::create(core, bytes, copied, use);
  if (!host) return tl::unexpected(host.error());
  shared.host_ = std::move(*host);
  return shared;
}

namespace {

void copyPieces(std::span<std::byte> target, std::span<const BufferPiece> pieces) {
  for (const BufferPiece& piece : pieces) {
    if (!piece.bytes.empty()) std::memcpy(target.data() + piece.offset, piece.bytes.data(), piece.bytes.size());
  }
}

}  // namespace

Result<void> fillBuffer(const std::shared_ptr<const VulkanCore>& core, const VulkanBuffer& buffer,
                        std::span<const BufferPiece> pieces) {
  if (buffer.mapped()) {
    copyPieces(buffer.bytes(), pieces);
    return {};
  }
  auto staging = VulkanBuffer::create(core, buffer.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, MemoryUse::upload);
  if (!staging) return tl::unexpected(staging.error());
  copyPieces(staging->bytes(), pieces);
  auto commands = CommandRunner::create(core);
  if (!commands) return tl::unexpected(commands.error());
  if (auto begun = commands->begin(VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT); !begun) return begun;
  const VkBufferCopy region{0, 0, buffer.size()};
  core->vk().vkCmdCopyBuffer(commands->commandBuffer(), staging->handle(), buffer.handle(), 1, &region);
  if (auto ended = commands->end(); !ended) return ended;
  if (auto sent = commands->submit(); !sent) return sent;
  return commands->wait();
}

}  // namespace honeycomb::Osd
