#include "tests/viewer/cube.h"

#include <array>
#include <cmath>

namespace honeycomb::ViewerTests {

Cube::Cube(std::uint32_t colour) : colours(6, colour) {
  for (int v = 0; v < 8; ++v) {
    for (const int bit : {1, 2, 4}) {
      const float coordinate = (v & bit) != 0 ? 1.0F : -1.0F;
      points.push_back(coordinate);
      normals.push_back(coordinate / std::sqrt(3.0F));
    }
  }
  corners = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
  for (std::int32_t f = 0; f <= 6; ++f) faceOffsets.push_back(4 * f);
}

Far::Polygons Cube::polygons() const {
  Far::Polygons polygons;
  polygons.vertexCount = 8;
  polygons.faceOffsets.assign(faceOffsets.begin(), faceOffsets.end());
  polygons.indices = corners;
  return polygons;
}

Pixel pixelAt(const Viewer::Picture& picture, std::int32_t x, std::int32_t y) {
  const std::size_t i =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
  return {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]};
}

}  // namespace honeycomb::ViewerTests
