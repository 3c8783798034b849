#include "tests/play/pictures.h"

#include <png.h>

#include <algorithm>
#include <cstdlib>

namespace honeycomb::Test {

Viewer::Picture readPng(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return {};
  image.format = PNG_FORMAT_RGBA;
  Viewer::Picture picture{static_cast<std::int32_t>(image.width), static_cast<std::int32_t>(image.height), {}};
  picture.rgba.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) == 0) return {};
  return picture;
}

double difference(const Viewer::Picture& a, const Viewer::Picture& b, int tolerance) {
  if (a.rgba.size() != b.rgba.size() || a.width != b.width || a.rgba.empty()) return 1;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int{a.rgba[i + c]} - int{b.rgba[i + c]}));
    count += most > tolerance ? 1 : 0;
  }
  return static_cast<double>(count) / (static_cast<double>(a.width) * a.height);
}

Colour colourAt(const Viewer::Picture& picture, std::int32_t x, std::int32_t y) {
  const std::size_t i =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
  return {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]};
}

}  // namespace honeycomb::Test
