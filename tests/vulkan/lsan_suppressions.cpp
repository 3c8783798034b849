#if defined(__SANITIZE_ADDRESS__)

#include <dlfcn.h>

// The validation layer leaves some objects of its own behind when its instance is destroyed, and is then unloaded, so
// that the leak checker can't name it. It is kept loaded, and what is allocated inside it is passed over: an object of
// ours that isn't destroyed is what the layer itself reports, and memory of ours is allocated by our own code.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libVkLayer_khronos_validation.so\n";
}

namespace {
const void* const kKeptLoaded = dlopen("libVkLayer_khronos_validation.so", RTLD_LAZY | RTLD_NODELETE);
}

#endif
