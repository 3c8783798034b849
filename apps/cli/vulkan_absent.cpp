#include "apps/cli/devices.h"
#include "apps/cli/surface_evaluator.h"

namespace honeycomb::Cli {

Result<std::unique_ptr<Backend>> openVulkan() {
  return fail(ErrorCode::noDevice,
              "--backend vulkan: this build has no Vulkan; use --backend tbb, or build with -DHONEYCOMB_VULKAN=ON");
}

Result<std::vector<VulkanDeviceInfo>> vulkanDevices() {
  return fail(ErrorCode::noDevice, "this build has no Vulkan; build with -DHONEYCOMB_VULKAN=ON to get it");
}

}  // namespace honeycomb::Cli
