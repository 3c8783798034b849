#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "apps/viewer/calls.h"
#include "far/base/result.h"
#include "osd/vulkan/device.h"
#include "osd/vulkan/handles.h"

namespace honeycomb::Viewer {

/// A device as the renderer uses it: its own table of functions, so that several devices live side by side.
struct Gpu {
  Osd::VulkanDevice device;
  Calls call{};
  VkPhysicalDeviceLimits limits{};
  VkPhysicalDeviceMemoryProperties memory{};
};

/// A Vulkan handle that destroys itself.
template <class Handle>
using Owned = Osd::DeviceHandle<Handle>;

/// A buffer the host writes or reads through `mapped`, coherent.
struct Buffer {
  Owned<VkDeviceMemory> memory;
  Owned<VkBuffer> buffer;
  std::byte* mapped = nullptr;
  VkDeviceSize size = 0;
  VkBuffer get() const { return buffer.get(); }
};

struct Image {
  Owned<VkDeviceMemory> memory;
  Owned<VkImage> image;
  Owned<VkImageView> view;
};

/// A Vulkan structure of that type, all else zero.
template <class Structure>
Structure structure(VkStructureType type) {
  Structure made{};
  made.sType = type;
  return made;
}

/// What a buffer's memory is chosen for.
enum class Residence {
  device,   ///< read by the device; device-local where the host can write to it
  readback  ///< read by the host; cached
};

/// Creates Vulkan objects one after the other and remembers the first failure; after it nothing more is created, so
/// that a chain of steps needs a single check at its end.
class Maker {
 public:
  explicit Maker(const Gpu& gpu) : gpu_(gpu) {}

  const std::optional<Error>& error() const { return error_; }
  bool ok() const { return !error_.has_value(); }
  /// Keeps an error of ours, or one made from `result`; `what` completes "Vulkan failed to ...".
  void fail(Error error);
  void check(VkResult result, const char* what);

  /// A handle made by one of the device's vkCreate functions.
  template <class Handle, class Info>
  Owned<Handle> own(VkResult(VKAPI_PTR* create)(VkDevice, const Info*, const VkAllocationCallbacks*, Handle*),
                    typename Owned<Handle>::Destroy destroy, const Info& info, const char* what) {
    Handle handle = VK_NULL_HANDLE;
    if (ok()) check(create(gpu_.device.device, &info, gpu_.device.allocator, &handle), what);
    return ok() ? Owned<Handle>(gpu_.device.device, handle, destroy, gpu_.device.allocator) : Owned<Handle>();
  }

  Buffer buffer(VkDeviceSize bytes, VkBufferUsageFlags usage, Residence residence);
  /// A device buffer holding a copy of `content` (at least one byte is allocated).
  Buffer buffer(std::span<const std::byte> content, VkBufferUsageFlags usage);
  /// A 2-D image with one mip level in device memory, and its view.
  Image image(VkFormat format, VkExtent2D extent, VkSampleCountFlagBits samples, VkImageUsageFlags usage,
              VkImageAspectFlags aspect);

 private:
  Owned<VkDeviceMemory> allocate(const VkMemoryRequirements& needs, std::span<const VkMemoryPropertyFlags> wishes);

  const Gpu& gpu_;
  std::optional<Error> error_;
};

/// A primary command buffer; null after a failure.
VkCommandBuffer allocateCommandBuffer(Maker& make, const Gpu& gpu, VkCommandPool pool);
/// Submits to the device's queue, under its lock.
VkResult submit(const Gpu& gpu, const VkSubmitInfo& info, VkFence done);
/// Submits the recorded commands and waits for them; the fence is theirs alone.
void submitAndWait(Maker& make, const Gpu& gpu, VkCommandBuffer commands, VkFence done);

/// The device's functions and limits. Errors: of Osd::FunctionLoader.
Result<Gpu> openGpu(const Osd::VulkanDevice& device);

}  // namespace honeycomb::Viewer
