#include "osd/vulkan/loader.h"

#if defined(_WIN32)
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace honeycomb::Osd {

namespace {

// Opened by hand: volk would define the names of all Vulkan functions, and a program that is linked with the loader
// itself, as engines are, would call volk's empty pointers. Never closed: drivers don't like to be unloaded.
PFN_vkGetInstanceProcAddr openLoader() {
#if defined(_WIN32)
  const HMODULE library = LoadLibraryA("vulkan-1.dll");
  if (library == nullptr) return nullptr;
  return reinterpret_cast<PFN_vkGetInstanceProcAddr>(
      reinterpret_cast<void*>(GetProcAddress(library, "vkGetInstanceProcAddr")));
#else
#if defined(__APPLE__)
  constexpr const char* kNames[] = {"libvulkan.dylib", "libvulkan.1.dylib", "libMoltenVK.dylib"};
#else
  constexpr const char* kNames[] = {"libvulkan.so.1", "libvulkan.so"};
#endif
  void* library = nullptr;
  for (const char* name : kNames) {
    if (library == nullptr) library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  }
  if (library == nullptr) return nullptr;
  return reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(library, "vkGetInstanceProcAddr"));
#endif
}

}  // namespace

Result<PFN_vkGetInstanceProcAddr> loadVulkan() {
  static const PFN_vkGetInstanceProcAddr get = openLoader();
  if (get == nullptr) {
    return fail(
        ErrorCode::noDevice,
        "no Vulkan loader found: install libvulkan1 and a driver such as mesa-vulkan-drivers, or use a CPU backend");
  }
  return get;
}

}  // namespace honeycomb::Osd
