#pragma once

#include "tests/support/poly_mesh.h"

namespace honeycomb::Test {

PolyMesh tetrahedron();
PolyMesh cube();
PolyMesh dodecahedron();
/// Two n-gons and n quads: 2n vertices.
PolyMesh prism(std::size_t sides);
/// m x n quads.
PolyMesh torus(std::size_t m, std::size_t n);
/// m x n quads of a square lattice, open.
PolyMesh grid(std::size_t m, std::size_t n);
/// n triangles round one vertex, open: a wheel.
PolyMesh wheel(std::size_t n);
/// n vertices on a circle, with one face on each side: every vertex has valence 2.
PolyMesh pillow(std::size_t n);
/// A boundary vertex (0) with n triangles: a fan over an arc.
PolyMesh fan(std::size_t n);

/// n x n regular hexagons with sides of length 1, open.
PolyMesh honeycomb(std::size_t n);

/// Adds a part that shares nothing with the mesh.
void append(PolyMesh& mesh, const PolyMesh& part);

}  // namespace honeycomb::Test
