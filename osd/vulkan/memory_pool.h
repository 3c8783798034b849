#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "far/base/result.h"
#include "osd/vulkan/core.h"

namespace honeycomb::Osd {

/// What a buffer needs of its memory.
struct MemoryNeed {
  std::uint64_t bytes = 0;
  std::uint64_t alignment = 1;       ///< a power of two
  std::uint32_t type = 0;            ///< of memory
  bool mapped = false;               ///< for good; the type is host-visible
  bool alone = false;                ///< wants an allocation of its own
  VkBuffer buffer = VK_NULL_HANDLE;  ///< whose memory it is
};

/// What a pool holds.
struct MemoryUsage {
  std::uint64_t blocks = 0;  ///< allocations of the device
  std::uint64_t held = 0;    ///< bytes of these
  std::uint64_t used = 0;    ///< bytes of buffers within
};

/// One allocation of the device, and the parts of it that are taken.
struct MemoryBlock {
  /// A part that is taken, in bytes of the block.
  struct Part {
    std::uint64_t begin = 0, end = 0;
  };
  DeviceHandle<VkDeviceMemory> memory;
  std::byte* data = nullptr;  ///< where it is mapped
  std::uint64_t bytes = 0;
  std::uint32_t type = 0;
  bool mapped = false;
  bool alone = false;
  std::vector<Part> parts;  ///< in order of their places
};

/// Part of a block, given back when it is destroyed.
class MemorySlice {
 public:
  MemorySlice() = default;
  MemorySlice(std::shared_ptr<const VulkanCore> core, MemoryBlock& block, std::uint64_t offset)
      : core_(std::move(core)), block_(&block), offset_(offset) {}
  MemorySlice(MemorySlice&& other) noexcept;
  MemorySlice& operator=(MemorySlice&& other) noexcept;
  ~MemorySlice();

  VkDeviceMemory memory() const { return block_->memory.get(); }
  std::uint64_t offset() const { return offset_; }
  /// The first byte; null where the block isn't mapped.
  std::byte* data() const { return block_->data == nullptr ? nullptr : block_->data + offset_; }

 private:
  std::shared_ptr<const VulkanCore> core_;
  MemoryBlock* block_ = nullptr;
  std::uint64_t offset_ = 0;
};

/// Device memory for few, large, long-lived buffers. A device allows no more than some thousand allocations, and
/// charges for each: buffers share blocks, which double from kLeastBlock to kLargestBlock, and are freed when their
/// last buffer goes. A buffer of more than half of the largest block, or one that the driver wants alone, has an
/// allocation of its own.
///
///     block   | buffer |..free..| buffer | buffer |......free......|      the first gap that is large enough is taken
///
/// Safe from several threads. Of buffers only, so that images never are their neighbours (bufferImageGranularity).
class MemoryPool {
 public:
  /// Bytes of the first block of a kind; the next is twice as large as the largest there is.
  static constexpr std::uint64_t kLeastBlock = std::uint64_t{4} << 20U;
  /// Bytes of the largest, unless a single buffer needs more.
  static constexpr std::uint64_t kLargestBlock = std::uint64_t{64} << 20U;

  /// Errors: outOfMemory past the device's budget or the caller's, see roomOf.
  Result<MemorySlice> allocate(const std::shared_ptr<const VulkanCore>& core, const MemoryNeed& need);
  MemoryUsage usage() const;

 private:
  friend class MemorySlice;
  Result<MemoryBlock*> makeBlock(const VulkanCore& core, const MemoryNeed& need);
  Result<MemoryBlock*> makeBlock(const VulkanCore& core, const MemoryNeed& need, std::uint64_t bytes);
  std::uint64_t blockBytes(const VulkanCore& core, const MemoryNeed& need) const;
  void release(MemoryBlock& block, std::uint64_t offset) noexcept;

  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<MemoryBlock>> blocks_;
};

}  // namespace honeycomb::Osd
