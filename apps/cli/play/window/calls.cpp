#include "apps/cli/play/window/calls.h"

#include "osd/vulkan/functions.h"

namespace honeycomb::Cli::Play {

Result<WindowCalls> WindowCalls::load(const Osd::VulkanDevice& device) {
  auto loader = Osd::FunctionLoader::create(device);
  if (!loader) return tl::unexpected(loader.error());
  WindowCalls calls;
#define HONEYCOMB_LOAD(name) loader->ofDevice(#name, calls.name);
  HONEYCOMB_WINDOW_FUNCTIONS(HONEYCOMB_LOAD)
#undef HONEYCOMB_LOAD
#define HONEYCOMB_LOAD(name) loader->ofInstance(#name, calls.name);
  HONEYCOMB_WINDOW_INSTANCE_FUNCTIONS(HONEYCOMB_LOAD)
#undef HONEYCOMB_LOAD
  if (const auto found = loader->found(); !found) return tl::unexpected(found.error());
  return calls;
}

}  // namespace honeycomb::Cli::Play
