#include "apps/gallery/strips.h"

#include <algorithm>
#include <array>
#include <set>

#include "far/base/index.h"

namespace honeycomb::Gallery {

void addStrip(Model& model, std::span<const glm::vec3> line, float width, Viewer::Rgb colour) {
  const glm::vec3 up(0, 1, 0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const glm::vec3 a = line[i - 1];
    const glm::vec3 b = line[i];
    if (glm::length(b - a) < 1e-3F * width) continue;
    const glm::vec3 along = 0.5F * width * glm::normalize(b - a);
    const glm::vec3 left = glm::cross(up, along);
    // Half a width longer at both ends, so that strips overlap where they meet.
    const std::array<glm::vec3, 4> loop{a - along - left, b + along - left, b + along + left, a - along + left};
    std::array<std::int32_t, 4> strip{};
    for (std::size_t k = 0; k < 4; ++k) strip[k] = model.addPoint(loop[k], up);
    model.addFace(strip, colour);
  }
}

void addEdges(Model& model, const Shape& mesh, float width, Viewer::Rgb colour) {
  const Far::Polygons& polygons = mesh.polygons;
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  for (std::size_t f = 0; f + 1 < polygons.faceOffsets.size(); ++f) {
    const auto begin = at(polygons.faceOffsets[f]);
    const auto end = at(polygons.faceOffsets[f + 1]);
    for (std::size_t h = begin; h < end; ++h) {
      edges.insert(std::minmax(polygons.indices[h], polygons.indices[h + 1 == end ? begin : h + 1]));
    }
  }
  const auto pointAt = [&](std::int32_t v) {
    return glm::vec3(mesh.points[at(3 * v)], mesh.points[at(3 * v) + 1], mesh.points[at(3 * v) + 2]);
  };
  for (const auto& edge : edges) {
    const std::array<glm::vec3, 2> line{pointAt(edge.first), pointAt(edge.second)};
    addStrip(model, line, width, colour);
  }
}

}  // namespace honeycomb::Gallery
