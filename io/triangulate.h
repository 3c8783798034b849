#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace honeycomb::Io {

/// Faces of more sides are cut to and fro across, which is right for convex ones only: ears cost sides^2.
constexpr std::int32_t kMostEarSides = 256;

/// Cuts polygons into triangles, for formats that have nothing else: three corners (positions in `faceVertices`) each,
/// 3 (sides - 2) a face, in the order of the faces and with their orientation. A face is cut ear by ear, in the plane
/// of its mean normal: each time where the cut is shortest among those that stay inside, so that concave cells are
/// covered once and hexagons fall into the triangles nearest to equilateral ones. Where no cut stays inside (a face
/// that crosses itself) the bluntest corner is taken. `positions`: x y z a vertex. Parallel over faces.
std::vector<std::int32_t> triangulate(std::span<const std::int32_t> faceOffsets,
                                      std::span<const std::int32_t> faceVertices, std::span<const float> positions);

}  // namespace honeycomb::Io
