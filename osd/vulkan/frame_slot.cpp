#include "osd/vulkan/frame_slot.h"

#include <algorithm>
#include <utility>

namespace honeycomb::Osd {

Result<FrameSlot> FrameSlot::create(const VulkanEvaluator& evaluator, const VulkanTable& table,
                                    const FrameSlotOptions& options, const FrameSlot* scratchOf) {
  FrameSlot slot;
  slot.core_ = evaluator.core();
  slot.table_ = table;
  slot.options_ = options;
  auto commands = CommandRunner::create(slot.core_);
  if (!commands) return tl::unexpected(commands.error());
  slot.commands_ = std::move(*commands);
  if (const auto made = slot.makeBuffers(); !made) return tl::unexpected(made.error());
  const VulkanBindingOptions wanted{options.timing, scratchOf == nullptr ? nullptr : scratchOf->binding_.get()};
  auto binding = evaluator.bind(slot.table_, slot.targets(), wanted);
  if (!binding) return tl::unexpected(binding.error());
  slot.binding_ = std::make_unique<VulkanBinding>(std::move(*binding));
  const auto kernels = slot.binding_->refreshKernels();
  if (!kernels) return tl::unexpected(kernels.error());
  slot.kernels_ = *kernels;
  if (const auto recorded = slot.record(); !recorded) return tl::unexpected(recorded.error());
  return slot;
}

Result<void> FrameSlot::refresh() {
  const auto kernels = binding_->refreshKernels();
  if (!kernels) return tl::unexpected(kernels.error());
  if (*kernels == kernels_) return {};
  if (auto recorded = record(); !recorded) return recorded;
  kernels_ = *kernels;
  return {};
}

VulkanTargets FrameSlot::targets() const {
  return {.control = range(PointBuffer::control),
          .refined = range(PointBuffer::refined),
          .vertexPositions = range(PointBuffer::vertexPositions),
          .vertexNormals = range(PointBuffer::vertexNormals),
          .facePositions = range(PointBuffer::facePositions),
          .faceNormals = range(PointBuffer::faceNormals)};
}

std::span<float> FrameSlot::numbers(PointBuffer points) const {
  const std::span<float> all = buffer(points).numbers();
  return all.first(std::min<std::size_t>(all.size(), table_.bytesOf(points) / sizeof(float)));
}

Result<void> FrameSlot::makeBuffers() {
  constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT;
  const MemoryUse results = options_.readback ? MemoryUse::readback : MemoryUse::device;
  for (std::size_t i = 0; i < kCallerBuffers; ++i) {
    const std::uint64_t bytes = table_.bytesOf(static_cast<PointBuffer>(i));
    if (bytes == 0) continue;
    const MemoryUse use = static_cast<PointBuffer>(i) == PointBuffer::control ? MemoryUse::upload : results;
    auto made = SharedBuffer::create(core_, bytes, kUsage, use);
    if (!made) return tl::unexpected(made.error());
    std::ranges::fill(made->bytes(), std::byte{0});
    buffers_[i] = std::move(*made);
  }
  return clearUnmapped();
}

// What lies between the described values is never written: let it be zero, on the device as well.
Result<void> FrameSlot::clearUnmapped() {
  const auto unmapped = [](const SharedBuffer& one) { return !one.mapped() && one.range().buffer != VK_NULL_HANDLE; };
  if (std::ranges::none_of(buffers_, unmapped)) return {};
  if (auto begun = commands_.begin(VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT); !begun) return begun;
  for (const SharedBuffer& one : buffers_) {
    if (!unmapped(one)) continue;
    core_->vk().vkCmdFillBuffer(commands_.commandBuffer(), one.range().buffer, 0, VK_WHOLE_SIZE, 0);
  }
  if (auto ended = commands_.end(); !ended) return ended;
  if (auto sent = commands_.submit(); !sent) return sent;
  return commands_.wait();
}

Result<void> FrameSlot::record() {
  if (auto begun = commands_.begin(0); !begun) return begun;
  recordInput();
  binding_->record(commands_.commandBuffer());
  recordOutput();
  return commands_.end();
}

namespace {

void copyWhole(const VulkanCore& core, VkCommandBuffer commands, const VulkanRange& from, const VulkanRange& to) {
  const VkBufferCopy region{from.offset, to.offset, from.size};
  core.vk().vkCmdCopyBuffer(commands, from.buffer, to.buffer, 1, &region);
}

constexpr MemoryAccess kCopied{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT};
constexpr MemoryAccess kComputed{VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT};

}  // namespace

// What the host wrote is visible at submission. Without readers the copy waits for nothing: it runs while the frame
// before is computed.
void FrameSlot::recordInput() const {
  const VkCommandBuffer commands = commands_.commandBuffer();
  if (options_.readers != 0) {
    memoryBarrier(*core_, commands, {options_.readers, 0},
                  {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT, 0});
  }
  const SharedBuffer& control = buffer(PointBuffer::control);
  if (control.staged()) {
    copyWhole(*core_, commands, control.hostRange(), control.range());
    memoryBarrier(*core_, commands, kCopied, {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT});
  }
}

void FrameSlot::recordOutput() const {
  const VkCommandBuffer commands = commands_.commandBuffer();
  const auto results = std::span(buffers_).subspan(1);
  if (std::ranges::any_of(results, &SharedBuffer::staged)) {
    memoryBarrier(*core_, commands, kComputed, {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT});
    for (const SharedBuffer& one : results)
      if (one.staged()) copyWhole(*core_, commands, one.range(), one.hostRange());
  }
  MemoryAccess after;
  if (options_.readback) after = {VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT};
  if (options_.readers != 0) {
    after.stages |= options_.readers;
    after.access |= VK_ACCESS_MEMORY_READ_BIT;
  }
  if (after.stages == 0) return;
  memoryBarrier(*core_, commands, {kComputed.stages | kCopied.stages, kComputed.access | kCopied.access}, after);
}

}  // namespace honeycomb::Osd
