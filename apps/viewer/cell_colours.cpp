#include "apps/viewer/cell_colours.h"

#include <cmath>

namespace honeycomb::Viewer {
namespace {

constexpr double kFaceTint = 0.68;  ///< how far a hexagon turns to its control face's colour
constexpr double kPetalTint = 0.4;

/// a + t (b - a) in each channel, of 0xRRGGBB.
Rgb mixed(Rgb a, Rgb b, double t) {
  std::uint32_t value = 0;
  for (std::uint32_t shift = 0; shift < 24; shift += 8) {
    const double from = (a.value >> shift) & 255u;
    const double to = (b.value >> shift) & 255u;
    value |= static_cast<std::uint32_t>(std::lround(from + t * (to - from))) << shift;
  }
  return Rgb{value};
}

std::uint32_t packed(Rgb colour) {
  return 0xff000000u | ((colour.value & 255u) << 16) | (colour.value & 0xff00u) | (colour.value >> 16);
}

}  // namespace

std::vector<std::uint32_t> cellColours(const Far::Refinement& refinement, std::int32_t level, const Palette& palette) {
  const Far::Topology& topology = refinement.level(level).topology;
  const Far::Topology& control = refinement.level(0).topology;
  const std::vector<Far::Origin> origins = refinement.faceOrigins(level);
  std::vector<std::uint32_t> colours;
  colours.reserve(origins.size());
  for (std::int32_t f = 0; f < topology.faceCount(); ++f) {
    const Far::Origin& origin = origins[static_cast<std::size_t>(f)];
    const std::int32_t sides = topology.sides(f);
    Rgb colour = palette.of(sides);
    if (sides == 6 && level > 0) {
      colour = origin.vertex ? mixed(colour, palette.petal, kPetalTint)
                             : mixed(colour, palette.of(control.sides(origin.element)), kFaceTint);
    }
    colours.push_back(packed(colour));
  }
  return colours;
}

}  // namespace honeycomb::Viewer
