#pragma once

#include <functional>
#include <map>
#include <vector>

#include "tests/support/poly_mesh.h"

namespace honeycomb::Test {

enum class ReferenceBoundary { brick, eq16, drop };

struct ReferenceOptions {
  std::function<double(std::size_t sides)> tension;  ///< a(N) of Akleman and Srinivasan
  double edgeParameter = 0.5;                        ///< t
  ReferenceBoundary boundary = ReferenceBoundary::brick;
  double boundaryWeight = 0.25;  ///< s of eq16
};

/// a(N) = 0.45 + 1.25/N.
double paperTension(std::size_t sides);
/// The tension that contracts every N-gon, N >= 4, by 1/sqrt 3 a step.
double sqrt3Tension(std::size_t sides);

/// c_0 .. c_{N-1} of Akleman and Srinivasan's equations 1 and 2.
std::vector<double> closedFormula(double tension, double edgeParameter, std::size_t sides);

/// What a face of a refined mesh was made from: face or vertex `id` of the mesh before.
struct ReferenceParent {
  bool vertex = false;
  std::size_t id = 0;
};

/// A mesh with the marks the brick rule needs on its boundary. Plain maps: clear and slow.
struct ReferenceMesh {
  enum class Point { real, mid, corner, fixedCorner };
  enum class Edge { onLine, cut, toCorner };
  using EdgeKey = std::pair<std::size_t, std::size_t>;

  PolyMesh mesh;
  std::vector<Point> points;      ///< of every vertex; read on the boundary only
  std::map<EdgeKey, Edge> edges;  ///< directed boundary edges, in the direction of their face
  std::vector<ReferenceParent> parents;
};

ReferenceMesh referenceStart(const PolyMesh& mesh, const std::vector<std::size_t>& cornerTags);

/// One step of the scheme, built polygon by polygon: the faces' faces, then the vertices' faces.
ReferenceMesh referenceZip(const ReferenceMesh& from, const ReferenceOptions& options);

}  // namespace honeycomb::Test
