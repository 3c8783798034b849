#include "tests/support/poly_mesh.h"

#include <cmath>
#include <numbers>

namespace honeycomb::Test {

double length(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

double distance(const Vec3& a, const Vec3& b) {
  return length(a - b);
}

Vec3 unit(const Vec3& a) {
  return (1 / length(a)) * a;
}

Vec3 centroid(const std::vector<Vec3>& points) {
  Vec3 sum{};
  for (const Vec3& p : points) sum = sum + p;
  return (1 / static_cast<double>(points.size())) * sum;
}

Vec3 tangentNormal(const std::vector<Vec3>& polygon) {
  Vec3 t1{};
  Vec3 t2{};
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(polygon.size());
    t1 = t1 + std::cos(angle) * polygon[k];
    t2 = t2 + std::sin(angle) * polygon[k];
  }
  return cross(t1, t2);
}

std::vector<Vec3> corners(const PolyMesh& mesh, std::size_t f) {
  std::vector<Vec3> result;
  result.reserve(mesh.faces[f].size());
  for (const std::size_t v : mesh.faces[f]) result.push_back(mesh.points[v]);
  return result;
}

}  // namespace honeycomb::Test
