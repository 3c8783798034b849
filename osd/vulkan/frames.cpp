#include "osd/vulkan/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "osd/vulkan/errors.h"
#include "osd/vulkan/guard.h"

namespace honeycomb::Osd {

namespace {

Result<void> checkFrames(const VulkanCore& core, const VulkanFramesOptions& options) {
  if (!core.device.timelineSemaphore) {
    return fail(
        ErrorCode::unsupported,
        "frames in flight need the feature timelineSemaphore: switch it on with the Vulkan device and say so in "
        "VulkanDevice::timelineSemaphore, or use a VulkanSession");
  }
  if (options.framesInFlight < 1 || options.framesInFlight > kMostFramesInFlight) {
    return fail(ErrorCode::invalidOption,
                fmt::format("{} frames in flight: give 1 to {}", options.framesInFlight, kMostFramesInFlight));
  }
  return {};
}

}  // namespace

Result<VulkanFrames> VulkanFrames::create(const VulkanEvaluator& evaluator, const VulkanTable& table,
                                          const VulkanFramesOptions& options) {
  return guarded([&]() -> Result<VulkanFrames> {
    VulkanFrames frames;
    frames.core_ = evaluator.core();
    if (const auto sound = checkFrames(*frames.core_, options); !sound) return tl::unexpected(sound.error());
    frames.slots_.reserve(options.framesInFlight);
    for (std::uint32_t i = 0; i < options.framesInFlight; ++i) {
      auto slot = FrameSlot::create(evaluator, table, options.frame, i == 0 ? nullptr : &frames.slots_.front());
      if (!slot) return tl::unexpected(slot.error());
      frames.slots_.push_back(std::move(*slot));
    }
    auto timeline = Timeline::create(frames.core_);
    if (!timeline) return tl::unexpected(timeline.error());
    frames.timeline_ = std::move(*timeline);
    return frames;
  });
}

VulkanFrames& VulkanFrames::operator=(VulkanFrames&& other) noexcept {
  std::swap(core_, other.core_);
  std::swap(slots_, other.slots_);
  std::swap(begun_, other.begun_);
  std::swap(timeline_, other.timeline_);
  return *this;
}

Result<std::span<float>> VulkanFrames::begin() {
  return guarded([this] { return nextBuffer(); });
}

Result<std::span<float>> VulkanFrames::nextBuffer() {
  const std::uint64_t next = timeline_.count() + 1;
  if (next > slots_.size()) {
    if (const auto done = timeline_.wait(next - slots_.size()); !done) return tl::unexpected(done.error());
  }
  if (const auto fresh = nextSlot().refresh(); !fresh) return tl::unexpected(fresh.error());
  begun_ = true;
  return nextSlot().numbers(PointBuffer::control);
}

namespace {

/// Semaphores and values side by side, as Vulkan wants them.
struct SemaphoreArrays {
  std::array<VkSemaphore, kMostSemaphores + 1> semaphores{};
  std::array<std::uint64_t, kMostSemaphores + 1> values{};
  std::uint32_t count = 0;

