// An existing Vulkan app, with an instance, a device, a queue and a command buffer of its own, adds honeycomb
// refinement to its frame: steps 1 to 4 in main(). Prints each frame's points and checksum, and fails where they aren't
// the CPU's.
#include <vulkan/vulkan.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "far/schemes/akleman.h"
#include "osd/cpu_evaluator.h"
#include "osd/vulkan/evaluator.h"

namespace {

using namespace honeycomb;

template <class T>
T must(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.error().message.c_str());
  std::exit(1);
}

void check(VkResult result) {
  if (result == VK_SUCCESS) return;
  std::fprintf(stderr, "Vulkan error %d\n", result);
  std::exit(1);
}

/// What an engine has before it meets honeycomb; its handles live as long as the program.
struct App {
  Osd::VulkanDevice vulkan;
  VkCommandPool pool = VK_NULL_HANDLE;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  VkFence done = VK_NULL_HANDLE;

  App() {
    const VkApplicationInfo name{VK_STRUCTURE_TYPE_APPLICATION_INFO, nullptr, "app", 1, "app", 1, VK_API_VERSION_1_2};
    VkInstanceCreateInfo instance{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, nullptr, 0, &name, 0, nullptr, 0, nullptr};
    check(vkCreateInstance(&instance, nullptr, &vulkan.instance));
    std::uint32_t count = 1;  // the first device, and its first queue family, which is a general one on most
    if (vkEnumeratePhysicalDevices(vulkan.instance, &count, &vulkan.physicalDevice) < 0 || count == 0) std::exit(1);
    const float priority = 1;
    const VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, nullptr, 0, 0, 1, &priority};
    const VkDeviceCreateInfo device{
        VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, nullptr, 0, 1, &queue, 0, nullptr, 0, nullptr, nullptr};
    check(vkCreateDevice(vulkan.physicalDevice, &device, nullptr, &vulkan.device));
    vkGetDeviceQueue(vulkan.device, 0, 0, &vulkan.queue);
    constexpr VkFlags kAnew = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    const VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, kAnew, 0};
    check(vkCreateCommandPool(vulkan.device, &poolInfo, nullptr, &pool));
    const VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool,
                                           VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    check(vkAllocateCommandBuffers(vulkan.device, &info, &commands));
    const VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, nullptr, 0};
    check(vkCreateFence(vulkan.device, &fence, nullptr, &done));
  }
  ~App() {
    vkDestroyFence(vulkan.device, done, nullptr);
    vkDestroyCommandPool(vulkan.device, pool, nullptr);
    vkDestroyDevice(vulkan.device, nullptr);
    vkDestroyInstance(vulkan.instance, nullptr);
  }
};

/// One of the engine's buffers: for kernels and vertices, in memory that the host sees (type 0 .. of the device).
struct Buffer {
  VkDevice device;
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize bytes = 0;
  float* numbers = nullptr;

  Osd::VulkanRange range() const { return {buffer, 0, bytes}; }
  Buffer(const Osd::VulkanDevice& owner, VkDeviceSize size) : device(owner.device), bytes(size) {
    constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT;
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, nullptr, 0, bytes, kUsage, {}, 0, nullptr};
    check(vkCreateBuffer(device, &info, nullptr, &buffer));
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, buffer, &needs);
    VkPhysicalDeviceMemoryProperties types;
    vkGetPhysicalDeviceMemoryProperties(owner.physicalDevice, &types);
    constexpr VkFlags kWanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    std::uint32_t type = 0;  // Vulkan promises one of these
    while ((~types.memoryTypes[type].propertyFlags & kWanted) != 0 || (needs.memoryTypeBits >> type & 1U) == 0) ++type;
    const VkMemoryAllocateInfo allocation{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, needs.size, type};
    check(vkAllocateMemory(device, &allocation, nullptr, &memory));
    check(vkBindBufferMemory(device, buffer, memory, 0));
    check(vkMapMemory(device, memory, 0, VK_WHOLE_SIZE, 0, reinterpret_cast<void**>(&numbers)));
  }
  ~Buffer() {
    vkDestroyBuffer(device, buffer, nullptr);
    vkFreeMemory(device, memory, nullptr);
  }
};

std::uint32_t checksum(std::span<const float> numbers) {
  std::uint32_t sum = 0;
  for (const float number : numbers) sum = std::rotl(sum, 1) ^ std::bit_cast<std::uint32_t>(number);
  return sum;
}

}  // namespace

int main() {
  App app;
  Far::Polygons cube;
  cube.vertexCount = 8;
  for (const auto& face :
       {std::vector{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    cube.addFace(face);

  // 1. Once per mesh: the refinement's tables, and the evaluator on the app's own device.
  const auto refinement = must(Far::refine(must(Far::Topology::create(cube)), must(Far::akleman()), 4));
  auto evaluator = must(Osd::VulkanEvaluator::create(app.vulkan));
  const auto table = must(evaluator.upload(refinement));
  // 2. The app's buffers, bound to the table.
  const Buffer control(app.vulkan, table.bytesOf(Osd::PointBuffer::control));
  const Buffer refined(app.vulkan, table.bytesOf(Osd::PointBuffer::refined));
  const auto binding = must(evaluator.bind(table, {.control = control.range(), .refined = refined.range()}));

  for (int frame = 0; frame < 3; ++frame) {
    for (int i = 0; i < 24; ++i) control.numbers[i] = std::sin(0.1F * static_cast<float>((frame + 5) * i));
    const VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, nullptr, 0, nullptr};
    check(vkBeginCommandBuffer(app.commands, &begin));
    // 3. In the frame's commands: refinement, then a barrier to those who read: here the host, else VERTEX_INPUT.
    evaluator.record(app.commands, binding);
    constexpr VkFlags kWritten = VK_ACCESS_SHADER_WRITE_BIT, kRead = VK_ACCESS_HOST_READ_BIT;
    const VkMemoryBarrier visible{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, kWritten, kRead};
    constexpr VkFlags kBefore = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, kAfter = VK_PIPELINE_STAGE_HOST_BIT;
    vkCmdPipelineBarrier(app.commands, kBefore, kAfter, 0, 1, &visible, 0, nullptr, 0, nullptr);
    check(vkEndCommandBuffer(app.commands));
    // 4. Submitted as ever, by the app.
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO, nullptr, 0, nullptr, nullptr, 1, &app.commands, 0, nullptr};
    check(vkQueueSubmit(app.vulkan.queue, 1, &submit, app.done));
    check(vkWaitForFences(app.vulkan.device, 1, &app.done, VK_TRUE, UINT64_MAX));
    check(vkResetFences(app.vulkan.device, 1, &app.done));
    std::vector<float> expected(refined.bytes / sizeof(float));
    if (!Osd::SerialEvaluator().evaluate<float>(refinement, 4, {{control.numbers, 24}, {}}, {expected, {}})) return 1;
    const bool same = std::memcmp(expected.data(), refined.numbers, refined.bytes) == 0;
    std::printf("frame %d: %zu points, checksum %08x, %s the CPU's\n", frame, expected.size() / 3,
                checksum({refined.numbers, expected.size()}), same ? "the same as" : "NOT");
    if (!same) return 1;
  }
  return 0;
}
