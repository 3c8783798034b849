#pragma once

#include <vulkan/vulkan_core.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace honeycomb::VulkanTests {

/// Allocation callbacks of a caller who counts. Stays where it is made; safe from several threads.
class CountingCallbacks {
 public:
  CountingCallbacks() : callbacks_{this, allocate, reallocate, release, nullptr, nullptr} {}
  CountingCallbacks(const CountingCallbacks&) = delete;
  CountingCallbacks& operator=(const CountingCallbacks&) = delete;

  const VkAllocationCallbacks* callbacks() const { return &callbacks_; }
  /// Allocations that weren't freed.
  std::int64_t live() const { return live_; }
  /// Calls that allocate or reallocate.
  std::int64_t calls() const { return calls_; }

 private:
  // In front of each allocation: where it begins, and how large it is.
  struct Header {
    void* begin = nullptr;
    std::size_t size = 0;
  };

  static VKAPI_ATTR void* VKAPI_CALL allocate(void* self, std::size_t size, std::size_t alignment,
                                              VkSystemAllocationScope) {
    const std::size_t step = std::max(alignment, alignof(std::max_align_t));
    const std::size_t front = (sizeof(Header) + step - 1) / step * step;
    void* const begin = std::aligned_alloc(step, front + (size + step - 1) / step * step);
    if (begin == nullptr) return nullptr;
    auto* const data = static_cast<std::byte*>(begin) + front;
    const Header header{begin, size};
    std::memcpy(data - sizeof(Header), &header, sizeof(Header));
    ++static_cast<CountingCallbacks*>(self)->live_;
    ++static_cast<CountingCallbacks*>(self)->calls_;
    return data;
  }

  static VKAPI_ATTR void* VKAPI_CALL reallocate(void* self, void* old, std::size_t size, std::size_t alignment,
                                                VkSystemAllocationScope scope) {
    void* const data = size == 0 ? nullptr : allocate(self, size, alignment, scope);
    if (old != nullptr && (data != nullptr || size == 0)) {
      if (data != nullptr) std::memcpy(data, old, std::min(size, headerOf(old).size));
      release(self, old);
    }
    return data;
  }

  static VKAPI_ATTR void VKAPI_CALL release(void* self, void* data) {
    if (data == nullptr) return;
    --static_cast<CountingCallbacks*>(self)->live_;
    std::free(headerOf(data).begin);
  }

  static Header headerOf(void* data) {
    Header header;
    std::memcpy(&header, static_cast<std::byte*>(data) - sizeof(Header), sizeof(Header));
    return header;
  }

  VkAllocationCallbacks callbacks_;
  std::atomic<std::int64_t> live_ = 0, calls_ = 0;
};

}  // namespace honeycomb::VulkanTests
