#include "osd/vulkan/errors.h"

#include <fmt/format.h>

#include <new>

namespace honeycomb::Osd {

const char* resultName(VkResult result) {
  switch (result) {
    case VK_SUCCESS:
      return "VK_SUCCESS";
    case VK_NOT_READY:
      return "VK_NOT_READY";
    case VK_TIMEOUT:
      return "VK_TIMEOUT";
    case VK_INCOMPLETE:
      return "VK_INCOMPLETE";
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "VK_ERROR_OUT_OF_HOST_MEMORY";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
    case VK_ERROR_OUT_OF_POOL_MEMORY:
      return "VK_ERROR_OUT_OF_POOL_MEMORY";
    case VK_ERROR_FRAGMENTED_POOL:
      return "VK_ERROR_FRAGMENTED_POOL";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "VK_ERROR_INITIALIZATION_FAILED";
    case VK_ERROR_DEVICE_LOST:
      return "VK_ERROR_DEVICE_LOST";
    case VK_ERROR_MEMORY_MAP_FAILED:
      return "VK_ERROR_MEMORY_MAP_FAILED";
    case VK_ERROR_LAYER_NOT_PRESENT:
      return "VK_ERROR_LAYER_NOT_PRESENT";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
      return "VK_ERROR_EXTENSION_NOT_PRESENT";
    case VK_ERROR_FEATURE_NOT_PRESENT:
      return "VK_ERROR_FEATURE_NOT_PRESENT";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "VK_ERROR_INCOMPATIBLE_DRIVER";
    case VK_ERROR_TOO_MANY_OBJECTS:
      return "VK_ERROR_TOO_MANY_OBJECTS";
    case VK_ERROR_INVALID_SHADER_NV:
      return "VK_ERROR_INVALID_SHADER_NV";
    default:
      return "an unknown VkResult";
  }
}

namespace {

ErrorCode codeOf(VkResult result) {
  switch (result) {
    case VK_ERROR_DEVICE_LOST:
      return ErrorCode::deviceLost;
    case VK_ERROR_OUT_OF_HOST_MEMORY:
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    case VK_ERROR_OUT_OF_POOL_MEMORY:
    case VK_ERROR_FRAGMENTED_POOL:
    case VK_ERROR_MEMORY_MAP_FAILED:
    case VK_ERROR_TOO_MANY_OBJECTS:
      return ErrorCode::outOfMemory;
    case VK_ERROR_INITIALIZATION_FAILED:
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return ErrorCode::noDevice;
    default:
      return ErrorCode::unsupported;
  }
}

const char* remedyOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::deviceLost:
      return "create the device anew, or use a CPU backend";
    case ErrorCode::outOfMemory:
      return "refine fewer levels, or use a CPU backend";
    default:
      return "update the Vulkan driver, or use a CPU backend";
  }
}

}  // namespace

Error vulkanError(VkResult result, const char* doing) noexcept {
  const ErrorCode code = codeOf(result);
  try {
    return {code, fmt::format("Vulkan failed to {}: {} ({}); {}", doing, resultName(result), static_cast<int>(result),
                              remedyOf(code))};
  } catch (const std::bad_alloc&) {
    return {code, "Vulkan failed"};  // within std::string itself
  }
}

tl::unexpected<Error> vulkanFailure(VkResult result, const char* doing) noexcept {
  return tl::unexpected<Error>(vulkanError(result, doing));
}

}  // namespace honeycomb::Osd
