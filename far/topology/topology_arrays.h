#pragma once

#include <cstdint>
#include <vector>

#include "far/base/array.h"

namespace honeycomb::Far {

/// How a face was cut by a boundary rule. The brick rule cuts faces in half by the boundary line, or to a corner of the
/// boundary. The clamped rule of half-box splines ends the surface in faces whose boundary vertices are Bezier points
/// of the boundary curve: sides, corners, and the triangles in the gaps between two of these.
enum class FaceKind : std::uint8_t {
  full,
  half,
  corner,
  clampedSide,    ///< loop L, R, q_1 .. q_m: the curve passes smoothly through the middle of L and R
  clampedCorner,  ///< loop L, J, R, q_1 .. q_m: the curve has a corner at J
  clampedGap      ///< loop R, L of the next face along the boundary, q_1 of this face and q_m of the next
};
/// How many kinds there are.
constexpr std::size_t kFaceKinds = 6;
/// Has it been cut by the brick rule?
constexpr bool isCutByBrick(FaceKind kind) {
  return kind == FaceKind::half || kind == FaceKind::corner;
}
/// Is it one of a clamped boundary?
constexpr bool isClamped(FaceKind kind) {
  return kind != FaceKind::full && !isCutByBrick(kind);
}

/// What a face of a refined level was made from.
enum class FaceParent : std::uint8_t { face, vertex, edge };

/// Where a boundary vertex sits under the brick rule: a vertex of the mesh proper, the point where an edge crosses the
/// boundary line, a vertex tagged to become a corner, or a corner that stays where it is.
enum class VertexTag : std::uint8_t { interior, real, mid, corner, fixedCorner };

/// What a boundary half-edge is under the brick rule: an edge of the mesh on the boundary line, a cut through a face,
/// or the part of a cut between a fixed corner and the next vertex.
enum class EdgeTag : std::uint8_t { onLine, cut, cutToCorner };

/// A run of faces of one kind, parent and number of sides: contiguous in faces and in half-edges.
///     face       firstFace          firstFace+1         ...
///     half-edge  firstHalfEdge ..   firstHalfEdge+sides ..
struct FaceRun {
  FaceKind kind = FaceKind::full;
  FaceParent parent = FaceParent::face;
  std::int32_t sides = 0;
  std::int32_t firstFace = 0;
  std::int32_t firstHalfEdge = 0;
  std::int32_t faceCount = 0;
  bool operator==(const FaceRun&) const = default;
};

/// An edge along which a level is sharp. At level 0, where it is an edge like others, its two half-edges; refined
/// levels are cut open along their creases, and these are the half-edges on the two sides of the cut.
struct CreaseEdge {
  std::int32_t halfEdge = 0;  ///< the lower of the two
  std::int32_t mate = 0;
  double sharpness = 0;  ///< steps for which it stays sharp, from this level on; infinity: for all
  bool operator==(const CreaseEdge&) const = default;
};

/// What follows from the loops of a level's faces: how they hang together.
struct HalfEdgeLinks {
  Array<std::int32_t> twin;      ///< per half-edge: the opposite half-edge, -1 on a boundary
  Array<std::int32_t> face;      ///< per half-edge: its face
  Array<std::int32_t> outgoing;  ///< per vertex: a half-edge leaving it; on a boundary the boundary one
};

struct TopologyArrays;
/// Finds the links of a level from its loops; linear.
using LinkRule = HalfEdgeLinks (*)(const TopologyArrays& loops);

/// The arrays of one level, as a split hands them over; Topology only reads them afterwards.
struct TopologyArrays : HalfEdgeLinks {
  /// Of splits that leave the links out: how to find them when they are asked for, from the other arrays.
  LinkRule linkRule = nullptr;
  std::int32_t vertexCount = 0;
  bool threeValent = false;               ///< closed, and every vertex has three edges
  std::vector<FaceRun> runs;              ///< cover all faces in order; full faces first
  Array<std::int32_t> vert;               ///< per half-edge: the vertex it leaves
  Array<std::int32_t> faceOffsets;        ///< per face (+1): its first half-edge
  Array<std::int32_t> parents;            ///< per face: the face, vertex or edge (its lower half-edge) of the level
                                          ///< before that it was made from (the run says which); level 0: input face
  std::vector<std::int32_t> boundary;     ///< the boundary half-edges, ascending
  std::vector<EdgeTag> boundaryTags;      ///< one each
  std::vector<VertexTag> vertexTags;      ///< per vertex; empty when nothing is on a boundary
  std::vector<CreaseEdge> creases;        ///< ascending by half-edge, sharpness > 0
  std::vector<std::int32_t> heldCorners;  ///< with creases: the vertices that the caller tagged corners, ascending
};

}  // namespace honeycomb::Far
