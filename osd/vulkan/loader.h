#pragma once

#include <vulkan/vulkan_core.h>

#include "far/base/result.h"

namespace honeycomb::Osd {

/// vkGetInstanceProcAddr of the machine's Vulkan loader, which is opened the first time; noDevice when there is none.
/// May be called from several threads at once.
Result<PFN_vkGetInstanceProcAddr> loadVulkan();

}  // namespace honeycomb::Osd
