#include "osd/vulkan/pipeline_cache.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "osd/vulkan/errors.h"
#include "osd/vulkan/pipelines.h"

namespace honeycomb::Osd {

namespace {

PipelineCacheKey keyOf(const VulkanCore& core) {
  VkPhysicalDeviceIDProperties ids{};
  ids.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &ids;
  core.vk().vkGetPhysicalDeviceProperties2(core.device.physicalDevice, &properties);
  PipelineCacheKey key;
  key.vendor = properties.properties.vendorID;
  key.device = properties.properties.deviceID;
  std::ranges::copy(ids.driverUUID, key.driverUuid.begin());
  std::ranges::copy(properties.properties.pipelineCacheUUID, key.cacheUuid.begin());
  key.kernels = contentHash({});
  for (std::uint32_t k = 0; k < kKernelCount; ++k)
    key.kernels = contentHash(std::as_bytes(kernelCode(static_cast<Kernel>(k))), key.kernels);
  return key;
}

Result<DeviceHandle<VkPipelineCache>> makeCache(const VulkanCore& core, std::span<const std::byte> data) {
  VkPipelineCacheCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
  info.initialDataSize = data.size();
  info.pInitialData = data.data();
  return core.make(core.vk().vkCreatePipelineCache, core.vk().vkDestroyPipelineCache, info, "create a pipeline cache");
}

}  // namespace

Result<PipelineCache> PipelineCache::open(const std::shared_ptr<const VulkanCore>& core,
                                          const std::filesystem::path& file) {
  PipelineCache cache;
  if (file.empty()) return cache;
  cache.core_ = core;
  cache.file_ = file;
  cache.key_ = keyOf(*core);
  const auto data = readPipelineCache(file, cache.key_);
  auto made = makeCache(*core, data ? std::span<const std::byte>(*data) : std::span<const std::byte>());
  if (made && data) {
    cache.fromFile_ = true;
    cache.inFile_ = contentHash(*data);
  }
  // The driver doesn't take its own data back: start without.
  if (!made && data) made = makeCache(*core, {});
  if (!made) return tl::unexpected(made.error());
  cache.cache_ = std::move(*made);
  return cache;
}

Result<void> PipelineCache::save() {
  if (!cache_) return {};
  const auto getData = core_->vk().vkGetPipelineCacheData;
  const VkDevice device = core_->device.device;
  std::size_t size = 0;
  VkResult result = getData(device, cache_.get(), &size, nullptr);
  std::vector<std::byte> data(size);
  if (result == VK_SUCCESS) result = getData(device, cache_.get(), &size, data.data());
  if (result != VK_SUCCESS) return vulkanFailure(result, "read the pipeline cache");
  data.resize(size);
  const std::uint64_t hash = contentHash(data);
  if (hash == inFile_) return {};
  const auto written = writePipelineCache(file_, key_, data);
  if (written) inFile_ = hash;
  return written;
}

}  // namespace honeycomb::Osd
