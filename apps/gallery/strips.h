#pragma once

#include <glm/glm.hpp>
#include <span>

#include "apps/gallery/model.h"

namespace honeycomb::Gallery {

/// A line on the ground as a strip of quads, at the heights of its points. Steps shorter than a thousandth of the width
/// are left out.
void addStrip(Model& model, std::span<const glm::vec3> line, float width, Viewer::Rgb colour);

/// The edges of a mesh as strips.
void addEdges(Model& model, const Shape& mesh, float width, Viewer::Rgb colour);

}  // namespace honeycomb::Gallery
