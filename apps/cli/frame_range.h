#pragma once

#include <cstdint>
#include <string>

#include "far/base/result.h"

namespace honeycomb::Cli {

/// Frames begin .. end-1.
struct FrameRange {
  std::int32_t begin = 0;
  std::int32_t end = 0;
  std::int32_t count() const { return end - begin; }
};

/// "a:b", "a:", ":b" or "" (all) as a half-open range of a cache's frames. Errors: invalidOption, for what is no range,
/// an empty one, or one past the cache's frames.
Result<FrameRange> parseFrameRange(const std::string& text, std::int32_t frameCount);

}  // namespace honeycomb::Cli
