#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "far/topology/polygons.h"

namespace honeycomb::Bench {

/// A control mesh to measure with.
struct Mesh {
  std::string name;  ///< "torus", "shuffled torus", a file
  Far::Polygons polygons;
  std::vector<double> points;  ///< x y z per vertex
};

/// The smallest mesh torus() and mixed() make.
constexpr std::int64_t kFewestFaces = 16;

/// A closed torus of quads: `faces` of them where that number has two factors that are not far from each other, else up
/// to a row less. Linear.
Mesh torus(std::int64_t faces);

/// A closed torus of triangles, quads, pentagons and hexagons with vertices of valence 3 to 6, about `faces` of them.
/// The same on every machine. Linear.
Mesh mixed(std::int64_t faces);

/// The mesh with its vertices and faces numbered at random and every face's loop begun anywhere: the worst case for
/// caches. The same order for the same seed on every machine. Linear.
Mesh shuffled(const Mesh& mesh, std::uint64_t seed = 1);

}  // namespace honeycomb::Bench
