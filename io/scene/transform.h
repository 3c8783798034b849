#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace honeycomb::Io {

using Vector3 = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  ///< w x y z

/// An affine map, three rows of four: p -> A p + b with b in the last column.
struct Transform {
  std::array<double, 12> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  Vector3 apply(const Vector3& p) const {
    Vector3 q;
    for (std::size_t r = 0; r < 3; ++r)
      q[r] = m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
    return q;
  }
  bool isFinite() const {
    bool finite = true;
    for (const double x : m) finite = finite && std::isfinite(x);
    return finite;
  }
  bool operator==(const Transform&) const = default;
};

/// First b, then a.
inline Transform operator*(const Transform& a, const Transform& b) {
  Transform c;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t k = 0; k < 4; ++k) {
      c.m[4 * r + k] = a.m[4 * r] * b.m[k] + a.m[4 * r + 1] * b.m[4 + k] + a.m[4 * r + 2] * b.m[8 + k];
    }
    c.m[4 * r + 3] += a.m[4 * r + 3];
  }
  return c;
}

/// The parts that animations move.
struct Placement {
  Vector3 translation{};
  Quaternion rotation{1, 0, 0, 0};  ///< of length 1
  Vector3 scale{1, 1, 1};

  Transform transform() const {
    const auto [w, x, y, z] = rotation;
    const std::array<double, 9> r{1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                                  2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                                  2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    Transform t;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < 3; ++k) t.m[4 * row + k] = r[3 * row + k] * scale[k];
      t.m[4 * row + 3] = translation[row];
    }
    return t;
  }
};

}  // namespace honeycomb::Io
