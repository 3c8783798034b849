#pragma once

#include <span>

#include "apps/viewer/picture.h"
#include "apps/viewer/style.h"

namespace honeycomb::Viewer {

/// How pictures are laid out on a sheet, pixels.
struct SheetLayout {
  std::int32_t columns = 4;
  std::int32_t gap = 12;  ///< between pictures and round all of them
  Rgb paper{0xffffff};
};

/// The pictures, all of the first one's size, in rows from the top left. Pictures of another size are left out.
Picture contactSheet(std::span<const Picture> pictures, const SheetLayout& layout);

}  // namespace honeycomb::Viewer
