#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "osd/vulkan/descriptor_sets.h"
#include "osd/vulkan/level_timer.h"
#include "osd/vulkan/table.h"

namespace honeycomb::Osd {

/// The caller's buffers for one table. Each needs VK_BUFFER_USAGE_STORAGE_BUFFER_BIT and as many bytes as
/// VulkanTable::bytesOf says; those it doesn't touch may be left out. No two may overlap.
struct VulkanTargets {
  VulkanRange control{};
  VulkanRange refined{};
  VulkanRange vertexPositions{}, vertexNormals{};
  VulkanRange facePositions{}, faceNormals{};
};

class VulkanBinding;

/// How a binding works.
struct VulkanBindingOptions {
  bool timing = false;  ///< take the time of each level; see VulkanBinding::levelTimes. Off, it costs nothing
  /// Share the scratch memory of another binding of the same table; both are recorded for one queue, where the barrier
  /// that a recording begins with keeps them apart. Null: scratch of its own.
  const VulkanBinding* scratchOf = nullptr;
};

/// What a level, or the limits of the last one, took in a frame.
struct LevelTime {
  std::int32_t level = 0;  ///< counted from VulkanTableOptions::firstLevel; the levels of tiles are one part, under the
                           ///< first of them
  bool limits = false;     ///< the limits of that level, beside the level itself
  double milliseconds = 0;
};

/// A table bound to buffers: its descriptor sets and scratch memory, so that recording allocates nothing. May be
/// recorded any number of times, in command buffers that run one after the other; for frames in flight make one for
/// each. Must outlive the execution of what was recorded with it.
class VulkanBinding {
 public:
  /// Errors: invalidOption for a missing, misaligned or short buffer, or scratch of another table; outOfMemory;
  /// unsupported when timing is wanted of a queue without timestamps.
  static Result<VulkanBinding> create(const std::shared_ptr<const VulkanCore>& core,
                                      const std::shared_ptr<VulkanPipelines>& pipelines, const VulkanTable& table,
                                      const VulkanTargets& targets, const VulkanBindingOptions& options = {});

  /// Records the dispatches: see VulkanEvaluator::record().
  void record(VkCommandBuffer commands) const;
  /// Looks for changed kernels, where VulkanEvaluatorOptions::kernelFolder names some. Another number than before: what
  /// was recorded has old kernels, record() takes the new. Errors: invalidFile.
  Result<std::uint64_t> refreshKernels() const;
  /// What each level took on the device in the last frame recorded with this binding, which must have run. Errors:
  /// invalidOption without VulkanBindingOptions::timing, or before the first frame; deviceLost, outOfMemory.
  Result<std::vector<LevelTime>> levelTimes() const;
  /// Bytes of device memory for levels in between.
  std::uint64_t scratchBytes() const;
  /// Do both have the same scratch memory?
  bool sharesScratch(const VulkanBinding& other) const { return scratch_ == other.scratch_; }

 private:
  struct Command {
    VkPipeline pipeline = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE;
    PushConstants push;
    std::uint32_t groups = 1, groupRows = 1;
    bool dealt = false;  ///< workgroups ask for tiles
  };

  Result<void> resolve(const VulkanTargets& targets);
  Result<void> makeScratch(const VulkanBinding* shared);
  Result<void> viewScratch();
  Result<void> makeSets();
  void dealAnew(VkCommandBuffer commands) const;
  void writeSet(VkDescriptorSet set, const TableStage& stage, const BoundRanges& ranges) const;
  void writeTexels(VkDescriptorSet set, std::uint32_t slot, VkDescriptorType type, VkBufferView view) const;
  VkDescriptorBufferInfo bufferOf(const TableStage& stage, const BoundRange& range) const;
  VkDescriptorBufferInfo pageOf(const TableStage& stage, std::uint32_t page) const;
  Result<void> makeTimer();
  Result<std::vector<LevelTime>> timesOfParts() const;
  void barrier(VkCommandBuffer commands) const;

  std::shared_ptr<const VulkanCore> core_;
  std::shared_ptr<VulkanPipelines> pipelines_;
  VulkanTable table_;
  std::shared_ptr<const std::array<VulkanBuffer, kScratchBuffers>> scratch_;
  std::array<VulkanRange, kCallerBuffers + kScratchBuffers> ranges_{};
  DeviceHandle<VkBufferView> scratchTexels_;
  DescriptorSets sets_;
  std::vector<std::vector<Command>> phases_;
  std::vector<std::size_t> timedEnds_;  ///< phases up to the end of each part that is timed
  std::optional<LevelTimer> timer_;
};

}  // namespace honeycomb::Osd
