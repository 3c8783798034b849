#include "osd/vulkan/level_timer.h"

#include <utility>

#include "osd/vulkan/errors.h"

namespace honeycomb::Osd {

namespace {

/// Bits of a timestamp that the queue family writes.
std::uint32_t timestampBits(const VulkanCore& core) {
  const auto query = core.vk().vkGetPhysicalDeviceQueueFamilyProperties;
  std::uint32_t count = 0;
  query(core.device.physicalDevice, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  query(core.device.physicalDevice, &count, families.data());
  return core.device.queueFamily < count ? families[core.device.queueFamily].timestampValidBits : 0;
}

double nanosecondsPerTick(const VulkanCore& core) {
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  core.vk().vkGetPhysicalDeviceProperties2(core.device.physicalDevice, &properties);
  return static_cast<double>(properties.properties.limits.timestampPeriod);
}

}  // namespace

Result<LevelTimer> LevelTimer::create(const std::shared_ptr<const VulkanCore>& core, std::uint32_t parts) {
  const std::uint32_t bits = timestampBits(*core);
  if (bits == 0) {
    return fail(ErrorCode::unsupported,
                "the Vulkan device's queue has no timestamps: leave timing off, or choose another device");
  }
  LevelTimer timer;
  timer.core_ = core;
  timer.parts_ = parts;
  timer.millisecondsPerTick_ = 1e-6 * nanosecondsPerTick(*core);
  timer.validTicks_ = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
  VkQueryPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = parts + 1;
  auto pool = core->make(core->vk().vkCreateQueryPool, core->vk().vkDestroyQueryPool, info, "create a query pool");
  if (!pool) return tl::unexpected(pool.error());
  timer.pool_ = std::move(*pool);
  return timer;
}

void LevelTimer::start(VkCommandBuffer commands) const {
  core_->vk().vkCmdResetQueryPool(commands, pool_.get(), 0, parts_ + 1);
  stamp(commands, 0);
}

void LevelTimer::finish(VkCommandBuffer commands, std::uint32_t part) const {
  stamp(commands, part + 1);
}

// Written when all dispatches before it have run.
void LevelTimer::stamp(VkCommandBuffer commands, std::uint32_t query) const {
  core_->vk().vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, pool_.get(), query);
}

Result<std::vector<double>> LevelTimer::milliseconds() const {
  std::vector<std::uint64_t> ticks(parts_ + 1);
  const VkResult result = core_->vk().vkGetQueryPoolResults(core_->device.device, pool_.get(), 0, parts_ + 1,
                                                            ticks.size() * sizeof(std::uint64_t), ticks.data(),
                                                            sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT);
  if (result == VK_NOT_READY) {
    return fail(ErrorCode::invalidOption, "the times of a frame are wanted that hasn't run: wait for it first");
  }
  if (result != VK_SUCCESS) return vulkanFailure(result, "read timestamps");
  std::vector<double> times;
  for (std::uint32_t part = 0; part < parts_; ++part) {
    // A counter of few bits may have wrapped round.
    const std::uint64_t passed = (ticks[part + 1] - ticks[part]) & validTicks_;
    times.push_back(static_cast<double>(passed) * millisecondsPerTick_);
  }
  return times;
}

}  // namespace honeycomb::Osd
