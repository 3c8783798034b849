#include "apps/gallery/shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>
#include <numeric>

#include "far/base/index.h"

namespace honeycomb::Gallery {
namespace {

using Cell = std::array<std::int32_t, 3>;

glm::vec3 onCircle(std::int32_t i, std::int32_t n, float radius, float height) {
  const float angle = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(n);
  return {radius * std::sin(angle), height, radius * std::cos(angle)};
}

/// The solid with these vertices, one face for each normal: the vertices that reach farthest along it.
Shape solid(std::span<const glm::vec3> vertices, std::span<const glm::vec3> normals) {
  Shape shape;
  for (const glm::vec3& vertex : vertices) shape.addPoint(vertex);
  for (const glm::vec3& normal : normals) {
    float farthest = 0;
    for (const glm::vec3& vertex : vertices) farthest = std::max(farthest, glm::dot(vertex, normal));
    const glm::vec3 right = glm::normalize(glm::cross(normal, glm::vec3(0.3F, 0.5F, 0.8F)));
    const glm::vec3 up = glm::normalize(glm::cross(normal, right));
    std::vector<std::pair<float, std::int32_t>> corners;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (glm::dot(vertices[v], normal) < 0.999F * farthest) continue;
      corners.emplace_back(std::atan2(glm::dot(vertices[v], up), glm::dot(vertices[v], right)),
                           static_cast<std::int32_t>(v));
    }
    std::sort(corners.begin(), corners.end());
    std::vector<std::int32_t> loop;
    loop.reserve(corners.size());
    for (const auto& corner : corners) loop.push_back(corner.second);
    shape.polygons.addFace(loop);
  }
  return shape;
}

/// Quads between a lower and an upper outline, counter-clockwise seen from above, and the two caps.
Shape extruded(std::span<const glm::vec3> outline, float height) {
  Shape shape;
  const auto n = static_cast<std::int32_t>(outline.size());
  for (const glm::vec3& point : outline) shape.addPoint(point);
  for (const glm::vec3& point : outline) shape.addPoint(point + glm::vec3(0, height, 0));
  for (std::int32_t i = 0; i < n; ++i) shape.polygons.addFace({i, (i + 1) % n, n + (i + 1) % n, n + i});
  std::vector<std::int32_t> upper(at(n));
  std::iota(upper.begin(), upper.end(), n);
  std::vector<std::int32_t> lower(at(n));
  std::iota(lower.rbegin(), lower.rend(), 0);
  shape.polygons.addFace(lower);
  shape.polygons.addFace(upper);
  return shape;
}

std::vector<Cell> box(const Cell& low, const Cell& high) {
  std::vector<Cell> cells;
  for (std::int32_t x = low[0]; x < high[0]; ++x) {
    for (std::int32_t y = low[1]; y < high[1]; ++y) {
      for (std::int32_t z = low[2]; z < high[2]; ++z) cells.push_back({x, y, z});
    }
  }
  return cells;
}

Shape blocksOf(std::initializer_list<std::vector<Cell>> boxes) {
  std::vector<Cell> cells;
  for (const auto& cellsOfBox : boxes) cells.insert(cells.end(), cellsOfBox.begin(), cellsOfBox.end());
  return blocks(cells);
}

}  // namespace

std::int32_t Shape::addPoint(glm::vec3 point) {
  for (int axis = 0; axis < 3; ++axis) points.push_back(point[axis]);
  return polygons.vertexCount++;
}

Shape cube() {
  std::vector<glm::vec3> vertices;
  for (const float x : {-0.5F, 0.5F}) {
    for (const float y : {-0.5F, 0.5F}) {
      for (const float z : {-0.5F, 0.5F}) vertices.emplace_back(x, y, z);
    }
  }
  const std::vector<glm::vec3> normals{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  return solid(vertices, normals);
}

Shape dodecahedron() {
  const float g = 0.5F * (1 + std::sqrt(5.0F));
  std::vector<glm::vec3> vertices;
  std::vector<glm::vec3> normals;
  for (const float a : {-1.0F, 1.0F}) {
    for (const float b : {-1.0F, 1.0F}) {
      for (const float c : {-1.0F, 1.0F}) vertices.emplace_back(a, b, c);
      for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 vertex(0);
        vertex[(axis + 1) % 3] = a / g;
        vertex[(axis + 2) % 3] = b * g;
        vertices.push_back(vertex);
        glm::vec3 normal(0);
        normal[(axis + 1) % 3] = b * g;
        normal[(axis + 2) % 3] = a;
        normals.push_back(normal);
      }
    }
  }
  return solid(vertices, normals);
}

