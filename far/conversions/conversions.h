#pragma once

#include <cstdint>

#include "far/base/result.h"
#include "far/conversions/conversion.h"
#include "far/topology/topology.h"

/// Meshes made from meshes. All take a topology of level 0, number vertices and faces of the result in the caller's
/// order unless they say otherwise, and say of every vertex which source vertices it is made of, so that any primvar
/// comes along (see apply). Errors of all: tooLarge past 2^31 - 1 vertices or corners; others as stated, with a vertex
/// or face as element where one is meant.
namespace honeycomb::Far {

/// The dual: a vertex for each face, at the mean of its corners, in the caller's order of faces; a face for each vertex
/// inside the mesh, of the faces round it counter-clockwise. Vertices on a boundary make no face, and faces whose
/// vertices are all on a boundary no vertex.
/// Errors: invalidMesh when an inside vertex has fewer than three faces or nothing is left.
Result<Conversion> dual(const Topology& topology);

/// Where truncate() cuts edges unless it is told.
constexpr double kThird = 1.0 / 3;

/// All corners cut off: a vertex near each end of each edge, `ratio` along the edge from that end, so that a face has
/// twice its sides and a vertex becomes a face;
/// one step of trisect(). On a boundary a vertex of two or more faces becomes a face closed by a boundary edge; a
/// vertex of one face is cut off. 2E vertices, three-valent inside; numbered as the step numbers them. Errors:
/// invalidOption unless 0 < ratio < 1/2; invalidMesh when an inside vertex has fewer than three faces.
Result<Conversion> truncate(const Topology& topology, double ratio = kThird);

/// All faces cut into triangles from their centre: the vertices of the mesh, then the mean of the corners of each face;
/// a triangle (origin, destination, centre) for each half-edge. V + F vertices, H triangles.
Result<Conversion> triangulate(const Topology& topology);

/// All faces cut into quads from their centre: the vertices of the mesh, then the mean c of the corners of each face;
/// quads (c, v_2i, v_2i+1, v_2i+2) and, where the number of sides n is odd, a last triangle (c, v_n-1, v_0). Meant for
/// meshes of even sides, such as those after two honeycomb steps. (Zhang and Wang, "Honeycomb Subdivision", section
/// 4.4, print "every vertex"; joining every second vertex to the centre is what gives quads.)
Result<Conversion> quads(const Topology& topology);

/// The best three-valent mesh for any input, three edges at each vertex inside and two or three on a boundary:
///     the mesh itself      where it is three-valent already
///     its dual             where all faces are triangles (Barendrecht, Sabin and Kosinka, "A bivariate C1 subdivision
///                          scheme based on cubic half-box splines"); a boundary loses its outer ring of triangles
///     one step of Akleman and Srinivasan, "Honeycomb Subdivision", with the brick boundary, otherwise; also for
///                          triangles whose dual has no faces or a face of two sides
/// Faces of the step are in the order of the refined level: those of the faces first.
/// Errors: tooLarge also when the rows of the step would take more than kMaxRowEntries entries, as an N-gon takes N^2.
Result<Conversion> hexagonal(const Topology& topology);

/// 1.5 GiB of rows; a closed mesh of quads has this many at 33 million vertices, a polygon at 11,500 sides.
constexpr std::int64_t kMaxRowEntries = std::int64_t{1} << 27;

}  // namespace honeycomb::Far
