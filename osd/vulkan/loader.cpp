#include "osd/vulkan/loader.h"

// The one translation unit that holds volk, which finds the Vulkan loader when the program runs. Of volk's globals
// nothing but vkGetInstanceProcAddr is looked at, and that is the same for everybody.
#define VOLK_IMPLEMENTATION
#include <volk.h>

#include <mutex>

namespace honeycomb::Osd {

Result<PFN_vkGetInstanceProcAddr> loadVulkan() {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  if (volkInitialize() != VK_SUCCESS) {
    return fail(
        ErrorCode::noDevice,
        "no Vulkan loader found: install libvulkan1 and a driver such as mesa-vulkan-drivers, or use a CPU backend");
  }
  return vkGetInstanceProcAddr;
}

}  // namespace honeycomb::Osd
