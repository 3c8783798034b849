#pragma once

#include <string>
#include <vector>

#include "far/tables/refinement.h"
#include "tests/support/poly_mesh.h"
#include "tests/support/random_mesh.h"

namespace honeycomb::Test {

/// The topology of a sound mesh with creases, and its refinement; throws what the error says otherwise.
Far::Topology creased(const PolyMesh& mesh, const std::vector<Far::Crease>& creases,
                      const std::vector<std::size_t>& cornerTags = {});
Far::Refinement refinedBy(const Far::Topology& control, const std::vector<Far::Scheme>& chain, bool limits = false);

/// The edges round face f, and all edges, of that sharpness.
std::vector<Far::Crease> creasesRound(const PolyMesh& mesh, std::size_t f, double sharpness);
std::vector<Far::Crease> creasesEverywhere(const PolyMesh& mesh, double sharpness);

/// Meshes with a closed crease, one that ends inside the mesh twice, creases on all edges, and on an open mesh creases
/// that meet in a vertex and at the border.
struct CreasedMesh {
  std::string name;
  PolyMesh mesh;
  std::vector<Far::Crease> creases;
};
std::vector<CreasedMesh> creasedMeshes(double sharpness);

/// Creases that all end at one large face or vertex: the posts of a prism of n sides, every second spoke of a wheel.
std::vector<CreasedMesh> meetingCreases(std::size_t n, double sharpness);

/// The mesh with face f standing alone, on copies of its vertices.
PolyMesh detached(PolyMesh mesh, std::size_t f);

/// Random edges of a random mesh, with sharpness among `values`, of each its own or the same for all.
Far::Topology randomlyCreased(const RandomMesh& random, Random& choice, const std::vector<double>& values);

/// What parts the two sides of the level's creases: empty when they have the same points, bit for bit.
std::string sidesDiffer(const Far::Level& level, const std::vector<Vec3>& points);

}  // namespace honeycomb::Test
