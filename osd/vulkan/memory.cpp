#include "osd/vulkan/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "osd/vulkan/commands.h"
#include "osd/vulkan/errors.h"
#include "osd/vulkan/guard.h"
#include "osd/vulkan/memory_budget.h"

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

Result<DeviceHandle<VkBuffer>> makeBuffer(const VulkanCore& core, std::uint64_t bytes, VkBufferUsageFlags usage) {
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes;
  info.usage = usage;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  return core.make(core.vk().vkCreateBuffer, core.vk().vkDestroyBuffer, info, "create a buffer");
}

// What no buffer can pass, known before the driver is asked.
std::uint32_t largestHeap(const VulkanCore& core) {
  const auto* const heaps = core.memory.memoryHeaps;
  const auto smaller = [](const VkMemoryHeap& a, const VkMemoryHeap& b) { return a.size < b.size; };
  return static_cast<std::uint32_t>(std::max_element(heaps, heaps + core.memory.memoryHeapCount, smaller) - heaps);
}

Result<MemoryNeed> needOf(const VulkanCore& core, VkBuffer buffer, MemoryUse use) {
  VkMemoryDedicatedRequirements dedicated{};
  dedicated.sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_REQUIREMENTS;
  VkMemoryRequirements2 needs{};
  needs.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2;
  needs.pNext = &dedicated;
  VkBufferMemoryRequirementsInfo2 info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_REQUIREMENTS_INFO_2;
  info.buffer = buffer;
  core.vk().vkGetBufferMemoryRequirements2(core.device.device, &info, &needs);
  const VkMemoryRequirements& memory = needs.memoryRequirements;
  const auto type = chooseType(core, memory.memoryTypeBits, wishFor(core, use));
  if (!type) {
    return fail(ErrorCode::unsupported, "the Vulkan device has no memory that the host can map: choose another device");
  }
  const bool mappable = (core.memory.memoryTypes[*type].propertyFlags & kMappable) == kMappable;
  return MemoryNeed{.bytes = memory.size,
                    .alignment = memory.alignment,
                    .type = *type,
                    .mapped = mappable && (use != MemoryUse::device || sharesMemory(core)),
                    .alone = dedicated.prefersDedicatedAllocation == VK_TRUE,
                    .buffer = buffer};
}

}  // namespace

Result<VulkanBuffer> VulkanBuffer::create(const std::shared_ptr<const VulkanCore>& core, std::uint64_t bytes,
                                          VkBufferUsageFlags usage, MemoryUse use) {
  return guarded([&]() -> Result<VulkanBuffer> {
    const std::uint32_t heap = largestHeap(*core);
    if (bytes > core->memory.memoryHeaps[heap].size) {
      return tl::unexpected(outOfDeviceMemory(bytes, roomOf(*core, heap, core->pool->usage().held, 0)));
    }
    VulkanBuffer result;
    // Vulkan has no buffers of no bytes, and kernels read whole numbers.
    result.size_ = std::max<std::uint64_t>(bytes, 2 * sizeof(float));
    auto buffer = makeBuffer(*core, result.size_, usage);
    if (!buffer) return tl::unexpected(buffer.error());
    const auto need = needOf(*core, buffer->get(), use);
    if (!need) return tl::unexpected(need.error());
    auto memory = core->pool->allocate(core, *need);
    if (!memory) return tl::unexpected(memory.error());
    const VkResult bound =
        core->vk().vkBindBufferMemory(core->device.device, buffer->get(), memory->memory(), memory->offset());
    if (bound != VK_SUCCESS) return vulkanFailure(bound, "bind memory to a buffer");
    result.data_ = memory->data();
    result.memory_ = std::move(*memory);
    result.buffer_ = std::move(*buffer);
    return result;
  });
}

Result<SharedBuffer> SharedBuffer::create(const std::shared_ptr<const VulkanCore>& core, std::uint64_t bytes,
                                          VkBufferUsageFlags usage, MemoryUse use) {
  const VkBufferUsageFlags copied = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  SharedBuffer shared;
  auto device = VulkanBuffer::create(core, bytes, usage | copied, MemoryUse::device);
  if (!device) return tl::unexpected(device.error());
  shared.device_ = std::move(*device);
  if (shared.device_.mapped() || use == MemoryUse::device) return shared;
  auto host = VulkanBuffer::create(core, bytes, copied, use);
  if (!host) return tl::unexpected(host.error());
  shared.host_ = std::move(*host);
  return shared;
}

Result<void> checkRange(const VulkanRange& range, std::uint64_t needed, std::uint64_t alignment, const char* what) {
  if (range.buffer == VK_NULL_HANDLE) {
    return fail(ErrorCode::invalidOption, fmt::format("a buffer for {} is needed, none is given", what));
  }
  if (range.size < needed) {
    return fail(ErrorCode::invalidOption,
                fmt::format("the buffer for {} has {} bytes, {} are needed: make it larger or "
                            "check the descriptor",
                            what, range.size, needed));
  }
  if (range.offset % alignment != 0) {
    return fail(ErrorCode::invalidOption, fmt::format("the buffer for {} begins at byte {}, which is no multiple of {}",
                                                      what, range.offset, alignment));
  }
  return {};
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
