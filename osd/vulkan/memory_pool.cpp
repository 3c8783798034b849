#include "osd/vulkan/memory_pool.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "far/base/array.h"
#include "osd/vulkan/errors.h"
#include "osd/vulkan/memory_budget.h"

namespace honeycomb::Osd {

MemorySlice::MemorySlice(MemorySlice&& other) noexcept
    : core_(std::move(other.core_)), block_(std::exchange(other.block_, nullptr)), offset_(other.offset_) {}

MemorySlice& MemorySlice::operator=(MemorySlice&& other) noexcept {
  std::swap(core_, other.core_);
  std::swap(block_, other.block_);
  std::swap(offset_, other.offset_);
  return *this;
}

MemorySlice::~MemorySlice() {
  if (block_ != nullptr) core_->pool->release(*block_, offset_);
}

namespace {

std::uint64_t alignedUp(std::uint64_t offset, std::uint64_t alignment) {
  return (offset + alignment - 1) / alignment * alignment;
}

// Takes the first gap of the block that is large enough. What is given back later needs no memory to be remembered.
std::optional<std::uint64_t> take(MemoryBlock& block, const MemoryNeed& need) {
  std::uint64_t begin = 0;
  auto next = block.parts.begin();
  for (; next != block.parts.end(); ++next) {
    if (begin + need.bytes <= next->begin) break;
    begin = alignedUp(next->end, need.alignment);
  }
  if (begin + need.bytes > block.bytes) return std::nullopt;
  block.parts.insert(next, {begin, begin + need.bytes});
  return begin;
}

std::uint32_t heapOf(const VulkanCore& core, std::uint32_t type) {
  return core.memory.memoryTypes[type].heapIndex;
}

// Larger buffers have an allocation of their own. An eighth of a heap at most: some hold no more than 256 MiB.
std::uint64_t largestBlock(const VulkanCore& core, std::uint32_t type) {
  return std::min(MemoryPool::kLargestBlock, std::bit_floor(core.memory.memoryHeaps[heapOf(core, type)].size / 8));
}

Result<DeviceHandle<VkDeviceMemory>> allocateMemory(const VulkanCore& core, const MemoryNeed& need, std::uint64_t bytes,
                                                    const MemoryRoom& room) {
  VkMemoryDedicatedAllocateInfo dedicated{};
  dedicated.sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO;
  dedicated.buffer = need.buffer;
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  if (need.alone) info.pNext = &dedicated;
  info.allocationSize = bytes;
  info.memoryTypeIndex = need.type;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  const VkResult result = core.vk().vkAllocateMemory(core.device.device, &info, core.device.allocator, &memory);
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY) return tl::unexpected(outOfDeviceMemory(bytes, room));
  if (result != VK_SUCCESS) return vulkanFailure(result, "allocate memory");
  return core.own(memory, core.vk().vkFreeMemory);
}

Result<void> mapBlock(const VulkanCore& core, MemoryBlock& block) {
  void* data = nullptr;
  const VkResult result = core.vk().vkMapMemory(core.device.device, block.memory.get(), 0, VK_WHOLE_SIZE, 0, &data);
  if (result != VK_SUCCESS) return vulkanFailure(result, "map memory");
  block.data = static_cast<std::byte*>(data);
  // A CPU's memory is the process's own. Results of 13 MB, written all over in every frame, take 9 % less time in large
  // pages.
  if (core.type == VK_PHYSICAL_DEVICE_TYPE_CPU) wantHugePages(data, block.bytes);
  return {};
}

}  // namespace

Result<MemorySlice> MemoryPool::allocate(const std::shared_ptr<const VulkanCore>& core, const MemoryNeed& asked) {
  MemoryNeed need = asked;
  need.alone = need.alone || need.bytes > largestBlock(*core, need.type) / 2;
  const std::lock_guard lock(mutex_);
  for (const auto& block : blocks_) {
    if (need.alone || block->alone || block->type != need.type || block->mapped != need.mapped) continue;
    if (const auto offset = take(*block, need)) return MemorySlice(core, *block, *offset);
  }
  const auto block = makeBlock(*core, need);
  if (!block) return tl::unexpected(block.error());
  return MemorySlice(core, **block, take(**block, need).value());
}

// Twice the largest of this kind that there is: few blocks in the end, and small ones for who needs little.
std::uint64_t MemoryPool::blockBytes(const VulkanCore& core, const MemoryNeed& need) const {
  if (need.alone) return need.bytes;
  std::uint64_t bytes = std::max(kLeastBlock, std::bit_ceil(need.bytes));
  for (const auto& block : blocks_) {
    if (!block->alone && block->type == need.type && block->mapped == need.mapped)
      bytes = std::max(bytes, 2 * block->bytes);
  }
  return std::max(need.bytes, std::min(bytes, largestBlock(core, need.type)));
}

// Where there is no room for a whole block, the buffer alone may still fit.
Result<MemoryBlock*> MemoryPool::makeBlock(const VulkanCore& core, const MemoryNeed& need) {
  const std::uint64_t bytes = blockBytes(core, need);
  auto block = makeBlock(core, need, bytes);
  if (block || bytes == need.bytes || block.error().code != ErrorCode::outOfMemory) return block;
  return makeBlock(core, need, need.bytes);
}

Result<MemoryBlock*> MemoryPool::makeBlock(const VulkanCore& core, const MemoryNeed& need, std::uint64_t bytes) {
  std::uint64_t held = 0, heldOfHeap = 0;
  for (const auto& block : blocks_) {
    held += block->bytes;
    if (heapOf(core, block->type) == heapOf(core, need.type)) heldOfHeap += block->bytes;
  }
  const MemoryRoom room = roomOf(core, heapOf(core, need.type), held, heldOfHeap);
  // Asking for more than the heap has is against the rules of vkAllocateMemory.
  if (bytes > room.left()) return tl::unexpected(outOfDeviceMemory(bytes, room));
  auto memory = allocateMemory(core, need, bytes, room);
  if (!memory) return tl::unexpected(memory.error());
  auto block = std::make_unique<MemoryBlock>();
  block->memory = std::move(*memory);
  block->bytes = bytes;
  block->type = need.type;
  block->mapped = need.mapped;
  block->alone = need.alone;
  block->parts.reserve(1);  // for the buffer it is made for: nothing may fail once the pool has the block
  if (need.mapped) {
    if (const auto mapped = mapBlock(core, *block); !mapped) return tl::unexpected(mapped.error());
  }
  blocks_.push_back(std::move(block));
  return blocks_.back().get();
}

void MemoryPool::release(MemoryBlock& block, std::uint64_t offset) noexcept {
  const std::lock_guard lock(mutex_);
  std::erase_if(block.parts, [offset](const MemoryBlock::Part& part) { return part.begin == offset; });
  if (block.parts.empty()) std::erase_if(blocks_, [&block](const auto& one) { return one.get() == &block; });
}

MemoryUsage MemoryPool::usage() const {
  const std::lock_guard lock(mutex_);
  MemoryUsage usage;
  for (const auto& block : blocks_) {
    ++usage.blocks;
    usage.held += block->bytes;
    for (const MemoryBlock::Part& part : block->parts) usage.used += part.end - part.begin;
  }
  return usage;
}

}  // namespace honeycomb::Osd
