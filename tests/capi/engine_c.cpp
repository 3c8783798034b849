#include "tests/capi/engine_c.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "tests/vulkan/engine.h"

using honeycomb::VulkanTests::Engine;

struct test_engine {
  std::vector<std::string> messages;
  std::unique_ptr<Engine> engine;
};

test_engine* test_engine_create() {
  const char* wanted = std::getenv("HONEYCOMB_VULKAN_VALIDATION");
  auto made = std::make_unique<test_engine>();
  made->engine = std::make_unique<Engine>(wanted != nullptr && std::string_view(wanted) == "1", made->messages);
  return made.release();
}

void test_engine_device(const test_engine* engine, hc_vulkan_device* device) {
  const Engine& own = *engine->engine;
  device->instance = own.instance();
  device->physical_device = own.physicalDevice();
  device->device = own.device();
  device->queue = own.queue();
  device->queue_family = own.queueFamily();
  device->get_instance_proc_addr = own.getInstanceProcAddr();
  device->get_device_proc_addr = own.getDeviceProcAddr();
}

test_buffer test_engine_buffer(test_engine* engine, uint64_t bytes) {
  const Engine::Buffer made = engine->engine->makeBuffer(bytes);
  return {made.buffer, made.bytes, made.numbers};
}

void test_engine_frame(test_engine* engine, void (*record)(void*, struct VkCommandBuffer_T*), void* user) {
  engine->engine->frame([&](VkCommandBuffer commands) { record(user, commands); });
}

int test_engine_destroy(test_engine* engine) {
  engine->engine.reset();
  for (const std::string& message : engine->messages) std::fprintf(stderr, "%s\n", message.c_str());
  const auto count = static_cast<int>(engine->messages.size());
  delete engine;
  return count;
}
