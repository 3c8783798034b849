#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "far/topology/polygons.h"

namespace honeycomb::Far {

/// The ways in which polygons can fail to be an oriented manifold, in the order in which they are looked for.
enum class DefectKind {
  indexOutOfRange,      ///< a corner names a vertex that isn't there
  tooFewSides,          ///< a face with fewer than three corners
  repeatedVertex,       ///< a vertex twice in one face
  edgeOverused,         ///< more than two faces on one edge
  opposedFaces,         ///< two faces run along an edge in the same direction
  bowTie,               ///< the faces at a vertex form more than one fan
  isolatedVertex,       ///< a vertex in no face
  cornerNotOnBoundary,  ///< a corner tag on a vertex that is neither on a boundary nor on a crease
  creaseSharpness,      ///< a crease whose sharpness is negative or not a number
  creaseConflict,       ///< an edge that has two creases of different sharpness
  creaseWithoutEdge     ///< a crease between vertices that no edge joins
};

/// One defect, in the caller's face and vertex numbers; -1 where a number has no meaning.
struct Defect {
  DefectKind kind;
  std::int64_t face = -1;       ///< the offending face; for an edge, the first face that makes it wrong
  std::int64_t vertex = -1;     ///< the offending vertex; for an edge, one end
  std::int64_t vertex2 = -1;    ///< the other end of the edge
  std::int64_t otherFace = -1;  ///< for an edge: the first face on it
};

/// Every defect of the polygons, ordered by kind (the order of DefectKind), then by face or vertex. Empty: a manifold.
/// Edges are examined between the faces that are sound in themselves; vertices when no edge is wrong at them.
std::vector<Defect> findDefects(const Polygons& polygons);

/// "face 12 names vertex 5 twice" and the like, with 0-based numbers, without a full stop.
std::string describe(const Defect& defect);

/// What the owner of the mesh can do about it: "remove the duplicate corner", ...
std::string_view remedy(DefectKind kind);

/// How many faces each vertex is in; corners whose vertex is out of range are passed over. Linear.
std::vector<std::int32_t> cornersPerVertex(const Polygons& polygons);

}  // namespace honeycomb::Far
