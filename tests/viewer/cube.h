#pragma once

#include <cstdint>
#include <vector>

#include "apps/viewer/cell_mesh.h"
#include "apps/viewer/picture.h"
#include "far/topology/polygons.h"

namespace honeycomb::ViewerTests {

/// A cube from -1 to 1 with its six faces: left, right (x), below, above (y), behind, in front (z).
struct Cube {
  std::vector<float> points;
  std::vector<float> normals;  ///< away from the middle
  std::vector<std::int32_t> faceOffsets;
  std::vector<std::int32_t> corners;
  std::vector<std::uint32_t> colours;

  /// Every face of the colour 0xAABBGGRR.
  explicit Cube(std::uint32_t colour);
  Viewer::CellMeshContent content() const { return {8, faceOffsets, corners, colours}; }
  Far::Polygons polygons() const;
};

struct Pixel {
  int red = 0, green = 0, blue = 0;
  int sum() const { return red + green + blue; }
};
Pixel pixelAt(const Viewer::Picture& picture, std::int32_t x, std::int32_t y);

}  // namespace honeycomb::ViewerTests
