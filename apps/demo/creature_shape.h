#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "far/topology/polygons.h"

namespace honeycomb::Demo {

/// A vertex bound to a bone: its place in the bone's frame.
struct BoundVertex {
  int bone;
  glm::dvec3 local;
};

/// The creature's cage at rest: closed, of genus 0, faces of 3 to 8 sides counter-clockwise from outside.
struct CreatureShape {
  std::vector<BoundVertex> vertices;
  Far::Polygons polygons;
};

CreatureShape makeCreatureShape();

}  // namespace honeycomb::Demo
