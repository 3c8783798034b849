#pragma once

#include "far/base/result.h"
#include "far/conversions/conversion.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// The inverse dual of a closed mesh of triangles: the three-valent mesh whose limit surface passes through the
/// triangle mesh's vertices (P. Barendrecht, M. Sabin, J. Kosinka, "A bivariate C1 subdivision scheme based on cubic
/// half-box splines", section 5.3). The limit of an n-gon is its centroid, so the centroid of the face that a vertex
/// becomes has to be the vertex. With N the 0/1 matrix of which triangle touches which vertex, D the valences,
/// A = D^-1 N the matrix of means round the vertices, p the vertices and d0 the geometric dual (the triangles'
/// centres), the answer is d0 with the smallest correction in the sense of least squares:
///     d = d0 + A^T (A A^T)^-1 (p - A d0) = d0 + N^T z,   (N N^T) z = D (p - A d0)
/// N N^T has the valences on its diagonal and a 2 for each edge; it is factorised once for each call of apply().
///
/// It has no inverse where a function x on the vertices, not all 0, sums to 0 over every triangle. Then on each side of
/// an edge the third vertices have the same x, so x depends on a vertex's colour alone as three colours are carried
/// from triangle to triangle: two such functions where the vertices can be coloured with three colours (the octahedron,
/// and any mesh of even valences on a sphere), one where one colour can be told apart from the other two (double
/// pyramids over polygons of odd sides), else none. With them there is a solution only if sum_v n_v x_v p_v = 0, n_v
/// the valence: for three colours, if the sums of valence times position over each of the colours are equal, as in the
/// regular octahedron; then the smallest correction is taken all the same.
///
/// Rows of the result are those of the geometric dual; the correction is solved for by apply(), for each of the
/// `length` numbers of a vertex on its own, so primvars interpolate as positions do, with errors of its own:
/// invalidPositions when there is no solution (by more than 1e-9 of the values' extent), or the values aren't finite.
///
/// Errors: invalidMesh for a face that isn't a triangle, a boundary (a vertex there has no closed face whose limit
/// could be the vertex, and the paper leaves boundaries to future work), a vertex with two triangles round it.
Result<Conversion> inverseDual(const Topology& topology);

}  // namespace honeycomb::Far
