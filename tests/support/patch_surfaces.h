#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "far/tables/patch_table.h"
#include "tests/support/poly_mesh.h"
#include "tests/support/refined.h"
#include "tests/support/table_rows.h"

namespace honeycomb::Test {

/// Three-valent meshes with random points: shapes whose patches meet few vertices many times, two faces with two edges
/// in common, a patch of honeycomb, pentagons apart among hexagons, and random ones, closed and open.
constexpr std::size_t kThreeValentMeshes = 11;
constexpr std::size_t kHoneycombMesh = 5;
PolyMesh threeValentMesh(std::size_t number);

/// Two hexagons with two edges in common, closed by four triangles: a sphere.
PolyMesh doubleBridge();

/// The half-box limit surface of a mesh, by the product.
struct PatchSurface {
  /// The mesh must be three-valent; throws what the error says otherwise.
  explicit PatchSurface(PolyMesh mesh);

  Far::PatchPoint at(std::int32_t patch, const Far::Barycentric& u) const;
  std::vector<double> bezierPoints() const;
  /// Weights on the points of a patch, applied.
  Vec3 weighted(std::int32_t patch, const std::vector<double>& weights) const;

  std::size_t inputFace(std::int32_t face) const;
  /// The corner of a patch that lies in a face, by the topology's number and by the mesh's.
  std::size_t cornerIn(std::int32_t patch, std::int32_t face) const;
  std::size_t cornerInFace(std::int32_t patch, std::size_t meshFace) const;
  /// The loop of a face of the topology, from the mesh's own lists, starting at a vertex; and its points.
  Loop loopFrom(std::int32_t face, std::int32_t vertex) const;
  std::vector<Vec3> polygonFrom(std::int32_t face, std::int32_t vertex) const;

  PolyMesh mesh;
  std::vector<double> packed;
  Far::PatchTable table;
};

/// The derivative along J_to - J_from, of corners of the patch.
Vec3 along(const Far::PatchPoint& point, std::size_t to, std::size_t from);

/// A cubic by its ten Bezier points (patch r of them) and the Bernstein polynomials, term by term.
Vec3 bernstein(const std::vector<double>& bezier, std::size_t r, const Far::Barycentric& u);

/// One step of Barendrecht, Sabin and Kosinka's scheme on plain polygons, with the natural boundary. The faces are the
/// mesh's, then a hexagon for each inside edge with at least one end of three edges.
class HalfBoxStep {
 public:
  explicit HalfBoxStep(const PolyMesh& mesh);

  const PolyMesh& mesh() const { return refined_; }
  /// The new vertex of a face at one of its vertices, and that of a vertex with three edges.
  std::size_t cornerPoint(std::size_t face, std::size_t vertex) const { return cornerPoints_.at({face, vertex}); }
  std::size_t vertexPoint(std::size_t vertex) const { return vertexPoints_.at(vertex); }
  /// The face of the edge between two vertices.
  template <class Index>
  std::size_t edgeFace(std::size_t a, Index b) const {
    const auto other = static_cast<std::size_t>(b);
    return edgeFaces_.at(std::minmax(a, other));
  }

 private:
  void addCornerPoints(const PolyMesh& mesh);
  void addVertexPoints(const PolyMesh& mesh);
  void addEdgeFaces(const PolyMesh& mesh);

  PolyMesh refined_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> cornerPoints_;
  std::map<std::size_t, std::size_t> vertexPoints_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> edgeFaces_;
};

}  // namespace honeycomb::Test
