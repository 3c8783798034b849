#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "far/base/result.h"

namespace honeycomb::Io {

/// Writes 8-bit RGBA pixels (sRGB, alpha not multiplied in), rows from the top, as a PNG. The file appears under `path`
/// only when whole. Errors: unwritable; invalidOption for a side outside 1 to 32768 pixels or for other than
/// 4 x width x height bytes; outOfMemory.
Result<void> writePng(const std::filesystem::path& path, std::int32_t width, std::int32_t height,
                      std::span<const std::uint8_t> rgba);

}  // namespace honeycomb::Io
