#include "io/triangulate.h"

#include <array>
#include <cmath>
#include <limits>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Io {
namespace {

struct PlanePoint {
  double x = 0, y = 0;
};

double cross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double squaredDistance(const PlanePoint& a, const PlanePoint& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// Newell's normal: twice the area, whatever the shape.
std::array<double, 3> meanNormal(std::span<const std::array<double, 3>> points) {
  std::array<double, 3> normal{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& a = points[i];
    const auto& b = points[(i + 1) % points.size()];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t y = (k + 1) % 3, z = (k + 2) % 3;
      normal[k] += (a[y] - b[y]) * (a[z] + b[z]);
    }
  }
  return normal;
}

/// The polygon in the plane of its mean normal, counterclockwise.
std::vector<PlanePoint> projected(std::span<const std::array<double, 3>> points) {
  const std::array<double, 3> normal = meanNormal(points);
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  if (length == 0) return std::vector<PlanePoint>(points.size());
  // Two axes at right angles to the normal: the first from the coordinate axis it is furthest from.
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(normal[k]) < std::abs(normal[least])) least = k;
  const std::size_t j = (least + 1) % 3, k = (least + 2) % 3;
  const double across = std::hypot(normal[j], normal[k]);
  std::array<double, 3> u{}, v{};
  u[j] = -normal[k] / across;
  u[k] = normal[j] / across;
  for (std::size_t i = 0; i < 3; ++i)
    v[i] = (normal[(i + 1) % 3] * u[(i + 2) % 3] - normal[(i + 2) % 3] * u[(i + 1) % 3]) / length;
  std::vector<PlanePoint> plane;
  plane.reserve(points.size());
  for (const auto& p : points)
    plane.push_back({p[0] * u[0] + p[1] * u[1] + p[2] * u[2], p[0] * v[0] + p[1] * v[1] + p[2] * v[2]});
  return plane;
}

/// What is left of a polygon, and its triangles so far.
class Ears {
 public:
  explicit Ears(std::vector<PlanePoint> points) : points_(std::move(points)) {
    for (std::size_t i = 0; i < points_.size(); ++i) left_.push_back(static_cast<std::int32_t>(i));
  }

  /// Corners of the triangles, numbered within the face.
  void cutInto(std::span<std::int32_t> triangles) {
    std::size_t next = 0;
    while (left_.size() > 3) {
      const std::size_t ear = best();
      for (const std::ptrdiff_t step : {-1, 0, 1}) triangles[next++] = corner(ear, step);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    for (const std::int32_t last : left_) triangles[next++] = last;
  }

 private:
  std::int32_t corner(std::size_t i, std::ptrdiff_t step) const {
    return left_[(i + left_.size() + static_cast<std::size_t>(step)) % left_.size()];
  }
  const PlanePoint& point(std::size_t i, std::ptrdiff_t step) const { return points_[at(corner(i, step))]; }

  bool staysInside(std::size_t i) const {
    const PlanePoint &a = point(i, -1), &b = point(i, 0), &c = point(i, 1);
    if (cross(a, b, c) <= 0) return false;
    for (std::size_t k = 2; k + 1 < left_.size(); ++k) {
      const PlanePoint& p = point(i, static_cast<std::ptrdiff_t>(k));
      if (cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0) return false;
    }
    return true;
  }
  std::size_t best() const {
    std::size_t shortest = left_.size(), bluntest = 0;
    double length = std::numeric_limits<double>::infinity(), most = -length;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const double turn = cross(point(i, -1), point(i, 0), point(i, 1));
      if (turn > most) {
        most = turn;
        bluntest = i;
      }
      const double cut = squaredDistance(point(i, -1), point(i, 1));
      if (cut >= length || !staysInside(i)) continue;
      length = cut;
      shortest = i;
    }
    return shortest < left_.size() ? shortest : bluntest;
  }

  std::vector<PlanePoint> points_;
  std::vector<std::int32_t> left_;
};

/// 0 1 n-1, 1 n-2 n-1, 1 2 n-2, ..
void cutToAndFro(std::int32_t sides, std::span<std::int32_t> triangles) {
  std::int32_t low = 0, high = sides - 1;
  for (std::size_t next = 0; next < triangles.size(); next += 3) {
    const bool lower = next % 2 == 0;
    const std::array corners{low, lower ? low + 1 : high - 1, high};
    for (std::size_t k = 0; k < 3; ++k) triangles[next + k] = corners[k];
    (lower ? low : high) += lower ? 1 : -1;
  }
}

void triangulateFace(std::span<const std::int32_t> vertices, std::span<const float> positions,
                     std::span<std::int32_t> triangles) {
  const auto sides = static_cast<std::int32_t>(vertices.size());
  if (sides > kMostEarSides || sides == 3) return cutToAndFro(sides, triangles);
  std::vector<std::array<double, 3>> points;
  points.reserve(vertices.size());
  for (const std::int32_t v : vertices)
    points.push_back({positions[3 * at(v)], positions[3 * at(v) + 1], positions[3 * at(v) + 2]});
  Ears(projected(points)).cutInto(triangles);
}

}  // namespace

std::vector<std::int32_t> triangulate(std::span<const std::int32_t> faceOffsets,
                                      std::span<const std::int32_t> faceVertices, std::span<const float> positions) {
  const auto faces = std::ssize(faceOffsets) - 1;
  std::vector<std::int32_t> corners(3 * at(faceOffsets[at(faces)] - 2 * faces));
  Parallel::forEach(
      0, faces,
      [&](std::int64_t f) {
        const std::int32_t first = faceOffsets[at(f)], sides = faceOffsets[at(f + 1)] - first;
        const auto triangles = std::span(corners).subspan(3 * at(first - 2 * f), 3 * at(sides - 2));
        triangulateFace(faceVertices.subspan(at(first), at(sides)), positions, triangles);
        for (std::int32_t& corner : triangles) corner += first;
      },
      256);
  return corners;
}

}  // namespace honeycomb::Io
