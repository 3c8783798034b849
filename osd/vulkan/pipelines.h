#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

#include "far/base/result.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/handles.h"
#include "osd/vulkan/kernels.h"

namespace honeycomb::Osd {

/// The SPIR-V of a kernel.
std::span<const std::uint32_t> kernelCode(Kernel kernel);

/// The compute pipelines of one evaluator, made when a table first needs them and kept. One descriptor set layout and
/// one pipeline layout serve all kernels. Safe from several threads.
class VulkanPipelines {
 public:
  static Result<std::unique_ptr<VulkanPipelines>> create(std::shared_ptr<const VulkanCore> core);

  VkDescriptorSetLayout setLayout() const { return setLayout_.get(); }
  VkPipelineLayout layout() const { return layout_.get(); }
  Result<VkPipeline> get(Kernel kernel, const Specialization& specialization);

 private:
  explicit VulkanPipelines(std::shared_ptr<const VulkanCore> core) : core_(std::move(core)) {}
  Result<void> makeSetLayout();
  Result<void> makeLayout();
  Result<void> makeModules();
  Result<DeviceHandle<VkPipeline>> make(Kernel kernel, const Specialization& specialization) const;

  std::shared_ptr<const VulkanCore> core_;
  DeviceHandle<VkDescriptorSetLayout> setLayout_;
  DeviceHandle<VkPipelineLayout> layout_;
  std::array<DeviceHandle<VkShaderModule>, kKernelCount> modules_;
  std::mutex mutex_;
  std::map<std::pair<Kernel, Specialization>, DeviceHandle<VkPipeline>> pipelines_;
};

}  // namespace honeycomb::Osd
