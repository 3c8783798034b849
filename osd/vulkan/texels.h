#pragma once

#include <memory>

#include "far/base/result.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/handles.h"
#include "osd/vulkan/memory.h"

namespace honeycomb::Osd {

/// The bytes of a texel of four words or numbers.
constexpr std::uint64_t kTexelBytes = 16;

/// The first `texels` texels of a buffer, which has a texel usage. `format` is one of 16 bytes. Errors: outOfMemory.
Result<DeviceHandle<VkBufferView>> viewTexels(const VulkanCore& core, const VulkanBuffer& buffer, VkFormat format,
                                              std::uint64_t texels);

}  // namespace honeycomb::Osd
