#pragma once

#include "far/base/result.h"
#include "far/conversions/conversion.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

constexpr std::int32_t kMaxBrickRows = 1000;

/// The bricklayers' construct of E. Akleman and V. Srinivasan, "Honeycomb Subdivision" (section 4), against the bumps
/// that the sides of a prism get under honeycomb subdivision: the sides are laid in courses of hexagons, each course
/// offset by half a hexagon from the one below, and the hexagons at the rims are cut straight, which leaves pentagons.
/// Their figure isn't in the text; this is our reading of it.
///
/// It is laid on every tube of the mesh: closed rings of quads, one ring upon the other, between two caps, each one
/// polygon, faces that aren't quads, or nothing (see QuadTube; a prism is a tube of one ring). With `rows` courses a
/// ring, here one ring of three, b and a the vertices at its two rims:
///
///     line 3   a0-----------a1-----------a2---     rim
///              |            |            |         course 3: pentagons
///     line 2 --+-----+------+-----+------+----
///                    |            |                course 2: hexagons
///     line 1 --+-----+------+-----+------+----
///              |            |            |         course 1: pentagons
///     line 0   b0-----------b1-----------b2---     rim
///         slot 0     1      2     3      4
///
/// Rims and caps stay as they are; vertices inside a tube go. Line l of C = rings x rows has 2 x columns new vertices,
/// slot j at height l/rows in rings and at x = j/2 in columns on the quads' bilinear surfaces: a vertex has at most
/// four source vertices. Where C is even a straight last course would end between the columns of the upper rim: the
/// courses then lean evenly, by half a column from rim to rim (x = j/2 + l/2C). New vertices are three-valent; those of
/// a rim are too under a cap of one polygon or none, and keep the edges of their other faces else. One row on one ring
/// leaves it as it was.
///
/// Vertices: those that stay, in the caller's order, then the new ones, tube by tube, line by line. Faces: those
/// outside the tubes, in the caller's order, then the bricks, course by course, each from the quad that holds its
/// centre. Errors: invalidOption unless 1 <= rows <= kMaxBrickRows; invalidMesh when the mesh has no tube.
Result<Conversion> bricks(const Topology& topology, std::int32_t rows);

}  // namespace honeycomb::Far
