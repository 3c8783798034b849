#include "apps/viewer/poses.h"

#include <fmt/format.h>

#include "far/base/stopwatch.h"

namespace honeycomb::Viewer {
namespace {

PointSource sourceOf(const Osd::FrameSlot& slot, Osd::PointBuffer points) {
  const Osd::VulkanRange range = slot.range(points);
  return {range.buffer, static_cast<std::int64_t>(range.offset / sizeof(float)), 3};
}

/// One is drawn while the next is refined.
Result<Osd::VulkanFrames> twoFrames(const Osd::VulkanEvaluator& evaluator, const Osd::VulkanTable& table, bool timing) {
  return Osd::VulkanFrames::create(
      evaluator, table,
      {.framesInFlight = 2, .frame = {.timing = timing, .readers = VK_PIPELINE_STAGE_VERTEX_SHADER_BIT}});
}

}  // namespace

Result<DevicePoses> DevicePoses::create(Osd::VulkanEvaluator evaluator, const Far::Refinement& refinement,
                                        const DevicePosesOptions& options) {
  Osd::VulkanTableOptions wanted;
  if (options.normals) wanted.vertexLimits.normals = Osd::BufferDescriptor{};
  const auto table = evaluator.upload(refinement, wanted);
  if (!table) return tl::unexpected(table.error());
  bool timing = options.timing;
  auto frames = twoFrames(evaluator, *table, timing);
  if (!frames && timing && frames.error().code == ErrorCode::unsupported)
    frames = twoFrames(evaluator, *table, timing = false);
  if (!frames) return tl::unexpected(frames.error());
  return DevicePoses(std::move(*frames), 3 * static_cast<std::size_t>(table->controlCount()), options.normals, timing);
}

Result<void> DevicePoses::send(std::span<const float> control) {
  if (control.size() != controlNumbers_) {
    return fail(ErrorCode::invalidOption, fmt::format("a frame of {} numbers was given to a mesh of {} control points",
                                                      control.size(), controlNumbers_ / 3));
  }
  const auto ticket = frames_.submit(control);
  if (!ticket) return tl::unexpected(ticket.error());
  posed_ = *ticket;
  return {};
}

Result<PoseTimes> DevicePoses::pose(std::span<const float> control) {
  const Stopwatch watch;
  if (const auto sent = send(control); !sent) return tl::unexpected(sent.error());
  if (const auto done = frames_.wait(posed_); !done) return tl::unexpected(done.error());
  PoseTimes times{watch.milliseconds(), 0};
  if (timing_) {
    const auto slot = frames_.results(posed_);
    auto levels = slot ? (*slot)->binding().levelTimes() : tl::unexpected(slot.error());
    if (!levels) return tl::unexpected(levels.error());
    times.levels = std::move(*levels);
  }
  return times;
}

std::span<const float> DevicePoses::refined() const {
  const auto slot = frames_.results(posed_);
  if (!slot || !frames_.wait(posed_)) return {};
  return (*slot)->numbers(Osd::PointBuffer::refined);
}

Result<PosedPoints> DevicePoses::points() const {
  const auto slot = frames_.results(posed_);
  if (!slot) return tl::unexpected(slot.error());
  const PointSource refined = sourceOf(**slot, Osd::PointBuffer::refined);
  return PosedPoints{sourceOf(**slot, Osd::PointBuffer::control), refined,
                     normals_ ? sourceOf(**slot, Osd::PointBuffer::vertexNormals) : refined};
}

}  // namespace honeycomb::Viewer
