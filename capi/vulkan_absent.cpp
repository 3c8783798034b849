// The Vulkan functions of a library that was built without it: the same functions, an error that says so.
#include "capi/failure.h"

namespace {

hc_status absent() {
  return honeycomb::Capi::report(nullptr, HC_ERROR_UNSUPPORTED,
                                 "this library was built without Vulkan; build it with HONEYCOMB_VULKAN, or use "
                                 "hc_evaluate()");
}

}  // namespace

hc_status hc_vulkan_create(hc_context*, const hc_vulkan_device*, hc_vulkan**) {
  return absent();
}
void hc_vulkan_destroy(hc_vulkan*) {}
hc_status hc_vulkan_table_create(hc_vulkan*, const hc_tables*, const hc_vulkan_table_options*, hc_vulkan_table**) {
  return absent();
}
void hc_vulkan_table_destroy(hc_vulkan_table*) {}
hc_status hc_vulkan_table_get_sizes(const hc_vulkan_table*, hc_vulkan_sizes*) {
  return absent();
}
hc_status hc_vulkan_binding_create(const hc_vulkan_table*, const hc_vulkan_targets*, hc_vulkan_binding**) {
  return absent();
}
void hc_vulkan_binding_destroy(hc_vulkan_binding*) {}
hc_status hc_vulkan_record(const hc_vulkan_binding*, struct VkCommandBuffer_T*) {
  return absent();
}
