/* tests/vulkan/engine.h, the tiny engine with a device of its own, for C. */
#ifndef HONEYCOMB_TESTS_CAPI_ENGINE_C_H
#define HONEYCOMB_TESTS_CAPI_ENGINE_C_H

#include "honeycomb.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct test_engine test_engine;
typedef struct {
  hc_vk_buffer buffer;
  uint64_t bytes;
  float* numbers; /* mapped for good */
} test_buffer;

/* With HONEYCOMB_VULKAN_VALIDATION=1 in the environment under the validation layer. Ends the program where it can't. */
test_engine* test_engine_create(void);
void test_engine_device(const test_engine* engine, hc_vulkan_device* device);
test_buffer test_engine_buffer(test_engine* engine, uint64_t bytes);
/* Lets `record` record into the engine's command buffer, submits and waits. */
void test_engine_frame(test_engine* engine, void (*record)(void* user, struct VkCommandBuffer_T* commands), void* user);
/* What the validation layer has said, printed. */
int test_engine_destroy(test_engine* engine);

#ifdef __cplusplus
}
#endif

#endif
