#include "osd/vulkan/memory_budget.h"

#include <fmt/format.h>

namespace honeycomb::Osd {

namespace {

MemoryRoom roomOfHeap(const VulkanCore& core, std::uint32_t heap, std::uint64_t heldOfHeap) {
  if (!core.tellsBudget) return {heldOfHeap, core.memory.memoryHeaps[heap].size, "the size of the device's heap", ""};
  VkPhysicalDeviceMemoryBudgetPropertiesEXT budget{};
  budget.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT;
  VkPhysicalDeviceMemoryProperties2 memory{};
  memory.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2;
  memory.pNext = &budget;
  core.vk().vkGetPhysicalDeviceMemoryProperties2(core.device.physicalDevice, &memory);
  return {budget.heapUsage[heap], budget.heapBudget[heap], "the budget of the device's heap",
          "close other programs that use the device, "};
}

}  // namespace

MemoryRoom roomOf(const VulkanCore& core, std::uint32_t heap, std::uint64_t held, std::uint64_t heldOfHeap) {
  const MemoryRoom device = roomOfHeap(core, heap, heldOfHeap);
  if (core.options.maxDeviceBytes == 0) return device;
  const MemoryRoom own{held, core.options.maxDeviceBytes, "VulkanEvaluatorOptions::maxDeviceBytes", "raise it, "};
  return own.left() < device.left() ? own : device;
}

Error outOfDeviceMemory(std::uint64_t bytes, const MemoryRoom& room) {
  return {ErrorCode::outOfMemory,
          fmt::format("out of Vulkan device memory: {} bytes asked for, {} of {} are in use ({}); refine fewer levels, "
                      "free tables and sessions, {}or use a CPU backend",
                      bytes, room.used, room.limit, room.name, room.advice)};
}

}  // namespace honeycomb::Osd
