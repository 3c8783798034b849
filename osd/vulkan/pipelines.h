#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "far/base/result.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/handles.h"
#include "osd/vulkan/kernel_files.h"
#include "osd/vulkan/kernels.h"
#include "osd/vulkan/pipeline_cache.h"

namespace honeycomb::Osd {

/// The SPIR-V of a kernel.
std::span<const std::uint32_t> kernelCode(Kernel kernel);

/// The compute pipelines of one evaluator, made when a table first needs them and kept. One descriptor set layout and
/// one pipeline layout serve all kernels. Safe from several threads.
class VulkanPipelines {
 public:
  /// Errors: outOfMemory, deviceLost; invalidFile for a folder of kernels that lacks some.
  static Result<std::unique_ptr<VulkanPipelines>> create(std::shared_ptr<const VulkanCore> core);

  VkDescriptorSetLayout setLayout() const { return setLayout_.get(); }
  VkPipelineLayout layout() const { return layout_.get(); }
  /// Compiles it where it is new; the other functions don't wait for that. Errors: outOfMemory, deviceLost.
  Result<VkPipeline> get(Kernel kernel, const Specialization& specialization);

  /// Compiles the kernels of VulkanEvaluatorOptions::kernelFolder that changed; every change gives another number. What
  /// was recorded with their pipelines stays valid, and is to be recorded again. Errors: invalidFile, unsupported.
  Result<std::uint64_t> refresh();
  /// The pipeline that does now what `first`, from get(), did when it was made.
  VkPipeline current(VkPipeline first);

  /// Pipelines so far.
  std::size_t count() const;

  const PipelineCache& cache() const { return cache_; }
  /// Writes the cache's file if a pipeline was compiled since the last time. Errors: unwritable, outOfMemory.
  Result<void> save();

 private:
  explicit VulkanPipelines(std::shared_ptr<const VulkanCore> core) : core_(std::move(core)) {}
  Result<void> makeSetLayout();
  Result<void> makeLayout();
  std::span<const std::uint32_t> code(Kernel kernel) const;
  Result<DeviceHandle<VkShaderModule>> makeModule(std::span<const std::uint32_t> code) const;
  Result<void> remake(Kernel kernel);
  Result<DeviceHandle<VkPipeline>> make(std::span<const std::uint32_t> code,
                                        const Specialization& specialization) const;

  std::shared_ptr<const VulkanCore> core_;
  DeviceHandle<VkDescriptorSetLayout> setLayout_;
  DeviceHandle<VkPipelineLayout> layout_;
  PipelineCache cache_;
  mutable std::mutex mutex_;
  std::map<std::pair<Kernel, Specialization>, DeviceHandle<VkPipeline>> pipelines_;
  KernelFiles files_;
  std::array<std::vector<std::uint32_t>, kKernelCount> loaded_;  ///< SPIR-V from files; empty: the built-in one
  std::uint64_t generation_ = 0;
  std::map<VkPipeline, DeviceHandle<VkPipeline>> replaced_;  ///< by pipelines of changed kernels
  std::vector<DeviceHandle<VkPipeline>> outdated_;           ///< such as have been replaced in turn
  std::size_t saved_ = 0;                                    ///< pipelines there were when the cache was written
};

}  // namespace honeycomb::Osd
