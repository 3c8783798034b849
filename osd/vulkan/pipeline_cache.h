#pragma once

#include <filesystem>
#include <memory>

#include "far/base/result.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/handles.h"
#include "osd/vulkan/pipeline_cache_file.h"

namespace honeycomb::Osd {

/// What the driver compiled, kept in a file from one run of a program to the next. A file that is missing, damaged or
/// made by another driver, device or version is as good as none, and overwritten.
class PipelineCache {
 public:
  /// A cache without a file: pipelines are compiled each time.
  PipelineCache() = default;
  /// Starts from the file where it is good. Errors: outOfMemory.
  static Result<PipelineCache> open(const std::shared_ptr<const VulkanCore>& core, const std::filesystem::path& file);

  /// For vkCreateComputePipelines; null without a file.
  VkPipelineCache handle() const { return cache_.get(); }
  bool startedFromFile() const { return fromFile_; }
  /// Writes the file anew unless it has the same data. Errors: unwritable, outOfMemory.
  Result<void> save();

 private:
  std::shared_ptr<const VulkanCore> core_;
  std::filesystem::path file_;
  PipelineCacheKey key_;
  DeviceHandle<VkPipelineCache> cache_;
  bool fromFile_ = false;
  std::uint64_t inFile_ = 0;  ///< contentHash of the data in the file; 0: none
};

}  // namespace honeycomb::Osd
