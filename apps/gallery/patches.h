#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <span>

#include "apps/gallery/model.h"
#include "far/tables/patch_table.h"

namespace honeycomb::Gallery {

/// A part of a patch, by the places of its corners, counter-clockwise.
using PatchTriangle = std::array<Far::Barycentric, 3>;

constexpr PatchTriangle kWholePatch{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// What a spline ring has of a patch whose corner `corner` is the middle of the face that the rings go round: the patch
/// is cut into four again and again, and ring `ring` is the three outer quarters of cut `ring`.
std::array<PatchTriangle, 3> ringTriangles(std::size_t corner, std::int32_t ring);

/// The corner of a patch that lies in a face of the table's topology; -1 where it has none there.
std::int32_t cornerIn(const Far::PatchTable& table, std::int32_t patch, std::int32_t face);

/// How parts of patches are drawn.
struct PatchStyle {
  std::int32_t pieces = 8;  ///< cut into this many times this many triangles
  bool flat = false;        ///< shaded by one normal, that of its middle
  glm::vec3 offset{0};      ///< where to
  std::function<Viewer::Rgb(const glm::vec3& normal)> colour;
};

/// Adds a part of a patch to the model. Errors: those of PatchTable::evaluate.
Result<void> addPatch(Model& model, const Far::PatchTable& table, std::span<const float> points, std::int32_t patch,
                      const PatchTriangle& part, const PatchStyle& style);

/// The patch's iso-lines as strips: of each barycentric coordinate those at 0, 1/pieces, 2/pieces .. Its outline, which
/// neighbours draw too, is as wide as `width`, the lines inside half as wide. For patches on the ground.
Result<void> addIsoLines(Model& model, const Far::PatchTable& table, std::span<const float> points, std::int32_t patch,
                         std::int32_t pieces, float width, Viewer::Rgb colour);

}  // namespace honeycomb::Gallery
