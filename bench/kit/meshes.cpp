#include "bench/kit/meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#include "far/base/index.h"

namespace honeycomb::Bench {

namespace {

/// A torus of rings x sectors vertices.
struct TorusGrid {
  std::int32_t rings = 4;
  std::int32_t sectors = 4;

  std::int32_t vertex(std::int32_t i, std::int32_t j) const { return (i % rings) * sectors + j % sectors; }
  std::int32_t vertexCount() const { return rings * sectors; }
};

/// The most even factors of `faces`; where they are more than 1:4, the most even grid of at most as many faces.
TorusGrid gridOf(std::int64_t faces) {
  const std::int64_t wanted = std::max(faces, kFewestFaces);
  const auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(wanted)));
  for (std::int64_t rings = root; 2 * rings >= root && rings >= 3; --rings) {
    if (wanted % rings == 0) return {static_cast<std::int32_t>(rings), static_cast<std::int32_t>(wanted / rings)};
  }
  return {static_cast<std::int32_t>(root), static_cast<std::int32_t>(wanted / root)};
}

std::vector<double> pointsOf(const TorusGrid& grid) {
  std::vector<double> points;
  points.reserve(3 * at(grid.vertexCount()));
  for (std::int32_t i = 0; i < grid.rings; ++i) {
    for (std::int32_t j = 0; j < grid.sectors; ++j) {
      const double a = 2 * std::numbers::pi * i / grid.rings;
      const double b = 2 * std::numbers::pi * j / grid.sectors;
      const double radius = 2 + std::cos(b);
      for (const double x : {radius * std::cos(a), std::sin(b), radius * std::sin(a)}) points.push_back(x);
    }
  }
  return points;
}

/// A number below `count` from the generator, the same with every standard library.
std::size_t below(std::mt19937_64& random, std::size_t count) {
  return static_cast<std::size_t>(random() % count);
}

std::vector<std::int32_t> permutation(std::mt19937_64& random, std::int64_t count) {
  std::vector<std::int32_t> order(at(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[below(random, i)]);
  return order;
}

/// Two neighbouring quads and how they are cut:
///     d - e - f
///     |   |   |
///     a - b - c
void addPair(Far::Polygons& polygons, const std::vector<std::int32_t>& corners, std::size_t cut) {
  const std::int32_t a = corners[0], b = corners[1], c = corners[2], d = corners[3], e = corners[4], f = corners[5];
  switch (cut) {
    case 0:
      return polygons.addFace({a, b, c, f, e, d});
    case 1:
      for (const auto& triangle : {std::vector{a, b, e}, {a, e, d}, {b, c, f}, {b, f, e}}) polygons.addFace(triangle);
      return;
    case 2:
      polygons.addFace({a, b, f, e, d});
      return polygons.addFace({b, c, f});
    default:
      polygons.addFace({a, b, e, d});
      return polygons.addFace({b, c, f, e});
  }
}

}  // namespace

Mesh torus(std::int64_t faces) {
  const TorusGrid grid = gridOf(faces);
  Mesh mesh{"torus", {}, pointsOf(grid)};
  mesh.polygons.vertexCount = grid.vertexCount();
  for (std::int32_t i = 0; i < grid.rings; ++i) {
    for (std::int32_t j = 0; j < grid.sectors; ++j) {
      mesh.polygons.addFace(
          {grid.vertex(i, j), grid.vertex(i, j + 1), grid.vertex(i + 1, j + 1), grid.vertex(i + 1, j)});
    }
  }
  return mesh;
}

Mesh mixed(std::int64_t faces) {
  constexpr std::size_t kCuts = 5;
  const auto root = static_cast<std::int32_t>(std::sqrt(static_cast<double>(std::max(faces, kFewestFaces))));
  const TorusGrid grid{root, std::max(4, (root + 1) / 2 * 2)};
  Mesh mesh{"mixed", {}, pointsOf(grid)};
  mesh.polygons.vertexCount = grid.vertexCount();
  std::mt19937_64 random(1);
  for (std::int32_t i = 0; i < grid.rings; ++i) {
    for (std::int32_t j = 0; j < grid.sectors; j += 2) {
      std::size_t cut = below(random, kCuts);
      // Cuts 0 and 2 take an edge from vertices of four: in every other row only, so that each vertex keeps three.
      if ((cut == 0 || cut == 2) && (i % 2 == 1 || i + 1 == grid.rings)) cut = kCuts - 1;
      addPair(mesh.polygons,
              {grid.vertex(i, j), grid.vertex(i, j + 1), grid.vertex(i, j + 2), grid.vertex(i + 1, j),
               grid.vertex(i + 1, j + 1), grid.vertex(i + 1, j + 2)},
              cut);
    }
  }
  return mesh;
}

Mesh shuffled(const Mesh& mesh, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const std::vector<std::int32_t> numbers = permutation(random, mesh.polygons.vertexCount);
  Mesh result{"shuffled " + mesh.name, {}, std::vector<double>(mesh.points.size())};
  result.polygons.vertexCount = mesh.polygons.vertexCount;
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    std::copy_n(&mesh.points[3 * v], 3, &result.points[3 * at(numbers[v])]);
  }
  for (const std::int32_t f : permutation(random, mesh.polygons.faceCount())) {
    std::vector<std::int32_t> loop(mesh.polygons.indices.begin() + mesh.polygons.faceOffsets[at(f)],
                                   mesh.polygons.indices.begin() + mesh.polygons.faceOffsets[at(f) + 1]);
    for (std::int32_t& v : loop) v = numbers[at(v)];
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(below(random, loop.size())), loop.end());
    result.polygons.addFace(loop);
  }
  for (const std::int32_t v : mesh.polygons.corners) result.polygons.corners.push_back(numbers[at(v)]);
  for (Far::Crease crease : mesh.polygons.creases) {
    crease.vertex0 = numbers[at(crease.vertex0)];
    crease.vertex1 = numbers[at(crease.vertex1)];
    result.polygons.creases.push_back(crease);
  }
  return result;
}

}  // namespace honeycomb::Bench
