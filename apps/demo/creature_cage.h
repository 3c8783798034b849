#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "apps/demo/creature_shape.h"

namespace honeycomb::Demo {

/// Vertex numbers in order; a ring runs counter-clockwise seen against its limb's direction (from the tip).
using Loop = std::vector<std::int32_t>;

/// Collects the vertices and faces of a cage. A mirrored builder's limbs have the left side's mirrored frames: it takes
/// the same loops and turns every face over.
class CageBuilder {
 public:
  void setMirrored(bool mirrored) { mirrored_ = mirrored; }

  std::int32_t addVertex(int bone, const glm::dvec3& local);
  Loop addRing(int bone, std::span<const glm::dvec3> locals);
  void addFace(Loop loop);
  /// Quads between two rings with the same number of vertices, from the one nearer the body to the one nearer the tip;
  /// `open` lists the places (quad k is between k and k + 1) that are left out.
  void bridge(const Loop& from, const Loop& to, std::span<const std::size_t> open = {});
  /// Triangles from a ring to a tip.
  void close(const Loop& ring, std::int32_t tip);

  CreatureShape take() && { return std::move(shape_); }

 private:
  CreatureShape shape_;
  bool mirrored_ = false;
};

}  // namespace honeycomb::Demo
