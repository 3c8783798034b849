#ifdef HONEYCOMB_SANITIZED

#include <dlfcn.h>

// The validation layer leaves some objects of its own behind when its instance is destroyed, and Mesa's software
// rasteriser a few blocks with every graphics pipeline it compiles and, on AMD's processors, the list of their caches;
// both are then unloaded, so that the leak checker can't name them. Here nothing is unloaded, and what is allocated
// inside these is passed over: an object of ours that isn't destroyed is what the layer itself reports, and memory of
// ours is allocated by our own code.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libVkLayer_khronos_validation.so\nleak:libvulkan_lvp.so\n";
}

// Seen by the loader of Vulkan too.
extern "C" [[gnu::visibility("default")]] int dlclose(void* /*library*/) noexcept {
  return 0;
}

#endif
