#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/tables/level_table.h"
#include "far/tables/vertex_patch.h"
#include "far/topology/polygons.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// A point of the surface: a patch and where in it.
struct PatchSample {
  std::int32_t patch = 0;
  Barycentric barycentric{};
};

/// Barycentric coordinates may lie this far outside the triangle: below zero each, and off 1 their sum.
constexpr double kBarycentricTolerance = 1e-12;

/// A point of the surface with its derivatives; see PatchDerivatives for the parameters u and v, and for what du and dv
/// are at an extraordinary corner.
struct PatchPoint {
  std::array<double, 3> position{}, du{}, dv{}, duu{}, duv{}, dvv{};
  std::array<double, 3> normal{};  ///< unit du x dv, outward; zero where du and dv are parallel
  bool extraordinaryCorner = false;
};

/// Samples as rows over the control points, that every evaluator applies: loose rows, and summed ones next to faces of
/// more than kLargestCirculant sides, so that N samples there take O(N).
struct LimitStencils {
  LevelTable positions;  ///< rows sum to 1
  LevelTable du, dv;     ///< rows sum to 0; the tangents T1, T2 at extraordinary corners
};

/// The limit surface cut into triangles: vertex i lies at samples[i].
struct Tessellation {
  Polygons polygons;
  std::vector<PatchSample> samples;
};
/// Pieces that an edge of a patch can be cut into.
constexpr std::int32_t kMostPieces = 64;

/// The limit surface of the half-box scheme of P. Barendrecht, M. Sabin, J. Kosinka, "A bivariate C1 subdivision scheme
/// based on cubic half-box splines", CAGD 2019, with its original S2 stencil: a triangular patch for each vertex inside
/// a three-valent mesh (VertexPatch draws it), so on an open mesh the natural boundary. Where S2 is tuned at the first
/// step only, build it from level 1. Patches are numbered by their vertices, ascending. Immutable; holds the topology
/// and two numbers a vertex, and finds faces and control points of a patch from there, so that a face of many sides
/// costs no more than many faces.
class PatchTable {
 public:
  /// Errors: invalidMesh at the first vertex inside with other than three edges, or on a boundary with other than two
  /// or three; `element` is the vertex. Linear, parallel.
  static Result<PatchTable> build(Topology topology);

  const Topology& topology() const { return topology_; }
  std::int32_t patchCount() const { return static_cast<std::int32_t>(vertices_.size()); }
  /// The vertex of a patch, and the patch of a vertex, -1 on a boundary.
  std::int32_t vertex(std::int32_t patch) const { return vertices_[static_cast<std::size_t>(patch)]; }
  /// The patch of a vertex; -1 on a boundary.
  std::int32_t patchOf(std::int32_t vertex) const { return patches_[static_cast<std::size_t>(vertex)]; }
  /// Half-edges, faces, sides and control points of a patch; all hexagons or not.
  VertexPatch patch(std::int32_t patch) const { return {topology_, vertex(patch)}; }
  /// The vertices that a patch reads, in the order of VertexPatch::points().
  std::vector<std::int32_t> controlPoints(std::int32_t patch) const { return this->patch(patch).points(); }
  /// Are its three faces hexagons? Then it is one cubic.
  bool regular(std::int32_t patch) const { return this->patch(patch).regular(); }
  /// The patch across the edge from corner i to corner i+1, for i = 0, 1, 2; -1 on the border of the surface.
  std::array<std::int32_t, 3> neighbours(std::int32_t patch) const;
  /// The patches of three hexagons, ascending.
  std::span<const std::int32_t> regularPatches() const { return regular_; }

  /// Point 10 r + i of the result is Bezier point i (numbered as in Far::bezierPoints) of the patch
  /// regularPatches()[r], as rows over the control points. Errors: tooLarge past 2^31 - 1 weights (46 a patch).
  Result<LevelTable> bezierStencils() const;
  /// The same points, x y z of each, from control points whose x y z stand `stride` numbers apart. Parallel.
  /// Errors: invalidOption when there are too few numbers, or `stride` is below 3.
  template <class Real>
  Result<std::vector<double>> bezierPoints(std::span<const Real> points, std::int32_t stride = 3) const;

  /// The surface at a point of a patch, from control points whose x y z stand `stride` numbers apart. Next to faces
  /// that aren't hexagons by refining the patch's own faces (evaluatePatch): linear in their sides.
  /// Errors: invalidOption for a patch that isn't there, coordinates outside the triangle, too few numbers.
  template <class Real>
  Result<PatchPoint> evaluate(std::int32_t patch, const Barycentric& barycentric, std::span<const Real> points,
                              std::int32_t stride = 3) const;

  /// Limit stencils of samples, in their order. The weights of samples with equal coordinates on patches with equal
  /// faces are computed once. Rows hold no zero weights; a control point that stands in several places of its patch is
  /// repeated. Parallel; linear in the samples and the sides of the large faces next to them. Errors: invalidOption
  /// for a sample that is nowhere (`element` is the sample), tooLarge past 2^31 - 1 weights.
  Result<LimitStencils> limitStencils(std::span<const PatchSample> samples) const;
  /// The same rows in one table: of S samples first all positions, then all du from output S on, then all dv.
  Result<LevelTable> limitFrames(std::span<const PatchSample> samples) const;

  /// Every patch cut into `pieces` x `pieces` triangles, counter-clockwise like the mesh; applying
  /// limitStencils(samples).positions gives the vertices. Patches share the vertices on their edges and at their
  /// corners, so a closed mesh gives a closed one. Where an open surface touches itself in one point only, each sheet
  /// has a vertex of its own there. With one piece this is the dual mesh, in which two faces with more than one edge in
  /// common become two vertices with more than one edge between them; from two pieces on it is a manifold.
  /// Errors: invalidOption unless 1 <= pieces <= kMostPieces, tooLarge past 2^31 - 1 vertices or triangle corners.
  Result<Tessellation> tessellate(std::int32_t pieces) const;

 private:
  PatchTable(Topology topology, std::vector<std::int32_t> vertices, std::vector<std::int32_t> patches);
  Result<void> check(const PatchSample& sample) const;
  Result<void> check(std::span<const PatchSample> samples) const;

  Topology topology_;
  std::vector<std::int32_t> vertices_;  // per patch
  std::vector<std::int32_t> patches_;   // per vertex
  std::vector<std::int32_t> regular_;
};

extern template Result<std::vector<double>> PatchTable::bezierPoints(std::span<const float>, std::int32_t) const;
extern template Result<std::vector<double>> PatchTable::bezierPoints(std::span<const double>, std::int32_t) const;
extern template Result<PatchPoint> PatchTable::evaluate(std::int32_t, const Barycentric&, std::span<const float>,
                                                        std::int32_t) const;
extern template Result<PatchPoint> PatchTable::evaluate(std::int32_t, const Barycentric&, std::span<const double>,
                                                        std::int32_t) const;

}  // namespace honeycomb::Far
