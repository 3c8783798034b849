#pragma once

#include <cstdint>
#include <memory>

#include "far/base/result.h"
#include "osd/vulkan/core.h"
#include "osd/vulkan/handles.h"

namespace honeycomb::Osd {

/// A timeline semaphore that counts submissions: it reaches n when the n-th has run. Waits for all of them when it is
/// destroyed. The device must have the feature timelineSemaphore switched on.
class Timeline {
 public:
  /// Errors: outOfMemory.
  static Result<Timeline> create(const std::shared_ptr<const VulkanCore>& core);
  Timeline() = default;
  ~Timeline();
  Timeline(Timeline&&) = default;
  Timeline& operator=(Timeline&&) = default;

  VkSemaphore semaphore() const { return semaphore_.get(); }
  /// Submissions so far.
  std::uint64_t count() const { return count_; }
  /// Says that one was submitted that signals count() + 1.
  void advance() { ++count_; }

  /// Returns when the submission has run, at once for those before the first. Errors: deviceLost.
  Result<void> wait(std::uint64_t submission) const;
  /// Has it run? Errors: deviceLost.
  Result<bool> reached(std::uint64_t submission) const;

 private:
  std::shared_ptr<const VulkanCore> core_;
  DeviceHandle<VkSemaphore> semaphore_;
  std::uint64_t count_ = 0;
};

}  // namespace honeycomb::Osd