Shape prism(std::int32_t sides, float height) {
  std::vector<glm::vec3> outline;
  outline.reserve(at(sides));
  for (std::int32_t i = 0; i < sides; ++i) outline.push_back(onCircle(i, sides, 1, 0));
  return extruded(outline, height);
}

Shape star(std::int32_t tips) {
  std::vector<glm::vec3> outline;
  outline.reserve(at(2 * tips));
  for (std::int32_t i = 0; i < 2 * tips; ++i) outline.push_back(onCircle(i, 2 * tips, i % 2 == 0 ? 1.5F : 0.7F, 0));
  return extruded(outline, 0.8F);
}

Shape ringed(std::int32_t sides) {
  Shape shape;
  for (const float radius : {1.0F, 1.7F}) {
    for (std::int32_t i = 0; i < sides; ++i) shape.addPoint(onCircle(i, sides, radius, 0));
  }
  std::vector<std::int32_t> middle(at(sides));
  std::iota(middle.begin(), middle.end(), 0);
  shape.polygons.addFace(middle);
  for (std::int32_t i = 0; i < sides; ++i) {
    const std::int32_t next = (i + 1) % sides;
    shape.polygons.addFace({next, i, sides + i, sides + next});
  }
  return shape;
}

Shape torus(std::int32_t around, std::int32_t across) {
  Shape shape;
  for (std::int32_t i = 0; i < around; ++i) {
    for (std::int32_t j = 0; j < across; ++j) {
      const glm::vec3 section = onCircle(j, across, 0.5F, 0);
      const glm::vec3 direction = onCircle(i, around, 1, 0);
      shape.addPoint((1.1F + section.x) * direction + glm::vec3(0, section.z, 0));
    }
  }
  const auto vertex = [&](std::int32_t i, std::int32_t j) { return i % around * across + j % across; };
  for (std::int32_t i = 0; i < around; ++i) {
    for (std::int32_t j = 0; j < across; ++j) {
      shape.polygons.addFace({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)});
    }
  }
  return shape;
}

Shape blocks(std::span<const Cell> cells) {
  Shape shape;
  std::map<Cell, std::int32_t> vertices;
  const auto vertexAt = [&](const Cell& place) {
    const auto found = vertices.find(place);
    if (found != vertices.end()) return found->second;
    const std::int32_t v = shape.addPoint(glm::vec3(place[0], place[1], place[2]));
    vertices.emplace(place, v);
    return v;
  };
  for (const Cell& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const std::int32_t side : {-1, 1}) {
        Cell beyond = cell;
        beyond[axis] += side;
        if (std::find(cells.begin(), cells.end(), beyond) != cells.end()) continue;
        // Counter-clockwise round the axis, which for the lower side is clockwise seen from outside.
        std::vector<std::int32_t> loop;
        for (const auto& [u, v] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
          Cell corner = cell;
          corner[axis] += side > 0 ? 1 : 0;
          corner[(axis + 1) % 3] += u;
          corner[(axis + 2) % 3] += v;
          loop.push_back(vertexAt(corner));
        }
        if (side < 0) std::reverse(loop.begin(), loop.end());
        shape.polygons.addFace(loop);
      }
    }
  }
  return shape;
}

Shape blockT() {
  return blocksOf({box({1, 0, 0}, {2, 2, 1}), box({0, 2, 0}, {3, 3, 1})});
}

Shape chair() {
  return blocksOf({box({0, 2, 0}, {3, 3, 3}), box({0, 0, 0}, {1, 2, 1}), box({2, 0, 0}, {3, 2, 1}),
                   box({0, 0, 2}, {1, 2, 3}), box({2, 0, 2}, {3, 2, 3}), box({0, 3, 0}, {3, 6, 1})});
}

Shape twoHoles() {
  return blocksOf({box({0, 0, 0}, {5, 1, 1}), box({0, 1, 0}, {1, 2, 1}), box({2, 1, 0}, {3, 2, 1}),
                   box({4, 1, 0}, {5, 2, 1}), box({0, 2, 0}, {5, 3, 1})});
}

}  // namespace honeycomb::Gallery
