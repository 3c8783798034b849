#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace honeycomb::Viewer {

/// 0xRRGGBB, sRGB, as in a paint program.
struct Rgb {
  std::uint32_t value = 0;
};

/// Linear light of an sRGB colour.
glm::vec3 linear(Rgb colour);

/// What the light costs.
enum class Lighting {
  full,  ///< every light throws a shadow: soft ones, and dark hollows
  quick  ///< only the key light does, for pictures that move: a tenth of the time
};

/// How a picture looks.
struct Style {
  float edgeWidth = 1.5f;     ///< of the cells' edges, pixels
  float edgeStrength = 0.8f;  ///< 0: no edges, 1: as dark as they get
  bool faceted = false;       ///< shade each face by its own normal instead of the points' normals
  bool flatness = false;      ///< colour each face by how far from flat it is instead of the mesh's colours
  float mostBent = 0.1f;      ///< what `flatness` shows darkest, see flatness()
  bool ground = true;         ///< a floor below the mesh that takes its shadow
  Lighting lighting = Lighting::full;
  Rgb backdropCentre{0xece8e1};
  Rgb backdropRim{0xa7afb6};
};

/// The colours of cells: hexagons are the quiet ground on which all others stand out.
struct Palette {
  Rgb triangle{0xe0a83a};
  Rgb quad{0xe2723f};
  Rgb pentagon{0xc23b55};
  Rgb hexagon{0x86b8a6};
  Rgb heptagon{0x3c6e8f};
  Rgb larger{0x3f3f74};
  Rgb petal{0xeef0e2};  ///< towards which hexagons round control vertices turn
  Rgb clay{0xd9c9b0};   ///< of a surface whose colours say nothing
  Rgb extraordinary{0xb3123c};
  Rgb glow{0xf29a5c};  ///< next to extraordinary faces, fading into `ordinary`
  Rgb ordinary{0xdfe6e4};
  Rgb of(std::int32_t sides) const;
};

}  // namespace honeycomb::Viewer
