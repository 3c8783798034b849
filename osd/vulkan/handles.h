#pragma once

#include <vulkan/vulkan_core.h>

#include <utility>

namespace honeycomb::Osd {

/// Owns one object of a device, whatever its type: destroyed by the function and the callbacks given with it.
template <class Handle>
class DeviceHandle {
 public:
  /// The function of Vulkan that destroys it.
  using Destroy = void(VKAPI_PTR*)(VkDevice, Handle, const VkAllocationCallbacks*);

  DeviceHandle() = default;
  DeviceHandle(VkDevice device, Handle handle, Destroy destroy, const VkAllocationCallbacks* allocator)
      : device_(device), handle_(handle), destroy_(destroy), allocator_(allocator) {}
  DeviceHandle(DeviceHandle&& other) noexcept
      : device_(other.device_),
        handle_(std::exchange(other.handle_, VK_NULL_HANDLE)),
        destroy_(other.destroy_),
        allocator_(other.allocator_) {}
  DeviceHandle& operator=(DeviceHandle&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    std::swap(destroy_, other.destroy_);
    std::swap(allocator_, other.allocator_);
    return *this;
  }
  DeviceHandle(const DeviceHandle&) = delete;
  DeviceHandle& operator=(const DeviceHandle&) = delete;
  ~DeviceHandle() {
    if (handle_ != VK_NULL_HANDLE) destroy_(device_, handle_, allocator_);
  }

  Handle get() const { return handle_; }
  explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }

 private:
  VkDevice device_ = VK_NULL_HANDLE;
  Handle handle_ = VK_NULL_HANDLE;
  Destroy destroy_ = nullptr;
  const VkAllocationCallbacks* allocator_ = nullptr;
};

}  // namespace honeycomb::Osd
