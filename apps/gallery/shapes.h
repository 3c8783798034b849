#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "far/topology/polygons.h"

namespace honeycomb::Gallery {

/// A control mesh; y is up.
struct Shape {
  Far::Polygons polygons;
  std::vector<float> points;  ///< x y z of each vertex

  std::int32_t addPoint(glm::vec3 point);
};

/// With edges of length 1 round the origin.
Shape cube();
/// With vertices at distance sqrt 3 from the origin.
Shape dodecahedron();
/// Two `sides`-gons of radius 1 and `sides` quads, upright, `height` high.
Shape prism(std::int32_t sides, float height);
/// Two polygons in the shape of a star with `tips` tips, and the quads between them.
Shape star(std::int32_t tips);
/// A polygon of radius 1 lying flat, with a ring of quads round it; open.
Shape ringed(std::int32_t sides);
/// around x across quads, lying flat.
Shape torus(std::int32_t around, std::int32_t across);
/// The outside of unit cubes on a lattice, in quads. Cubes that touch must share a face.
Shape blocks(std::span<const std::array<std::int32_t, 3>> cells);

Shape blockT();
Shape chair();
/// A plate with two holes: genus 2.
Shape twoHoles();

}  // namespace honeycomb::Gallery