  void add(const VulkanSemaphoreValue& one) {
    semaphores[count] = one.semaphore;
    values[count] = one.value;
    ++count;
  }
  explicit SemaphoreArrays(std::span<const VulkanSemaphoreValue> all) {
    for (const VulkanSemaphoreValue& one : all) add(one);
  }
};

}  // namespace

Result<void> VulkanFrames::send(const VulkanFrameSync& sync) {
  const SemaphoreArrays waits(sync.waits);
  SemaphoreArrays signals(sync.signals);
  signals.add({timeline_.semaphore(), timeline_.count() + 1});
  std::array<VkPipelineStageFlags, kMostSemaphores + 1> stages{};
  stages.fill(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT);
  const VkCommandBuffer commands = nextSlot().commands().commandBuffer();

  VkTimelineSemaphoreSubmitInfo values{};
  values.sType = VK_STRUCTURE_TYPE_TIMELINE_SEMAPHORE_SUBMIT_INFO;
  values.waitSemaphoreValueCount = waits.count;
  values.pWaitSemaphoreValues = waits.values.data();
  values.signalSemaphoreValueCount = signals.count;
  values.pSignalSemaphoreValues = signals.values.data();
  VkSubmitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  info.pNext = &values;
  info.waitSemaphoreCount = waits.count;
  info.pWaitSemaphores = waits.semaphores.data();
  info.pWaitDstStageMask = stages.data();
  info.commandBufferCount = 1;
  info.pCommandBuffers = &commands;
  info.signalSemaphoreCount = signals.count;
  info.pSignalSemaphores = signals.semaphores.data();
  const VkResult result = submitTo(*core_, info, VK_NULL_HANDLE);
  if (result != VK_SUCCESS) return vulkanFailure(result, "submit a frame");
  return {};
}

Result<VulkanTicket> VulkanFrames::submit(const VulkanFrameSync& sync) {
  return guarded([&] { return sendBegun(sync); });
}

Result<VulkanTicket> VulkanFrames::sendBegun(const VulkanFrameSync& sync) {
  if (!begun_) return fail(ErrorCode::invalidOption, "a frame is submitted that wasn't begun: call begin() first");
  const std::size_t most = std::max(sync.waits.size(), sync.signals.size());
  if (most > kMostSemaphores) {
    return fail(ErrorCode::invalidOption, fmt::format("a frame waits for or signals {} semaphores, {} is the most: "
                                                      "gather them in one submission of your own",
                                                      most, kMostSemaphores));
  }
  if (const auto sent = send(sync); !sent) return tl::unexpected(sent.error());
  begun_ = false;
  timeline_.advance();
  return VulkanTicket{timeline_.semaphore(), timeline_.count()};
}

Result<VulkanTicket> VulkanFrames::submit(std::span<const float> control, const VulkanFrameSync& sync) {
  return guarded([&]() -> Result<VulkanTicket> {
    const auto target = nextBuffer();
    if (!target) return tl::unexpected(target.error());
    if (target->size() != control.size()) {
      return fail(ErrorCode::invalidOption,
                  fmt::format("a frame of {} numbers: the table reads {}", control.size(), target->size()));
    }
    std::ranges::copy(control, target->begin());
    return sendBegun(sync);
  });
}

Result<void> VulkanFrames::checkOwn(const VulkanTicket& ticket) const {
  const bool own = ticket.semaphore == timeline_.semaphore() && ticket.value >= 1 && ticket.value <= timeline_.count();
  if (own) return {};
  return fail(ErrorCode::invalidOption, "a ticket is given for a frame that wasn't submitted here");
}

Result<void> VulkanFrames::wait(const VulkanTicket& ticket) const {
  return guarded([&]() -> Result<void> {
    if (auto own = checkOwn(ticket); !own) return own;
    return timeline_.wait(ticket.value);
  });
}

Result<bool> VulkanFrames::finished(const VulkanTicket& ticket) const {
  return guarded([&]() -> Result<bool> {
    if (const auto own = checkOwn(ticket); !own) return tl::unexpected(own.error());
    return timeline_.reached(ticket.value);
  });
}

Result<const FrameSlot*> VulkanFrames::results(const VulkanTicket& ticket) const {
  return guarded([&] { return slotOf(ticket); });
}

Result<const FrameSlot*> VulkanFrames::slotOf(const VulkanTicket& ticket) const {
  if (const auto own = checkOwn(ticket); !own) return tl::unexpected(own.error());
  const std::uint64_t submitted = timeline_.count();
  if (ticket.value + slots_.size() <= submitted) {
    return fail(ErrorCode::invalidOption,
                fmt::format("the results of frame {} are overwritten: {} frames were submitted, and {} are kept; take "
                            "them earlier or have more frames in flight",
                            ticket.value, submitted, slots_.size()));
  }
  return &slots_[(ticket.value - 1) % slots_.size()];
}

}  // namespace honeycomb::Osd
