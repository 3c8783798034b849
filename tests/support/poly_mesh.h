#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace honeycomb::Test {

using Vec3 = std::array<double, 3>;
using Loop = std::vector<std::size_t>;

/// A polygon mesh as plain lists, counter-clockwise loops: what the tests' own code works on, apart from the product's
/// types.
struct PolyMesh {
  std::vector<Vec3> points;
  std::vector<Loop> faces;
};

/// container[i] for an index of any integer type.
template <class Container, std::integral Index>
decltype(auto) at(Container&& container, Index i) {
  return container[static_cast<std::size_t>(i)];
}

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 operator*(double s, const Vec3& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vec3& a);
double distance(const Vec3& a, const Vec3& b);
Vec3 unit(const Vec3& a);
Vec3 centroid(const std::vector<Vec3>& points);

/// T1 x T2 of a polygon, T1 + i T2 = sum_k p_k exp(2 pi i k/N); not normalised.
Vec3 tangentNormal(const std::vector<Vec3>& polygon);

/// The corner points of face f.
std::vector<Vec3> corners(const PolyMesh& mesh, std::size_t f);

}  // namespace honeycomb::Test
