#ifdef HONEYCOMB_SANITIZED

#include <dlfcn.h>

// The validation layer leaves some objects of its own behind when its instance is destroyed, and Mesa's software
// rasteriser a few blocks with every graphics pipeline it compiles; both are then unloaded, so that the leak checker
// can't name them. They are kept loaded, and what is allocated inside them is passed over: an object of ours that isn't
// destroyed is what the layer itself reports, and memory of ours is allocated by our own code.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libVkLayer_khronos_validation.so\nleak:libvulkan_lvp.so\n";
}

namespace {
const void* const kKeptLayer = dlopen("libVkLayer_khronos_validation.so", RTLD_LAZY | RTLD_NODELETE);
const void* const kKeptDriver = dlopen("libvulkan_lvp.so", RTLD_LAZY | RTLD_NODELETE);
}  // namespace

#endif
