#include "apps/viewer/calls.h"

#include "osd/vulkan/functions.h"

namespace honeycomb::Viewer {

Result<Calls> Calls::load(const Osd::VulkanDevice& device) {
  auto loader = Osd::FunctionLoader::create(device);
  if (!loader) return tl::unexpected(loader.error());
  Calls calls;
#define HONEYCOMB_LOAD(name) loader->ofDevice(#name, calls.name);
  HONEYCOMB_VIEWER_FUNCTIONS(HONEYCOMB_LOAD)
#undef HONEYCOMB_LOAD
  loader->ofInstance("vkGetPhysicalDeviceFormatProperties", calls.vkGetPhysicalDeviceFormatProperties);
  loader->ofInstance("vkGetPhysicalDeviceMemoryProperties", calls.vkGetPhysicalDeviceMemoryProperties);
  loader->ofInstance("vkGetPhysicalDeviceProperties", calls.vkGetPhysicalDeviceProperties);
  if (const auto found = loader->found(); !found) return tl::unexpected(found.error());
  return calls;
}

}  // namespace honeycomb::Viewer
