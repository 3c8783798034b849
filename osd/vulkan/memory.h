#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "far/base/result.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/handles.h"
#include "osd/vulkan/memory_pool.h"

namespace honeycomb::Osd {

/// Part of a buffer that somebody owns: `size` bytes from `offset`, which must be a multiple of the device's
/// minStorageBufferOffsetAlignment where the range is bound to a kernel.
struct VulkanRange {
  VkBuffer buffer = VK_NULL_HANDLE;
  std::uint64_t offset = 0;
  std::uint64_t size = 0;
};

/// Is it a buffer of that many bytes, at an offset that can be bound? Errors: invalidOption; `what` it is for.
Result<void> checkRange(const VulkanRange& range, std::uint64_t needed, std::uint64_t alignment, const char* what);

/// Who touches a buffer.
enum class MemoryUse {
  device,   ///< kernels; mapped as well where the device shares its memory with the host
  upload,   ///< written by the host, read by copies; mapped
  readback  ///< written by copies, read by the host; mapped, cached where there is such memory
};

/// A buffer in the core's pool of memory, mapped for good where the host may touch it. Host memory is coherent.
class VulkanBuffer {
 public:
  VulkanBuffer() = default;
  /// Errors: outOfMemory, see MemoryPool.
  static Result<VulkanBuffer> create(const std::shared_ptr<const VulkanCore>& core, std::uint64_t bytes,
                                     VkBufferUsageFlags usage, MemoryUse use);

  VkBuffer handle() const { return buffer_.get(); }
  std::uint64_t size() const { return size_; }
  VulkanRange range() const { return {buffer_.get(), 0, size_}; }
  bool mapped() const { return data_ != nullptr; }
  /// The bytes of a mapped buffer.
  std::span<std::byte> bytes() const { return {data_, data_ == nullptr ? 0 : static_cast<std::size_t>(size_)}; }
  /// The numbers of a mapped buffer.
  std::span<float> numbers() const { return {reinterpret_cast<float*>(data_), bytes().size() / sizeof(float)}; }

 private:
  MemorySlice memory_;
  DeviceHandle<VkBuffer> buffer_;
  std::byte* data_ = nullptr;
  std::uint64_t size_ = 0;
};

/// A buffer of the device that the host writes or reads: itself where memory is shared, else through a second buffer
/// that is copied by commands.
class SharedBuffer {
 public:
  SharedBuffer() = default;
  /// `use`: device for one that the host needn't see. Errors: outOfMemory.
  static Result<SharedBuffer> create(const std::shared_ptr<const VulkanCore>& core, std::uint64_t bytes,
                                     VkBufferUsageFlags usage, MemoryUse use);

  VulkanRange range() const { return device_.range(); }
  /// What the host sees; empty where it sees nothing.
  std::span<std::byte> bytes() const { return device_.mapped() ? device_.bytes() : host_.bytes(); }
  std::span<float> numbers() const { return device_.mapped() ? device_.numbers() : host_.numbers(); }
  /// Is what the host sees the device's own memory?
  bool mapped() const { return device_.mapped(); }
  bool staged() const { return host_.handle() != VK_NULL_HANDLE; }
  VulkanRange hostRange() const { return host_.range(); }

 private:
  VulkanBuffer device_;
  VulkanBuffer host_;
};

/// Bytes and where in a buffer they go.
struct BufferPiece {
  std::uint64_t offset = 0;
  std::span<const std::byte> bytes;
};

/// Fills a buffer, directly or through staging; returns when the bytes are there. Staging submits to the core's queue,
/// under its lock. Errors: outOfMemory, deviceLost.
Result<void> fillBuffer(const std::shared_ptr<const VulkanCore>& core, const VulkanBuffer& buffer,
                        std::span<const BufferPiece> pieces);

}  // namespace honeycomb::Osd
