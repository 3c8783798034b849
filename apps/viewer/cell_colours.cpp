#include "apps/viewer/cell_colours.h"

#include <cmath>

namespace honeycomb::Viewer {
namespace {

constexpr double kFaceTint = 0.68;  ///< how far a hexagon turns to its control face's colour
constexpr double kPetalTint = 0.4;
constexpr std::int32_t kRings = 6;  ///< that glow round an extraordinary face

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

std::vector<std::uint32_t> byDescent(const Far::Refinement& refinement, std::int32_t level, const Palette& palette) {
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

std::vector<std::uint32_t> bySides(const Far::Topology& topology, const Palette& palette) {
  std::vector<std::uint32_t> colours;
  colours.reserve(static_cast<std::size_t>(topology.faceCount()));
  for (std::int32_t f = 0; f < topology.faceCount(); ++f) colours.push_back(packed(palette.of(topology.sides(f))));
  return colours;
}

std::vector<std::uint32_t> byRings(const Far::Topology& topology, const Palette& palette) {
  std::vector<std::uint32_t> colours;
  for (const std::int32_t ring : ringsFromExtraordinary(topology, kRings)) {
    const Rgb next = mixed(palette.glow, palette.ordinary, std::sqrt(static_cast<double>(ring) / kRings));
    colours.push_back(packed(ring == 0 ? palette.extraordinary : next));
  }
  return colours;
}

}  // namespace

std::vector<std::int32_t> ringsFromExtraordinary(const Far::Topology& topology, std::int32_t most) {
  std::vector<std::int32_t> rings(static_cast<std::size_t>(topology.faceCount()), most);
  std::vector<std::int32_t> queue;
  for (std::int32_t f = 0; f < topology.faceCount(); ++f)
    if (topology.sides(f) != 6) {
      rings[static_cast<std::size_t>(f)] = 0;
      queue.push_back(f);
    }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::int32_t ring = rings[static_cast<std::size_t>(queue[i])] + 1;
    for (const std::int32_t h : topology.halfEdgesOf(queue[i])) {
      const std::int32_t twin = topology.twin(h);
      if (twin < 0 || rings[static_cast<std::size_t>(topology.face(twin))] <= ring) continue;
      rings[static_cast<std::size_t>(topology.face(twin))] = ring;
      queue.push_back(topology.face(twin));
    }
  }
  return rings;
}

std::vector<std::uint32_t> cellColours(const Far::Refinement& refinement, std::int32_t level, Colouring colouring,
                                       const Palette& palette) {
  const Far::Topology& topology = refinement.level(level).topology;
  switch (colouring) {
    case Colouring::plain:
      return std::vector<std::uint32_t>(static_cast<std::size_t>(topology.faceCount()), packed(palette.clay));
    case Colouring::sides:
      return bySides(topology, palette);
    case Colouring::extraordinary:
      return byRings(topology, palette);
    case Colouring::descent:
      break;
  }
  return byDescent(refinement, level, palette);
}

}  // namespace honeycomb::Viewer
