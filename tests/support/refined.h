#pragma once

#include <string>
#include <vector>

#include "far/tables/refinement.h"
#include "tests/support/poly_mesh.h"
#include "tests/support/random_mesh.h"
#include "tests/support/reference_zip.h"

namespace honeycomb::Test {

/// Akleman's scheme, once for the product and once for the tests' own implementation.
struct SchemeCase {
  std::string name;
  Far::Scheme scheme;
  ReferenceOptions reference;
};

enum class NamedTension { paper, sqrt3 };
SchemeCase schemeCase(NamedTension tension, ReferenceBoundary boundary = ReferenceBoundary::brick,
                      double edgeParameter = 0.5, double boundaryWeight = 0.25);
SchemeCase schemeCase(double tension, ReferenceBoundary boundary = ReferenceBoundary::brick, double edgeParameter = 0.5,
                      double boundaryWeight = 0.25);

/// The scheme of a folder of golden meshes: akleman, akleman-sqrt3, akleman-a0.6-t0.25, -eq16, -drop, -brick-corners.
SchemeCase goldenScheme(const std::string& folder);

Far::Polygons toPolygons(const PolyMesh& mesh, const std::vector<std::size_t>& cornerTags = {});
/// The topology of a mesh that must be sound; throws what the error says otherwise, which fails the test.
Far::Topology toTopology(const PolyMesh& mesh, const std::vector<std::size_t>& cornerTags = {});
Far::Refinement refined(const PolyMesh& mesh, const Far::Scheme& scheme, std::int32_t levels,
                        const std::vector<std::size_t>& cornerTags = {}, bool limits = false);
inline Far::Refinement refined(const RandomMesh& random, const Far::Scheme& scheme, std::int32_t levels,
                               bool limits = false) {
  return refined(random.mesh, scheme, levels, random.cornerTags, limits);
}

/// x y z of each point, one after the other.
template <class Real>
std::vector<Real> pack(const std::vector<Vec3>& points);
template <class Real>
std::vector<Vec3> unpack(const std::vector<Real>& numbers);

/// The points of a level (vertices, then central control vertices where it has them), by the serial evaluator in
/// `Real`.
template <class Real>
std::vector<Vec3> levelPoints(const Far::Refinement& refinement, std::int32_t level, const std::vector<Vec3>& control);

/// The loops of a topology, with the given points.
PolyMesh toMesh(const Far::Topology& topology, std::vector<Vec3> points);

/// Level `level` of a refinement in double, and of the tests' own implementation.
PolyMesh levelMesh(const Far::Refinement& refinement, std::int32_t level, const std::vector<Vec3>& control);
ReferenceMesh referenceLevel(const PolyMesh& mesh, const std::vector<std::size_t>& cornerTags,
                             const ReferenceOptions& options, std::int32_t level);

/// Limit positions and normals of the faces (vertices) of the refinement's last level, from that level's points.
struct Limits {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
};
template <class Real>
Limits faceLimits(const Far::Refinement& refinement, const std::vector<Vec3>& points);
template <class Real>
Limits vertexLimits(const Far::Refinement& refinement, const std::vector<Vec3>& points);

}  // namespace honeycomb::Test
