#include "apps/cli/frame_range.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

namespace honeycomb::Cli {
namespace {

/// A frame number, or -1 where the text is none.
std::int32_t parseFrame(std::string_view text, std::int32_t whenEmpty) {
  if (text.empty()) return whenEmpty;
  std::int32_t frame = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), frame);
  return error == std::errc() && end == text.data() + text.size() && frame >= 0 ? frame : -1;
}

}  // namespace

Result<FrameRange> parseFrameRange(const std::string& text, std::int32_t frameCount) {
  if (text.empty()) return FrameRange{0, frameCount};
  const std::size_t colon = text.find(':');
  const std::string_view view = text;
  const std::int32_t begin = parseFrame(view.substr(0, colon), 0);
  const std::int32_t end = colon == std::string::npos ? -1 : parseFrame(view.substr(colon + 1), frameCount);
  if (begin < 0 || end < 0)
    return fail(ErrorCode::invalidOption,
                fmt::format("--frames {}: give a half-open range a:b, such as 0:{}", text, frameCount));
  if (begin >= end || end > frameCount)
    return fail(ErrorCode::invalidOption,
                fmt::format("--frames {}: the cache has frames 0 to {}; give a:b with 0 <= a < b <= {}", text,
                            frameCount - 1, frameCount));
  return FrameRange{begin, end};
}

}  // namespace honeycomb::Cli
