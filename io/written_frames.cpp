#include "io/written_frames.h"

#include <fmt/format.h>

#include "io/frame_checks.h"

namespace honeycomb::Io {

Result<void> checkWritten(std::string_view name, const FrameInfo& info, std::int32_t f, std::span<const float> points) {
  if (Result<void> there = checkFrame(name, f, info); !there) return there;
  if (points.size() != 3 * static_cast<std::size_t>(info.pointCount)) {
    return fail(ErrorCode::invalidOption, fmt::format("{}: frame {} has {} coordinates; give 3 for each of {} points",
                                                      name, f, points.size(), info.pointCount));
  }
  return checkFinite(name, f, points);
}

Result<void> checkCounts(std::string_view name, std::string_view kind, const FrameInfo& info) {
  if (info.pointCount >= 1 && info.frameCount >= 1) return {};
  return fail(ErrorCode::invalidOption, fmt::format("{}: {} of {} points and {} frames cannot be; give one or "
                                                    "more of each",
                                                    name, kind, info.pointCount, info.frameCount));
}

}  // namespace honeycomb::Io
