#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "far/base/result.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/handles.h"

namespace honeycomb::Osd {

/// Timestamps between the parts of a recording: one when it starts, one when each part has run.
class LevelTimer {
 public:
  /// Errors: unsupported when the queue family has no timestamps; outOfMemory.
  static Result<LevelTimer> create(const std::shared_ptr<const VulkanCore>& core, std::uint32_t parts);

  /// Recorded before the first part.
  void start(VkCommandBuffer commands) const;
  /// Recorded behind part 0, 1, ..
  void finish(VkCommandBuffer commands, std::uint32_t part) const;

  /// Milliseconds of each part in the recording's last run, which has finished. Errors: invalidOption when it never
  /// ran, deviceLost.
  Result<std::vector<double>> milliseconds() const;

 private:
  void stamp(VkCommandBuffer commands, std::uint32_t query) const;

  std::shared_ptr<const VulkanCore> core_;
  DeviceHandle<VkQueryPool> pool_;
  std::uint32_t parts_ = 0;
  double millisecondsPerTick_ = 0;
  std::uint64_t validTicks_ = 0;  ///< the bits of a timestamp that count
};

}  // namespace honeycomb::Osd
