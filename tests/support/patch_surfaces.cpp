#include "tests/support/patch_surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/support/golden.h"
#include "tests/support/must.h"
#include "tests/support/random_mesh.h"
#include "tests/support/reference_zip.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

/// After a step of Akleman and Srinivasan's scheme every vertex has three edges, or two on a boundary.
PolyMesh randomThreeValent(std::uint64_t seed) {
  const RandomMesh random = randomMesh(seed);
  return referenceZip(referenceStart(random.mesh, random.cornerTags), {.tension = paperTension}).mesh;
}

PolyMesh threeValentShape(std::size_t number) {
  switch (number) {
    case 0:
      return tetrahedron();
    case 1:
      return cube();
    case 2:
      return prism(3);
    case 3:
      return prism(7);
    case 4:
      return doubleBridge();
    case kHoneycombMesh:
      return readGoldenMesh("halfbox-eval/honeycomb_control.obj");
    case 6:
      return HalfBoxStep(dodecahedron()).mesh();
    default:
      return randomThreeValent(number);
  }
}

double factorial(std::size_t n) {
  return n < 2 ? 1 : static_cast<double>(n) * factorial(n - 1);
}

}  // namespace

PolyMesh threeValentMesh(std::size_t number) {
  PolyMesh mesh = threeValentShape(number);
  Random random(1000 + number);
  for (Vec3& p : mesh.points) p = {random.symmetric(), random.symmetric(), random.symmetric()};
  return mesh;
}

PolyMesh doubleBridge() {
  // Vertices 0..3 are a pair of triangles over the edge (0, 1), and so are 4..7; 2-6 and 3-7 are the bridges.
  return {{{-1, 1, 0}, {-1, -1, 0}, {-1, 0, 1}, {-1, 0, -1}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}},
          {{0, 1, 2}, {1, 0, 3}, {5, 4, 6}, {4, 5, 7}, {0, 2, 6, 4, 7, 3}, {2, 1, 3, 7, 5, 6}}};
}

PatchSurface::PatchSurface(PolyMesh polygons)
    : mesh(std::move(polygons)),
      packed(pack<double>(mesh.points)),
      table(must(Far::PatchTable::build(toTopology(mesh)))) {}

Far::PatchPoint PatchSurface::at(std::int32_t patch, const Far::Barycentric& u) const {
  return must(table.evaluate<double>(patch, u, packed));
}

std::vector<double> PatchSurface::bezierPoints() const {
  return must(table.bezierPoints<double>(packed));
}

Vec3 PatchSurface::weighted(std::int32_t patch, const std::vector<double>& weights) const {
  const std::vector<std::int32_t> points = table.controlPoints(patch);
  if (points.size() != weights.size()) throw std::runtime_error("as many weights as points are needed");
  Vec3 sum{};
  for (std::size_t i = 0; i < points.size(); ++i) sum = sum + weights[i] * Test::at(mesh.points, points[i]);
  return sum;
}

std::size_t PatchSurface::inputFace(std::int32_t face) const {
  return static_cast<std::size_t>(table.topology().inputFace(face));
}

std::size_t PatchSurface::cornerIn(std::int32_t patch, std::int32_t face) const {
  const std::array<std::int32_t, 3> faces = table.patch(patch).faces();
  const auto found = std::find(faces.begin(), faces.end(), face);
  if (found == faces.end()) throw std::runtime_error("the patch has no corner in that face");
  return static_cast<std::size_t>(found - faces.begin());
}

std::size_t PatchSurface::cornerInFace(std::int32_t patch, std::size_t meshFace) const {
  for (const std::int32_t face : table.patch(patch).faces()) {
    if (inputFace(face) == meshFace) return cornerIn(patch, face);
  }
  throw std::runtime_error("the patch has no corner in that face");
}

Loop PatchSurface::loopFrom(std::int32_t face, std::int32_t vertex) const {
  Loop loop = mesh.faces[inputFace(face)];
  std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), static_cast<std::size_t>(vertex)), loop.end());
  return loop;
}

