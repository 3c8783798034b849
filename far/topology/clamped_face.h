#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "far/topology/topology.h"

namespace honeycomb::Far {

/// A side (L, R, q_0 .. q_{m-1}) or corner (L, J, R, q_0 .. q_{m-1}) of a clamped boundary: see FaceKind.
class ClampedFace {
 public:
  ClampedFace(const Topology& topology, std::int32_t f)
      : topology_(topology),
        first_(topology.faceOffsets()[static_cast<std::size_t>(f)]),
        sides_(topology.sides(f)),
        corner_(topology.run(f).kind == FaceKind::clampedCorner) {}

  bool isCorner() const { return corner_; }
  std::int32_t left() const { return topology_.vert(first_); }
  std::int32_t right() const { return topology_.vert(first_ + (corner_ ? 2 : 1)); }
  /// Of a corner; a side's J is the middle of L and R.
  std::int32_t joint() const { return topology_.vert(first_ + 1); }
  /// m, and the vertices inside.
  std::int32_t insideCount() const { return sides_ - (corner_ ? 3 : 2); }
  std::int32_t inside(std::int32_t i) const { return topology_.vert(firstInside() + i); }
  /// The i of the half-edge that leaves q_i.
  std::int32_t place(std::int32_t h) const { return h - firstInside(); }
  /// The boundary vertices beyond the gaps: R of the face before this one along the boundary, L of the one after.
  std::int32_t rightBefore() const { return topology_.vert(topology_.twin(first_ + sides_ - 1) - 1); }
  std::int32_t leftAfter() const { return topology_.vert(topology_.twin(firstInside() - 1) - 1); }

 private:
  std::int32_t firstInside() const { return first_ + (corner_ ? 3 : 2); }

  const Topology& topology_;
  std::int32_t first_;
  std::int32_t sides_;
  bool corner_;
};

/// The boundary half-edges of a gap are its first, from R of the face before it to L of the face behind it.
inline std::int32_t faceBeforeGap(const Topology& topology, std::int32_t h) {
  return topology.face(topology.twin(h + 2));
}
inline std::int32_t faceAfterGap(const Topology& topology, std::int32_t h) {
  return topology.face(topology.twin(h + 1));
}

/// Where the line through q_i and its mirror image in the completed polygon of 2m corners meets the boundary: at
/// (1 - |c|) J + |c| h with h the middle of R and L of the next face for c > 0, of L and R of the face before for
/// c < 0. 0 <= i < m, m > 1 (a side comes of a face of 2m sides).
inline double clampedMirrorCosine(std::int32_t i, std::int32_t m) {
  const double half = std::numbers::pi / (2 * m);
  return std::cos(half * (2 * i + 1)) / std::cos(half);
}

/// Sums over the i with c = clampedMirrorCosine(i, m) > 0, in closed form; over those with c < 0, of -c, they are the
/// same but for the sign of `cosine`. t = pi (2i+1)/(2m). m > 1.
struct ClampedMirrorSums {
  double plain = 0;   ///< of c
  double cosine = 0;  ///< of c cos t
  double sine = 0;    ///< of c sin t
};
inline ClampedMirrorSums clampedMirrorSums(std::int32_t m) {
  const double step = std::numbers::pi / m;
  const std::int32_t positive = m / 2;
  const double sine = std::sin(positive * step);
  const double scale = 1 / std::cos(step / 2);
  return {sine / std::sin(step), scale * (positive / 2.0 + std::sin(2 * positive * step) / (4 * std::sin(step))),
          scale * sine * sine / (2 * std::sin(step))};
}

/// A corner of 60 degrees an inside vertex, as in a honeycomb; the corners with more than five, which no honeycomb has,
/// take the angles of a face with two sides more.
inline std::int32_t clampedCornerPolygon(std::int32_t m) {
  return m <= 5 ? 6 : m + 2;
}

}  // namespace honeycomb::Far
