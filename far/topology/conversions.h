#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/topology/polygons.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// Another mesh made from a mesh, with where its vertices lie: vertex v of the result is the mean of the vertices
/// meanOf[meanOffsets[v]] .. meanOf[meanOffsets[v+1]-1] of the mesh it was made from, so any primvar can be carried
/// over.
struct Conversion {
  Polygons polygons;
  std::vector<std::int64_t> meanOffsets{0};
  std::vector<std::int32_t> meanOf;
};

/// The dual: a vertex for each face, at the mean of its corners, in the caller's order of faces; a face for each vertex
/// inside the mesh, of the faces round it counter-clockwise. Vertices on a boundary make no face, and faces whose
/// vertices are all on a boundary no vertex.
/// Errors: invalidMesh, with the vertex as element, when an inside vertex has fewer than three faces or nothing is
/// left.
Result<Conversion> dual(const Topology& topology);

/// All faces cut into triangles from their centre: the vertices of the mesh, then the mean of the corners of each face,
/// in the caller's order of faces; a triangle (origin, destination, centre) for each half-edge. V + F vertices,
/// H triangles. Errors: tooLarge past 2^31 - 1 vertices.
Result<Conversion> triangulate(const Topology& topology);

/// The means of `values`, `length` numbers a vertex, for every vertex of the result. Sums run in the order of meanOf.
std::vector<double> means(const Conversion& conversion, std::span<const double> values, std::int32_t length);

}  // namespace honeycomb::Far
