#pragma once

#include <vulkan/vulkan_core.h>

#include "far/base/result.h"

namespace honeycomb::Osd {

/// The name of a VkResult, such as VK_ERROR_DEVICE_LOST.
const char* resultName(VkResult result);

/// An error from a Vulkan call that failed; `doing` completes "Vulkan failed to ...".
///     VK_ERROR_DEVICE_LOST -> deviceLost, OUT_OF_*_MEMORY, OUT_OF_POOL_MEMORY, TOO_MANY_OBJECTS and failed maps ->
///     outOfMemory, missing layers, extensions, features and versions -> unsupported, INITIALIZATION_FAILED and an
///     incompatible driver -> noDevice, anything else -> unsupported
/// The code is right even where there is no memory for the text, which is "Vulkan failed" then.
Error vulkanError(VkResult result, const char* doing) noexcept;

/// vulkanError for returning from a function that returns a Result.
tl::unexpected<Error> vulkanFailure(VkResult result, const char* doing) noexcept;

}  // namespace honeycomb::Osd
