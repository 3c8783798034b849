#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/base/array.h"
#include "far/topology/defects.h"
#include "far/topology/polygons.h"

namespace honeycomb::Far {

/// The corners of polygons as half-edges in the caller's order: corner c of face f runs to the next corner of f.
struct EdgeMatching {
  std::vector<std::int32_t> twin;  ///< per corner: the opposite corner; kBoundary or kBroken
  std::vector<Defect> defects;     ///< edges with more than two faces, or two that run the same way
  static constexpr std::int32_t kBoundary = -1;
  static constexpr std::int32_t kBroken = -2;  ///< on a face or an edge with a defect
};

/// The face of each corner.
std::vector<std::int32_t> cornerFaces(const Polygons& polygons);

/// Pairs the corners of the faces that are sound (sound[f] != 0): the one place of the project that has to sort.
/// Linear in corners and vertices but for a sort within the edges of each vertex.
EdgeMatching matchEdges(const Polygons& polygons, std::span<const std::int32_t> cornerFace,
                        std::span<const std::uint8_t> sound);

/// Per vertex: its lowest corner, or its lowest boundary corner if it has one; -1 for a vertex in no face.
Array<std::int32_t> outgoingCorners(std::span<const std::int32_t> vert, std::span<const std::int32_t> twin,
                                    std::int32_t vertexCount);

/// Everything findDefects and Topology::create share.
struct Inspection {
  EdgeMatching edges;
  std::vector<std::int32_t> cornerFace;
  std::vector<Defect> defects;
};
/// Matches half-edges to twins and looks for every defect. Linear, save a sort within the corners of each vertex.
Inspection inspect(const Polygons& polygons);

}  // namespace honeycomb::Far
