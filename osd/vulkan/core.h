#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <thread>

#include "osd/vulkan/device.h"
#include "osd/vulkan/errors.h"
#include "osd/vulkan/functions.h"
#include "osd/vulkan/handles.h"

namespace honeycomb::Osd {

class MemoryPool;

/// How an evaluator uses its device. The defaults are for production; tests lower and break things.
struct VulkanEvaluatorOptions {
  /// Bytes of a storage buffer that may be bound at once, lowered to the device's maxStorageBufferRange; a page is the
  /// largest power of two within. 0: all that the device allows.
  std::uint64_t maxStorageBufferRange = 0;
  /// Workgroups in a row of a dispatch, lowered to maxComputeWorkGroupCount[0]. 0: all that the device allows.
  std::uint32_t maxWorkgroupsInRow = 0;
  /// Bytes of device memory the evaluator may hold at once with all its tables, bindings, sessions and what is staged;
  /// 0: all that the device has to give.
  std::uint64_t maxDeviceBytes = 0;
  /// A file that keeps compiled pipelines from one run to the next, see PipelineCache; empty: none. Written behind an
  /// upload that compiled something; a failure shows in VulkanEvaluator::savePipelines alone.
  std::filesystem::path pipelineCache{};
  /// A folder of kernels that replace the built-in ones whenever they change, see KernelFiles; empty: none.
  std::filesystem::path kernelFolder{};
  /// Texels of a tile table that may be bound at once, lowered to maxTexelBufferElements. 0: all that the device
  /// allows.
  std::uint32_t maxTexels = 0;
  /// Treat no memory as shared between host and device, as on a discrete GPU: everything goes through staging.
  bool stageEverything = false;
  /// Leave out the barriers between levels: results are wrong, and synchronization validation must say so.
  bool leaveOutBarriers = false;
};

/// What the limits of a device mean for pages and dispatches.
struct VulkanLimits {
  std::uint64_t pageBytes = 0;    ///< a power of two; storage buffers are bound in ranges of at most this
  std::uint64_t alignment = 0;    ///< of the offset of a bound range
  std::uint32_t groupsInRow = 0;  ///< workgroups in x
  std::uint32_t groupRows = 0;    ///< workgroups in y
  std::uint32_t texels = 0;       ///< of a texel buffer
  std::uint32_t sharedBytes = 0;  ///< of shared memory of a workgroup
  std::uint32_t groupSize = 0;    ///< invocations of a workgroup in x
  std::uint64_t pageNumbers() const { return pageBytes / sizeof(float); }
};

/// Pages of that many bytes.
inline std::uint64_t pagesOf(std::uint64_t bytes, const VulkanLimits& limits) {
  return (bytes + limits.pageBytes - 1) / limits.pageBytes;
}

/// Pages of a source that can be bound at once. shaders/source.glsl has the same number.
constexpr std::uint32_t kSourcePages = 8;

/// Invocations in a workgroup of every kernel: workgroups from 64 up measure alike on lavapipe.
constexpr std::uint32_t kWorkgroupSize = 64;

/// Threads that run the workgroups of a device that is a CPU: all of the machine.
inline std::uint32_t deviceThreads() {
  return std::max(1U, std::thread::hardware_concurrency());
}

/// What everything an evaluator makes refers to: the device, its functions, its limits.
struct VulkanCore {
  VulkanDevice device;
  VulkanFunctions functions;
  VulkanEvaluatorOptions options;
  VulkanLimits limits;
  std::uint32_t subgroupSize = 1;  ///< invocations of a full subgroup
  VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
  VkPhysicalDeviceMemoryProperties memory{};
  bool tellsBudget = false;  ///< by VK_EXT_memory_budget
  std::shared_ptr<MemoryPool> pool;

  const VulkanFunctions& vk() const { return functions; }

  /// Takes an object into ownership.
  template <class Handle>
  DeviceHandle<Handle> own(Handle handle, typename DeviceHandle<Handle>::Destroy destroy) const {
    return {device.device, handle, destroy, device.allocator};
  }
  /// An object made by one of the device's vkCreate functions; `doing` completes "Vulkan failed to ...".
  template <class Handle, class Info>
  Result<DeviceHandle<Handle>> make(VkResult(VKAPI_PTR* creator)(VkDevice, const Info*, const VkAllocationCallbacks*,
                                                                 Handle*),
                                    typename DeviceHandle<Handle>::Destroy destroy, const Info& info,
                                    const char* doing) const {
    Handle handle = VK_NULL_HANDLE;
    const VkResult result = creator(device.device, &info, device.allocator, &handle);
    if (result != VK_SUCCESS) return vulkanFailure(result, doing);
    return own(handle, destroy);
  }

  /// Errors: invalidOption for null handles and unusable limits, noDevice without a loader, unsupported below
  /// Vulkan 1.2.
  static Result<VulkanCore> create(const VulkanDevice& device, const VulkanEvaluatorOptions& options);
};

}  // namespace honeycomb::Osd
