#include "io/frame_checks.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

namespace honeycomb::Io {
namespace {

// The position of the first NaN or infinity, -1 if there is none. The first pass has no branch, so that it vectorises.
std::ptrdiff_t findNotFinite(std::span<const float> values) {
  constexpr std::uint32_t kExponent = 0x7F800000U;
  std::uint32_t found = 0;
  for (const float value : values) {
    found |= static_cast<std::uint32_t>((std::bit_cast<std::uint32_t>(value) & kExponent) == kExponent);
  }
  if (found == 0) return -1;
  std::ptrdiff_t i = 0;
  while (std::isfinite(values[static_cast<std::size_t>(i)])) ++i;
  return i;
}

}  // namespace

Result<void> checkFrame(std::string_view name, std::int32_t f, const FrameInfo& info) {
  if (f >= 0 && f < info.frameCount) return {};
  return fail(ErrorCode::invalidOption,
              fmt::format("{}: has no frame {}; name one of 0 to {}", name, f, info.frameCount - 1));
}

// Divides rather than multiplies: points x frames of a hostile header pass 64 bits.
Result<void> checkWhole(std::string_view name, const FrameInfo& info, std::size_t bytes) {
  const std::size_t whole = bytes / (3 * sizeof(float) * static_cast<std::size_t>(info.pointCount));
  if (whole >= static_cast<std::size_t>(info.frameCount)) return {};
  return fail(ErrorCode::invalidFile,
              fmt::format("{}: is cut off within frame {} (counted from 0) of {} frames of {} points; export the cache "
                          "again or copy it whole",
                          name, whole, info.frameCount, info.pointCount),
              static_cast<std::int64_t>(whole));
}

Result<void> checkFinite(std::string_view name, std::int64_t frame, std::span<const float> points) {
  const std::ptrdiff_t wrong = findNotFinite(points);
  if (wrong < 0) return {};
  return fail(
      ErrorCode::invalidPositions,
      fmt::format("{}: vertex {} of frame {} (both counted from 0) has the coordinate {}; give it a finite position",
                  name, wrong / 3, frame, points[static_cast<std::size_t>(wrong)]),
      wrong / 3);
}

}  // namespace honeycomb::Io
