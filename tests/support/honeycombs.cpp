#include "tests/support/honeycombs.h"

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

#include "far/schemes/akleman.h"
#include "tests/support/random.h"
#include "tests/support/random_mesh.h"
#include "tests/support/refined.h"

namespace honeycomb::Test {
namespace {

/// The hexagons q, r in -4 .. 4 for which `has` holds; the third axis is -q-r.
PolyMesh hexagons(const std::function<bool(int q, int r)>& has) {
  PolyMesh mesh;
  std::map<std::pair<long, long>, std::size_t> seen;
  for (int q = -4; q <= 4; ++q) {
    for (int r = -4; r <= 4; ++r) {
      if (!has(q, r)) continue;
      Loop loop;
      for (int k = 0; k < 6; ++k) {
        const double angle = std::numbers::pi * (2 * k + 1) / 6;
        const Vec3 p{std::numbers::sqrt3 * (q + r / 2.0) + std::cos(angle), 1.5 * r + std::sin(angle), 0};
        const auto key = std::make_pair(std::lround(100 * p[0]), std::lround(100 * p[1]));
        if (seen.insert({key, mesh.points.size()}).second) mesh.points.push_back(p);
        loop.push_back(seen.at(key));
      }
      mesh.faces.push_back(loop);
    }
  }
  return mesh;
}

bool inDisc(int q, int r, int radius) {
  return std::abs(q) <= radius && std::abs(r) <= radius && std::abs(q + r) <= radius;
}

/// Without the points that no face uses.
PolyMesh compact(const PolyMesh& mesh) {
  PolyMesh result;
  std::map<std::size_t, std::size_t> numbers;
  for (Loop loop : mesh.faces) {
    for (std::size_t& v : loop) {
      if (numbers.insert({v, result.points.size()}).second) result.points.push_back(mesh.points[v]);
      v = numbers.at(v);
    }
    result.faces.push_back(std::move(loop));
  }
  return result;
}

}  // namespace

std::vector<PolyMesh> honeycombPatches() {
  return {hexagons([](int q, int r) { return inDisc(q, r, 2); }),
          hexagons([](int q, int r) { return q >= -2 && r >= -2 && q + r <= 0; }),
          hexagons([](int q, int r) { return std::abs(q) <= 2 && std::abs(r) <= 1; }),
          hexagons([](int q, int r) { return inDisc(q, r, 3) && !inDisc(q, r, 0); }),
          hexagons([](int q, int r) { return std::abs(q) <= 3 && std::abs(r) <= 3 && (q < 0 || r < 0); }),
          hexagons([](int q, int r) { return std::abs(q) <= 3 && (r == 0 || r == 1); })};
}

PolyMesh flower(std::size_t m, std::size_t n) {
  // Vertices: q_1 .. q_m, spoke ends x_1 .. x_m, y_1 .. y_{m-1} between those, z_0, z_m, then the rest of the face.
  const auto q = [](std::size_t i) { return i - 1; };
  const auto x = [m](std::size_t i) { return m + i - 1; };
  const auto y = [m](std::size_t i) { return 2 * m + i - 1; };
  const std::size_t z0 = 3 * m - 1, zm = 3 * m, rest = 3 * m + 1;
  PolyMesh mesh;
  Loop face;
  for (std::size_t i = 1; i <= m; ++i) face.push_back(q(i));
  for (std::size_t i = 0; i < n - m; ++i) face.push_back(rest + i);
  const std::size_t after = rest, before = rest + n - m - 1;
  mesh.faces = {face, {q(1), before, z0, x(1)}, {after, q(m), x(m), zm}};
  for (std::size_t i = 1; i < m; ++i) mesh.faces.push_back({q(i + 1), q(i), x(i), y(i), x(i + 1)});
  Random random(m * 1000 + n);
  for (std::size_t v = 0; v < rest + n - m; ++v) {
    mesh.points.push_back({random.symmetric(), random.symmetric(), random.symmetric()});
  }
  return mesh;
}

PolyMesh randomThreeValent(std::uint64_t seed) {
  constexpr std::size_t kFewestFaces = 8, kMostFaces = 30;
  RandomMesh base = randomMesh(seed);
  const auto fits = [](std::size_t faces) { return faces >= kFewestFaces && faces <= kMostFaces; };
  for (std::uint64_t next = seed + 1000; !fits(base.mesh.faces.size()); next += 1000) base = randomMesh(next);
  PolyMesh mesh = levelMesh(refined(base, *Far::akleman(), 1), 1, base.mesh.points);
  Random random(seed);
  std::vector<Loop> kept;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (f > 0 && !random.chance(0.12)) kept.push_back(mesh.faces[f]);
  }
  mesh.faces = std::move(kept);
  return compact(mesh);
}

}  // namespace honeycomb::Test
