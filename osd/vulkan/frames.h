#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "osd/vulkan/frame_slot.h"
#include "osd/vulkan/timeline.h"

namespace honeycomb::Osd {

/// How many frames there are, and of what.
struct VulkanFramesOptions {
  std::uint32_t framesInFlight = 3;  ///< 1 to kMostFramesInFlight; each has buffers of its own, scratch is shared
  FrameSlotOptions frame{};
};
constexpr std::uint32_t kMostFramesInFlight = 16;

/// A semaphore of the caller and, where it is a timeline semaphore, its value.
struct VulkanSemaphoreValue {
  VkSemaphore semaphore = VK_NULL_HANDLE;
  std::uint64_t value = 0;
};

/// What a frame waits for on the device before it computes (its upload doesn't wait), such as the drawing that read the
/// results framesInFlight frames before, and what else it signals at its end. At most kMostSemaphores each.
struct VulkanFrameSync {
  std::span<const VulkanSemaphoreValue> waits{};
  std::span<const VulkanSemaphoreValue> signals{};
};
constexpr std::size_t kMostSemaphores = 8;

/// A submitted frame: `semaphore` is a timeline semaphore that reaches `value` when the results are there. Wait for it
/// on the device (an engine's next submission) or on the host (VulkanFrames::wait).
struct VulkanTicket {
  VkSemaphore semaphore = VK_NULL_HANDLE;
  std::uint64_t value = 0;
};

/// Several frames on their way: while the device computes one, the host writes the next and reads the one before, and
/// where memory isn't shared the next is copied to the device. A frame is one vkQueueSubmit of commands recorded at
/// creation: nothing is allocated, updated or waited for but the buffers of the frame framesInFlight before.
///
///     slot 0   write 0 | compute 0 | read 0 | write 3 ...
///     slot 1             write 1   | compute 1 | read 1 | ...
///     slot 2                         write 2   | compute 2 | ...
///
/// The bits are those of one frame after another. Uses the device's queue, which nobody else may use during create()
/// and submit() unless there is a VulkanDevice::queueLock. Belongs to one thread at a time. Waits for its frames when
/// it is destroyed.
class VulkanFrames {
 public:
  /// Errors: unsupported without the feature timelineSemaphore (VulkanDevice::timelineSemaphore); invalidOption for the
  /// number of frames; as of VulkanEvaluator::bind; deviceLost.
  static Result<VulkanFrames> create(const VulkanEvaluator& evaluator, const VulkanTable& table,
                                     const VulkanFramesOptions& options = {});
  VulkanFrames(VulkanFrames&&) = default;
  VulkanFrames& operator=(VulkanFrames&& other) noexcept;

  /// Where the control points of the next frame go, laid out by the table's options.control; they hold what the frame
  /// framesInFlight before had. Waits until that frame is done; its results are gone with submit().
  /// Results that others read on the device must have been read, or sync.waits must say when. Errors: deviceLost.
  Result<std::span<float>> begin();
  /// Sends the frame off; needs begin() before. Errors: invalidOption, deviceLost, outOfMemory; after an error the
  /// frame may be submitted again.
  Result<VulkanTicket> submit(const VulkanFrameSync& sync = {});
  /// begin(), a copy of the points, submit(). Errors: also invalidOption for another number of numbers than begin()'s.
  Result<VulkanTicket> submit(std::span<const float> control, const VulkanFrameSync& sync = {});

  /// Returns when the frame's results are there. Errors: deviceLost; invalidOption for a ticket of other frames.
  Result<void> wait(const VulkanTicket& ticket) const;
  /// Are they there? Errors: deviceLost; invalidOption for a ticket of other frames.
  Result<bool> finished(const VulkanTicket& ticket) const;
  /// The buffers of one of the last framesInFlight frames. The host may read FrameSlot::numbers once wait() has
  /// returned, until the begin() framesInFlight frames later; the device what its semaphore says. Errors: invalidOption
  /// for a ticket whose results are overwritten, or one of other frames.
  Result<const FrameSlot*> results(const VulkanTicket& ticket) const;

  std::uint32_t framesInFlight() const { return static_cast<std::uint32_t>(slots_.size()); }

 private:
  VulkanFrames() = default;
  Result<void> checkOwn(const VulkanTicket& ticket) const;
  Result<std::span<float>> nextBuffer();
  Result<VulkanTicket> sendBegun(const VulkanFrameSync& sync);
  Result<const FrameSlot*> slotOf(const VulkanTicket& ticket) const;
  FrameSlot& nextSlot() { return slots_[timeline_.count() % slots_.size()]; }
  Result<void> send(const VulkanFrameSync& sync);

  std::shared_ptr<const VulkanCore> core_;
  std::vector<FrameSlot> slots_;
  bool begun_ = false;
  Timeline timeline_;  // waits: destroyed before what it waits for
};

}  // namespace honeycomb::Osd
