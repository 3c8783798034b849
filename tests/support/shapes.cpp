#include "tests/support/shapes.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace honeycomb::Test {
namespace {

Vec3 onCircle(double i, double n, double radius, double z) {
  const double angle = 2 * std::numbers::pi * i / n;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

}  // namespace

PolyMesh tetrahedron() {
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

PolyMesh cube() {
  PolyMesh mesh;
  for (std::size_t i = 0; i < 8; ++i) {
    mesh.points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  }
  mesh.faces = {{2, 3, 1, 0}, {4, 5, 7, 6}, {0, 1, 5, 4}, {6, 7, 3, 2}, {4, 6, 2, 0}, {1, 3, 7, 5}};
  return mesh;
}

PolyMesh dodecahedron() {
  // The dual of an icosahedron: one vertex per triangle, one pentagon per vertex.
  const double g = std::numbers::phi;
  const std::vector<Vec3> top = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  const std::vector<Loop> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                       {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                       {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                       {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  PolyMesh mesh;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> faceOf;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Loop& t = triangles[f];
    mesh.points.push_back(centroid({top[t[0]], top[t[1]], top[t[2]]}));
    for (std::size_t i = 0; i < 3; ++i) faceOf[{t[i], t[(i + 1) % 3]}] = f;
  }
  for (std::size_t v = 0; v < top.size(); ++v) {
    Loop loop;
    std::size_t w = 0;
    while (!faceOf.contains({v, w})) ++w;
    while (loop.size() < 5) {
      const std::size_t f = faceOf.at({v, w});
      loop.push_back(f);
      const Loop& t = triangles[f];
      for (std::size_t i = 0; i < 3; ++i) {
        if (t[i] != v && t[i] != w) {
          w = t[i];
          break;
        }
      }
    }
    mesh.faces.push_back(loop);
  }
  return mesh;
}

PolyMesh prism(std::size_t sides) {
  PolyMesh mesh;
  const auto n = static_cast<double>(sides);
  for (std::size_t i = 0; i < sides; ++i) mesh.points.push_back(onCircle(static_cast<double>(i), n, 1, -1));
  for (std::size_t i = 0; i < sides; ++i) mesh.points.push_back(onCircle(static_cast<double>(i), n, 1, 1));
  Loop bottom;
  Loop top;
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t j = (i + 1) % sides;
    bottom.push_back(sides - 1 - i);
    top.push_back(sides + i);
    mesh.faces.push_back({i, j, sides + j, sides + i});
  }
  mesh.faces.push_back(bottom);
  mesh.faces.push_back(top);
  return mesh;
}

PolyMesh torus(std::size_t m, std::size_t n) {
  PolyMesh mesh;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const Vec3 ring = onCircle(static_cast<double>(j), static_cast<double>(n), 0.4, 0);
      mesh.points.push_back(onCircle(static_cast<double>(i), static_cast<double>(m), 1 + ring[0], ring[1]));
      const std::size_t i1 = (i + 1) % m;
      const std::size_t j1 = (j + 1) % n;
      mesh.faces.push_back({i * n + j, i1 * n + j, i1 * n + j1, i * n + j1});
    }
  }
  return mesh;
}

PolyMesh grid(std::size_t m, std::size_t n) {
  PolyMesh mesh;
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      mesh.points.push_back({static_cast<double>(i), static_cast<double>(j), 0});
      if (i == m || j == n) continue;
      const std::size_t v = i * (n + 1) + j;
      mesh.faces.push_back({v, v + n + 1, v + n + 2, v + 1});
    }
  }
  return mesh;
}

PolyMesh wheel(std::size_t n) {
  PolyMesh mesh;
  mesh.points.push_back({0, 0, 0.5});
  for (std::size_t i = 0; i < n; ++i) {
    mesh.points.push_back(onCircle(static_cast<double>(i), static_cast<double>(n), 1, 0));
    mesh.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return mesh;
}

PolyMesh pillow(std::size_t n) {
  PolyMesh mesh;
  mesh.faces.resize(2);
  for (std::size_t i = 0; i < n; ++i) {
    mesh.points.push_back(onCircle(static_cast<double>(i), static_cast<double>(n), 1, i % 2 ? 0.2 : -0.3));
    mesh.faces[0].push_back(i);
    mesh.faces[1].push_back(n - 1 - i);
  }
  return mesh;
}

PolyMesh fan(std::size_t n) {
  PolyMesh mesh;
  mesh.points.push_back({0, 0, 0.5});
  for (std::size_t i = 0; i <= n; ++i) {
    mesh.points.push_back(onCircle(static_cast<double>(i), 2 * static_cast<double>(n), 1, 0));
    if (i < n) mesh.faces.push_back({0, 1 + i, 2 + i});
  }
  return mesh;
}

PolyMesh honeycomb(std::size_t n) {
  PolyMesh mesh;
  std::map<std::pair<long, long>, std::size_t> known;  // corners by their places in units of (sqrt 3 / 2, 1 / 2)
  const std::array<std::pair<long, long>, 6> around{{{1, 1}, {0, 2}, {-1, 1}, {-1, -1}, {0, -2}, {1, -1}}};
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < n; ++column) {
      const auto x = static_cast<long>(2 * column + row), y = static_cast<long>(3 * row);
      Loop loop;
      for (const auto& [dx, dy] : around) {
        const auto [place, isNew] = known.try_emplace({x + dx, y + dy}, mesh.points.size());
        if (isNew) {
          mesh.points.push_back({static_cast<double>(x + dx) * std::sqrt(0.75), static_cast<double>(y + dy) / 2, 0});
        }
        loop.push_back(place->second);
      }
      mesh.faces.push_back(std::move(loop));
    }
  }
  return mesh;
}

void append(PolyMesh& mesh, const PolyMesh& part) {
  const std::size_t first = mesh.points.size();
  mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
  for (Loop loop : part.faces) {
    for (std::size_t& v : loop) v += first;
    mesh.faces.push_back(std::move(loop));
  }
}

}  // namespace honeycomb::Test
