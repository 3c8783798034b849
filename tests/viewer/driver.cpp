#include "tests/viewer/driver.h"

#include "osd/vulkan/context.h"

namespace honeycomb::ViewerTests {

void keepDriverLoaded() {
  static const auto* const keeper = new Result<Osd::VulkanContext>(Osd::VulkanContext::create());
  static_cast<void>(keeper);
}

}  // namespace honeycomb::ViewerTests
