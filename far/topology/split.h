#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// What a point is that is not the corner point of a whole face.
enum class PointKind : std::uint8_t {
  halfFaceCorner,    ///< corner point of a face cut in half; halfEdge: the corner's
  cornerFaceCorner,  ///< corner point of a face at a fixed corner; halfEdge: the corner's
  edgeMiddle,        ///< middle of a boundary edge on the line; halfEdge: that edge
  cutStart,          ///< the point of a cut next to its start; halfEdge: the cut
  cutEnd,            ///< the point of a cut next to its end; halfEdge: the cut
  fixedCorner,       ///< a corner that stays; halfEdge: the boundary half-edge leaving the vertex
  boundaryVertex     ///< eq16's new point of a boundary vertex; halfEdge: the boundary half-edge leaving it
};
struct NewPoint {
  PointKind kind = PointKind::halfFaceCorner;
  std::int32_t halfEdge = 0;  ///< of the parent level
};

/// The next level of connectivity and what its vertices are. The corner points of whole faces come first, in the order
/// of the half-edges of the new level's whole face-faces, so that such a face's new points have contiguous numbers.
///     vertices  0 .. cornerPoints-1            corner points; vertex id = half-edge id in the new level
///               cornerPoints + i               otherPoints[i]
struct SplitResult {
  Topology topology;
  std::int32_t cornerPoints = 0;
  std::vector<NewPoint> otherPoints;
};

/// The numbers of a level that the counts of the next follow from.
struct Census {
  std::int64_t vertices = 0, edges = 0, faces = 0, halfEdges = 0, boundaryEdges = 0;
  std::int64_t real = 0, mid = 0, corner = 0, fixedCorner = 0;  ///< boundary vertices by VertexTag
  std::int64_t onLine = 0, cutReal = 0, cutMid = 0, tipReal = 0,
               tipMid = 0;  ///< boundary edges by tag and by their ends
  bool exact = true;        ///< false: upper bounds
};
Census takeCensus(const Topology& topology);

/// A rule of refinement for connectivity: slots of index algebra in one file of far/topology/splits.
struct Split {
  std::string name;
  /// Fails with tooLarge when the next level would pass 2^31 - 1 half-edges.
  std::function<Result<SplitResult>(const Topology& parent)> apply;
  /// The census of the next level.
  std::function<Census(const Census& parent)> grow;
};

}  // namespace honeycomb::Far
