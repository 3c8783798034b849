#pragma once

#include <cstdint>
#include <vector>

namespace honeycomb::Viewer {

/// 8-bit RGBA, sRGB, rows from the top.
struct Picture {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<std::uint8_t> rgba;
};

}  // namespace honeycomb::Viewer
