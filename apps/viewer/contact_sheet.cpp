#include "apps/viewer/contact_sheet.h"

#include <algorithm>

namespace honeycomb::Viewer {
namespace {

Picture blankSheet(std::int32_t width, std::int32_t height, Rgb paper) {
  Picture sheet{width, height, {}};
  sheet.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
  for (std::size_t i = 0; i < sheet.rgba.size(); i += 4) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      sheet.rgba[i + channel] = static_cast<std::uint8_t>((paper.value >> (16 - 8 * channel)) & 255u);
    }
  }
  return sheet;
}

void paste(Picture& sheet, const Picture& picture, std::int32_t x, std::int32_t y) {
  const auto row = static_cast<std::ptrdiff_t>(4) * picture.width;
  for (std::int32_t line = 0; line < picture.height; ++line) {
    const auto from = picture.rgba.begin() + line * row;
    const auto to = sheet.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y + line) * sheet.width + x);
    std::copy(from, from + row, to);
  }
}

}  // namespace

Picture contactSheet(std::span<const Picture> pictures, const SheetLayout& layout) {
  if (pictures.empty()) return {};
  const std::int32_t width = pictures.front().width;
  const std::int32_t height = pictures.front().height;
  const auto count = static_cast<std::int32_t>(pictures.size());
  const std::int32_t columns = std::clamp(layout.columns, 1, count);
  const std::int32_t rows = (count + columns - 1) / columns;
  Picture sheet =
      blankSheet(columns * (width + layout.gap) + layout.gap, rows * (height + layout.gap) + layout.gap, layout.paper);
  for (std::int32_t i = 0; i < count; ++i) {
    const Picture& picture = pictures[static_cast<std::size_t>(i)];
    if (picture.width != width || picture.height != height) continue;
    paste(sheet, picture, layout.gap + i % columns * (width + layout.gap),
          layout.gap + i / columns * (height + layout.gap));
  }
  return sheet;
}

}  // namespace honeycomb::Viewer
