#include "osd/vulkan/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "osd/vulkan/guard.h"

namespace honeycomb::Osd {

Result<VulkanSession> VulkanSession::create(VulkanEvaluator& evaluator, const Far::Refinement& refinement,
                                            const VulkanTableOptions& options) {
  auto table = evaluator.upload(refinement, options);
  if (!table) return tl::unexpected(table.error());
  return create(std::as_const(evaluator), std::move(*table));
}

Result<VulkanSession> VulkanSession::create(const VulkanEvaluator& evaluator, VulkanTable table) {
  return guarded([&]() -> Result<VulkanSession> {
    VulkanSession session;
    session.core_ = evaluator.core();
    session.table_ = std::move(table);
    auto commands = CommandRunner::create(session.core_);
    if (!commands) return tl::unexpected(commands.error());
    session.commands_ = std::move(*commands);
    if (const auto made = session.makeBuffers(); !made) return tl::unexpected(made.error());
    const VulkanTargets targets{.control = session.range(PointBuffer::control),
                                .refined = session.range(PointBuffer::refined),
                                .vertexPositions = session.range(PointBuffer::vertexPositions),
                                .vertexNormals = session.range(PointBuffer::vertexNormals),
                                .facePositions = session.range(PointBuffer::facePositions),
                                .faceNormals = session.range(PointBuffer::faceNormals)};
    auto binding = evaluator.bind(session.table_, targets);
    if (!binding) return tl::unexpected(binding.error());
    session.binding_ = std::make_unique<VulkanBinding>(std::move(*binding));
    if (const auto recorded = session.record(); !recorded) return tl::unexpected(recorded.error());
    return session;
  });
}

Result<void> VulkanSession::makeBuffers() {
  constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT;
  for (std::size_t i = 0; i < kCallerBuffers; ++i) {
    const std::uint64_t bytes = table_.bytesOf(static_cast<PointBuffer>(i));
    if (bytes == 0) continue;
    const MemoryUse use = static_cast<PointBuffer>(i) == PointBuffer::control ? MemoryUse::upload : MemoryUse::readback;
    auto buffer = SharedBuffer::create(core_, bytes, kUsage, use);
    if (!buffer) return tl::unexpected(buffer.error());
    std::ranges::fill(buffer->bytes(), std::byte{0});
    buffers_[i] = std::move(*buffer);
  }
  return clearStaged();
}

// What lies between the described values is never written: let it be zero, on the device as well.
Result<void> VulkanSession::clearStaged() {
  if (auto begun = commands_.begin(VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT); !begun) return begun;
  for (const SharedBuffer& one : buffers_) {
    if (!one.staged()) continue;
    core_->vk().vkCmdFillBuffer(commands_.commandBuffer(), one.range().buffer, 0, VK_WHOLE_SIZE, 0);
  }
  if (auto ended = commands_.end(); !ended) return ended;
  if (auto sent = commands_.submit(); !sent) return sent;
  return commands_.wait();
}

Result<void> VulkanSession::record() {
  if (auto begun = commands_.begin(0); !begun) return begun;
  recordInput();
  binding_->record(commands_.commandBuffer());
  recordOutput();
  return commands_.end();
}

namespace {

void memoryBarrier(const VulkanCore& core, VkCommandBuffer commands, VkPipelineStageFlags before, VkAccessFlags written,
                   VkPipelineStageFlags after, VkAccessFlags wanted) {
  VkMemoryBarrier barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  barrier.srcAccessMask = written;
  barrier.dstAccessMask = wanted;
  core.vk().vkCmdPipelineBarrier(commands, before, after, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

void copyWhole(const VulkanCore& core, VkCommandBuffer commands, const VulkanRange& from, const VulkanRange& to) {
  const VkBufferCopy region{from.offset, to.offset, from.size};
  core.vk().vkCmdCopyBuffer(commands, from.buffer, to.buffer, 1, &region);
}

}  // namespace

// What the host wrote is visible at submission.
void VulkanSession::recordInput() const {
  const SharedBuffer& control = buffer(PointBuffer::control);
  if (!control.staged()) return;
  copyWhole(*core_, commands_.commandBuffer(), control.hostRange(), control.range());
  memoryBarrier(*core_, commands_.commandBuffer(), VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT,
                VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT);
}

void VulkanSession::recordOutput() const {
  const VkCommandBuffer commands = commands_.commandBuffer();
  bool staged = false;
  for (std::size_t i = 1; i < kCallerBuffers; ++i) staged = staged || buffers_[i].staged();
  if (staged) {
    memoryBarrier(*core_, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
                  VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT);
    for (std::size_t i = 1; i < kCallerBuffers; ++i) {
      if (buffers_[i].staged()) copyWhole(*core_, commands, buffers_[i].range(), buffers_[i].hostRange());
    }
  }
  memoryBarrier(*core_, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
                VK_PIPELINE_STAGE_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_HOST_BIT,
                VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_HOST_READ_BIT);
}

Result<void> VulkanSession::run() {
  if (auto sent = commands_.submit(); !sent) return sent;
  return commands_.wait();
}

Result<void> VulkanSession::refine(std::span<const float> points, std::span<float> refined) {
  if (points.size() != control().size() || refined.size() != this->refined().size()) {
    return fail(ErrorCode::invalidOption,
                fmt::format("{} numbers in and {} out: the table reads {} and writes {}", points.size(), refined.size(),
                            control().size(), this->refined().size()));
  }
  std::ranges::copy(points, control().begin());
  if (auto ran = run(); !ran) return ran;
  std::ranges::copy(this->refined(), refined.begin());
  return {};
}

}  // namespace honeycomb::Osd
