#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "far/base/array.h"
#include "far/base/result.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

struct LevelTable;

/// What a point is that is not the corner point of a whole face.
enum class PointKind : std::uint8_t {
  halfFaceCorner,    ///< corner point of a face cut in half; halfEdge: the corner's
  cornerFaceCorner,  ///< corner point of a face at a fixed corner; halfEdge: the corner's
  edgeMiddle,        ///< middle of an edge; halfEdge: that edge
  edgeStart,         ///< point of an edge near its start; halfEdge: that edge
  edgeEnd,           ///< point of an edge near its end; halfEdge: that edge
  vertexPoint,       ///< new place of a vertex; halfEdge: one that leaves it, on a boundary the boundary one
  cutStart,          ///< the point of a cut next to its start; halfEdge: the cut
  cutEnd,            ///< the point of a cut next to its end; halfEdge: the cut
  fixedCorner,       ///< a corner that stays; halfEdge: the boundary half-edge leaving the vertex
  faceCentre,        ///< point of a face as a whole; halfEdge: the face's first
  boundaryVertex,    ///< eq16's new point of a boundary vertex; halfEdge: the boundary half-edge leaving it
  besideEdge         ///< point inside a face next to one of its edges; halfEdge: that edge's in the face
};
/// A point of the next level by what it is made from.
struct NewPoint {
  PointKind kind;
  std::int32_t halfEdge;  ///< of the parent level
};

/// The next level of connectivity and what its vertices are. The corner points of whole faces come first, in the order
/// of the half-edges of the new level's whole face-faces, so that such a face's new points have contiguous numbers.
///     vertices  0 .. cornerPoints-1            corner points; vertex id = half-edge id in the new level
///               cornerPoints + i               otherPoints[i]
struct SplitResult {
  Topology topology;
  std::int32_t cornerPoints = 0;
  Array<NewPoint> otherPoints;
  /// Of splits that bring their stencils along, as those of other libraries do: how to get the new points. Then the
  /// level's vertices are its targets, and cornerPoints and otherPoints say nothing of them.
  std::shared_ptr<const LevelTable> table = {};
};

/// The numbers of a level that the counts of the next follow from.
struct Census {
  std::int64_t vertices = 0, edges = 0, faces = 0, halfEdges = 0, boundaryEdges = 0;
  std::int64_t real = 0, mid = 0, corner = 0, fixedCorner = 0;  ///< boundary vertices by VertexTag
  std::int64_t onLine = 0, cutReal = 0, cutMid = 0, tipReal = 0,
               tipMid = 0;  ///< boundary edges by tag and by their ends
  std::int64_t gaps = 0;    ///< faces of kind clampedGap
  bool exact = true;        ///< false: upper bounds
};
/// Counts them. Linear in boundary edges.
Census takeCensus(const Topology& topology);

/// Edges with a face on either side; at most so many where the counts are bounds.
inline std::int64_t insideEdges(const Census& census) {
  return census.exact ? census.edges - census.boundaryEdges : census.halfEdges / 2;
}

/// Where in a face the new point of a half-edge lies: beside the half-edge, or in the corner where it starts.
enum class CornerPlace : std::uint8_t { corner, edge };

/// A rule of refinement for connectivity: slots of index algebra in one file of far/topology/splits.
struct Split {
  std::string name;
  /// Fails with tooLarge when the next level would pass 2^31 - 1 half-edges.
  std::function<Result<SplitResult>(const Topology& parent)> apply;
  /// The census of the next level.
  std::function<Census(const Census& parent)> grow;
  CornerPlace cornerPlace = CornerPlace::corner;
  /// On closed meshes the links are left for when they are asked for (TopologyArrays::linkRule).
  bool laterLinks = false;
};

}  // namespace honeycomb::Far
