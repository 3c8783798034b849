/* A library without Vulkan has the functions all the same. */
#include "parts.h"
#include "shapes.h"

void test_vulkan_absent(void) {
  FAILS(hc_vulkan_create(NULL, NULL, NULL), HC_ERROR_UNSUPPORTED, "without Vulkan");
  FAILS(hc_vulkan_table_create(NULL, NULL, NULL, NULL), HC_ERROR_UNSUPPORTED, "without Vulkan");
  FAILS(hc_vulkan_table_get_sizes(NULL, NULL), HC_ERROR_UNSUPPORTED, "without Vulkan");
  FAILS(hc_vulkan_binding_create(NULL, NULL, NULL), HC_ERROR_UNSUPPORTED, "without Vulkan");
  FAILS(hc_vulkan_record(NULL, NULL), HC_ERROR_UNSUPPORTED, "without Vulkan");
  hc_vulkan_binding_destroy(NULL);
  hc_vulkan_table_destroy(NULL);
  hc_vulkan_destroy(NULL);
}
