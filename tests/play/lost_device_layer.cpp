// A Vulkan layer that takes a device away from a program: once there is a file of the name in HONEYCOMB_LOSE_DEVICE,
// the next submission to a device that draws in a window removes it and fails, and so does everything that is asked of
// that device afterwards, as after a reset of a GPU. Devices that are made later work.

#include <unistd.h>
#include <vulkan/vk_layer.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>

namespace {

/// What the next layer, or the driver, has for a device.
struct DeviceCalls {
  PFN_vkGetDeviceProcAddr find = nullptr;
  VkDevice device = VK_NULL_HANDLE;
  bool presents = false;
  bool lost = false;

  template <class Function>
  Function next(const char* name) const {
    return reinterpret_cast<Function>(find(device, name));
  }
};

struct Layer {
  std::mutex mutex;
  std::map<void*, PFN_vkGetInstanceProcAddr> instances;
  std::map<void*, DeviceCalls> devices;
};

Layer& layer() {
  static Layer one;
  return one;
}

/// The loader's table, which a device and its queues share.
void* keyOf(const void* handle) {
  return *static_cast<void* const*>(handle);
}

DeviceCalls callsOf(const void* handle) {
  const std::lock_guard lock(layer().mutex);
  return layer().devices.at(keyOf(handle));
}

/// Is the device gone, or is now the time?
bool isLost(const void* handle) {
  const std::lock_guard lock(layer().mutex);
  DeviceCalls& calls = layer().devices.at(keyOf(handle));
  const char* order = std::getenv("HONEYCOMB_LOSE_DEVICE");
  if (calls.presents && !calls.lost && order != nullptr && unlink(order) == 0) {
    // What a lost device had begun is over.
    calls.next<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle")(calls.device);
    calls.lost = true;
  }
  return calls.lost;
}

template <class Info>
VkLayerInstanceCreateInfo* instanceLink(const Info* info) {
  auto* entry = static_cast<VkLayerInstanceCreateInfo*>(const_cast<void*>(info->pNext));
  while (entry->sType != VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO || entry->function != VK_LAYER_LINK_INFO)
    entry = static_cast<VkLayerInstanceCreateInfo*>(const_cast<void*>(entry->pNext));
  return entry;
}

VkLayerDeviceCreateInfo* deviceLink(const VkDeviceCreateInfo* info) {
  auto* entry = static_cast<VkLayerDeviceCreateInfo*>(const_cast<void*>(info->pNext));
  while (entry->sType != VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO || entry->function != VK_LAYER_LINK_INFO)
    entry = static_cast<VkLayerDeviceCreateInfo*>(const_cast<void*>(entry->pNext));
  return entry;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* instance) {
  VkLayerInstanceCreateInfo* link = instanceLink(info);
  const PFN_vkGetInstanceProcAddr find = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create = reinterpret_cast<PFN_vkCreateInstance>(find(VK_NULL_HANDLE, "vkCreateInstance"));
  const VkResult result = create(info, allocator, instance);
  if (result != VK_SUCCESS) return result;
  const std::lock_guard lock(layer().mutex);
  layer().instances[keyOf(*instance)] = find;
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
  VkLayerDeviceCreateInfo* link = deviceLink(info);
  const PFN_vkGetInstanceProcAddr findInstance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  const PFN_vkGetDeviceProcAddr find = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create = reinterpret_cast<PFN_vkCreateDevice>(findInstance(VK_NULL_HANDLE, "vkCreateDevice"));
  const VkResult result = create(physical, info, allocator, device);
  if (result != VK_SUCCESS) return result;
  const std::lock_guard lock(layer().mutex);
  const char* const* extensions = info->ppEnabledExtensionNames;
  const bool presents = std::any_of(extensions, extensions + info->enabledExtensionCount, [](const char* name) {
    return std::strcmp(name, VK_KHR_SWAPCHAIN_EXTENSION_NAME) == 0;
  });
  layer().devices[keyOf(*device)] = {find, *device, presents, false};
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL queueSubmit(VkQueue queue, std::uint32_t count, const VkSubmitInfo* submits,
                                           VkFence fence) {
  if (isLost(queue)) return VK_ERROR_DEVICE_LOST;
  return callsOf(queue).next<PFN_vkQueueSubmit>("vkQueueSubmit")(queue, count, submits, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL waitForFences(VkDevice device, std::uint32_t count, const VkFence* fences, VkBool32 all,
                                             std::uint64_t timeout) {
  const DeviceCalls calls = callsOf(device);
  if (calls.lost) return VK_ERROR_DEVICE_LOST;
  return calls.next<PFN_vkWaitForFences>("vkWaitForFences")(device, count, fences, all, timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL waitSemaphores(VkDevice device, const VkSemaphoreWaitInfo* info, std::uint64_t timeout) {
  const DeviceCalls calls = callsOf(device);
  if (calls.lost) return VK_ERROR_DEVICE_LOST;
  return calls.next<PFN_vkWaitSemaphores>("vkWaitSemaphores")(device, info, timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL queuePresent(VkQueue queue, const VkPresentInfoKHR* info) {
  const DeviceCalls calls = callsOf(queue);
  if (calls.lost) return VK_ERROR_DEVICE_LOST;
  return calls.next<PFN_vkQueuePresentKHR>("vkQueuePresentKHR")(queue, info);
}

VKAPI_ATTR VkResult VKAPI_CALL deviceWaitIdle(VkDevice device) {
  const DeviceCalls calls = callsOf(device);
  if (calls.lost) return VK_ERROR_DEVICE_LOST;
  return calls.next<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle")(device);
}

PFN_vkVoidFunction ownFunction(const char* name) {
  const auto is = [name](const char* other) { return std::strcmp(name, other) == 0; };
  if (is("vkCreateInstance")) return reinterpret_cast<PFN_vkVoidFunction>(createInstance);
  if (is("vkCreateDevice")) return reinterpret_cast<PFN_vkVoidFunction>(createDevice);
  if (is("vkQueueSubmit")) return reinterpret_cast<PFN_vkVoidFunction>(queueSubmit);
  if (is("vkWaitForFences")) return reinterpret_cast<PFN_vkVoidFunction>(waitForFences);
  if (is("vkWaitSemaphores")) return reinterpret_cast<PFN_vkVoidFunction>(waitSemaphores);
  if (is("vkQueuePresentKHR")) return reinterpret_cast<PFN_vkVoidFunction>(queuePresent);
  if (is("vkDeviceWaitIdle")) return reinterpret_cast<PFN_vkVoidFunction>(deviceWaitIdle);
  return nullptr;
}

}  // namespace

extern "C" {

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL loseDeviceGetDeviceProcAddr(VkDevice device, const char* name) {
  if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
    return reinterpret_cast<PFN_vkVoidFunction>(loseDeviceGetDeviceProcAddr);
  if (const PFN_vkVoidFunction own = ownFunction(name)) return own;
  return callsOf(device).find(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL loseDeviceGetInstanceProcAddr(VkInstance instance, const char* name) {
  if (std::strcmp(name, "vkGetInstanceProcAddr") == 0)
    return reinterpret_cast<PFN_vkVoidFunction>(loseDeviceGetInstanceProcAddr);
  if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
    return reinterpret_cast<PFN_vkVoidFunction>(loseDeviceGetDeviceProcAddr);
  if (const PFN_vkVoidFunction own = ownFunction(name)) return own;
  if (instance == VK_NULL_HANDLE) return nullptr;
  const std::lock_guard lock(layer().mutex);
  return layer().instances.at(keyOf(instance))(instance, name);
}
}