std::vector<Vec3> PatchSurface::polygonFrom(std::int32_t face, std::int32_t vertex) const {
  std::vector<Vec3> polygon;
  for (const std::size_t v : loopFrom(face, vertex)) polygon.push_back(mesh.points[v]);
  return polygon;
}

Vec3 along(const Far::PatchPoint& point, std::size_t to, std::size_t from) {
  // du = J_0 - J_2 and dv = J_1 - J_2, so relative to J_2 the corners are du, dv and nothing.
  const std::array<Vec3, 3> corner{point.du, point.dv, Vec3{}};
  return corner[to] - corner[from];
}

Vec3 bernstein(const std::vector<double>& bezier, std::size_t r, const Far::Barycentric& u) {
  Vec3 sum{};
  std::size_t next = 30 * r;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t k = 0; k <= row; ++k, next += 3) {
      const std::array<std::size_t, 3> e{3 - row, row - k, k};
      double weight = 6;
      for (std::size_t i = 0; i < 3; ++i) weight *= std::pow(u[i], static_cast<double>(e[i])) / factorial(e[i]);
      sum = sum + weight * Vec3{bezier[next], bezier[next + 1], bezier[next + 2]};
    }
  }
  return sum;
}

HalfBoxStep::HalfBoxStep(const PolyMesh& mesh) {
  addCornerPoints(mesh);
  addVertexPoints(mesh);
  addEdgeFaces(mesh);
}

void HalfBoxStep::addCornerPoints(const PolyMesh& mesh) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<Vec3> polygon = corners(mesh, f);
    const std::size_t n = polygon.size();
    Loop loop;
    for (std::size_t k = 0; k < n; ++k) {
      Vec3 point{};
      for (std::size_t i = 0; i < n; ++i) {
        constexpr double kHexagon[] = {0.5, 0.125, 0.125, 0, 0.125, 0.125};
        const auto angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double other = (3 + 2 * std::cos(angle)) / (4 * static_cast<double>(n)) + (i == 0 ? 0.25 : 0);
        point = point + (n == 6 ? kHexagon[i] : other) * polygon[(k + i) % n];
      }
      cornerPoints_[{f, mesh.faces[f][k]}] = refined_.points.size();
      loop.push_back(refined_.points.size());
      refined_.points.push_back(point);
    }
    refined_.faces.push_back(loop);
  }
}

void HalfBoxStep::addVertexPoints(const PolyMesh& mesh) {
  std::map<std::size_t, std::map<std::size_t, int>> neighbours;
  for (const Loop& loop : mesh.faces) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::size_t next = loop[(k + 1) % loop.size()];
      ++neighbours[loop[k]][next];
      ++neighbours[next][loop[k]];
    }
  }
  for (const auto& [v, around] : neighbours) {
    if (around.size() != 3) continue;
    Vec3 sum = mesh.points[v];
    for (const auto& neighbour : around) sum = sum + mesh.points[neighbour.first];
    vertexPoints_[v] = refined_.points.size();
    refined_.points.push_back(0.25 * sum);
  }
}

void HalfBoxStep::addEdgeFaces(const PolyMesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> faceOf;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Loop& loop = mesh.faces[f];
    for (std::size_t k = 0; k < loop.size(); ++k) faceOf[{loop[k], loop[(k + 1) % loop.size()]}] = f;
  }
  for (const auto& [edge, left] : faceOf) {
    const auto [v, w] = edge;
    const auto twin = faceOf.find({w, v});
    if (v > w || twin == faceOf.end()) continue;
    const std::size_t right = twin->second;
    // Both ends of an inside edge of a three-valent mesh have three edges.
    edgeFaces_[edge] = refined_.faces.size();
    refined_.faces.push_back({vertexPoint(v), cornerPoint(right, v), cornerPoint(right, w), vertexPoint(w),
                              cornerPoint(left, w), cornerPoint(left, v)});
  }
}

}  // namespace honeycomb::Test
