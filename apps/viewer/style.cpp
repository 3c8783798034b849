#include "apps/viewer/style.h"

#include <cmath>

namespace honeycomb::Viewer {

glm::vec3 linear(Rgb colour) {
  glm::vec3 light(0);
  for (int channel = 0; channel < 3; ++channel) {
    const float s = static_cast<float>((colour.value >> (16 - 8 * channel)) & 255u) / 255.0f;
    light[channel] = s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
  }
  return light;
}

Rgb Palette::of(std::int32_t sides) const {
  switch (sides) {
    case 3:
      return triangle;
    case 4:
      return quad;
    case 5:
      return pentagon;
    case 6:
      return hexagon;
    case 7:
      return heptagon;
    default:
      return larger;
  }
}

}  // namespace honeycomb::Viewer
