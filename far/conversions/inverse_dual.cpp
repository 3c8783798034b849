#include "far/conversions/inverse_dual.h"

#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <memory>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/conversions/conversion_parts.h"
#include "far/conversions/conversions.h"
#include "far/conversions/triangle_colours.h"

namespace honeycomb::Far {
namespace {

/// How far from its vertex the centroid of a face may lie for a solution, in parts of the values' extent: what is left
/// of coordinates in double after the sums over a mesh of millions of vertices.
constexpr double kTolerance = 1e-9;

/// A closed triangle mesh as the solver needs it; a vertex's triangles are its face in the dual.
struct Interpolation {
  Topology topology;
  std::vector<std::int32_t> centreOf;  ///< vertex of the result that each of the topology's faces becomes
  std::vector<std::int32_t> valence;
  std::vector<NullFunction> nullFunctions;
  /// The equation of each vertex, -1 at the pivots of the null functions: theirs follow from the others when there is a
  /// solution, and without them N N^T has an inverse.
  std::vector<std::int32_t> equation;
  std::int32_t equationCount = 0;
};

using Vector = Eigen::VectorXd;
using Solver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

std::shared_ptr<const Interpolation> makeInterpolation(const Topology& topology, std::vector<std::int32_t> valence) {
  auto made = std::make_shared<Interpolation>();
  made->topology = topology;
  made->centreOf.assign(topology.parents().begin(), topology.parents().end());
  made->valence = std::move(valence);
  made->nullFunctions = nullFunctions(topology);
  made->equation.assign(at(topology.vertexCount()), 0);
  for (const NullFunction& function : made->nullFunctions) made->equation[at(function.pivot)] = -1;
  for (std::int32_t& equation : made->equation)
    if (equation == 0) equation = made->equationCount++;
  return made;
}

/// N N^T over the equations, lower half.
Eigen::SparseMatrix<double> normalMatrix(const Interpolation& mesh) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(at(mesh.topology.vertexCount()) + at(mesh.topology.edgeCount()));
  for (std::size_t v = 0; v < mesh.equation.size(); ++v)
    if (mesh.equation[v] >= 0) entries.emplace_back(mesh.equation[v], mesh.equation[v], mesh.valence[v]);
  for (std::int32_t h = 0; h < mesh.topology.halfEdgeCount(); ++h) {
    const std::int32_t row = mesh.equation[at(mesh.topology.vert(h))],
                       column = mesh.equation[at(mesh.topology.dest(h))];
    if (column >= 0 && row > column) entries.emplace_back(row, column, 2.0);
  }
  Eigen::SparseMatrix<double> matrix(mesh.equationCount, mesh.equationCount);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// One of the numbers of every vertex: of the source, and of the result.
struct Column {
  std::span<const double> values;
  std::span<double> points;
  std::int32_t length = 1, number = 0;

  double value(std::int32_t v) const { return values[at(v) * at(length) + at(number)]; }
  double& point(std::int32_t d) const { return points[at(d) * at(length) + at(number)]; }
};

/// D (p - A d) at a vertex: the sum over its triangles of how far their points lie off it.
double offset(const Interpolation& mesh, const Column& column, std::int32_t v) {
  double sum = 0;
  for (const std::int32_t h : mesh.topology.halfEdgesFrom(v)) {
    sum += column.value(v) - column.point(mesh.centreOf[at(mesh.topology.face(h))]);
  }
  return sum;
}

/// Moves the points by N^T z with (N N^T) z the offsets: off every vertex with an equation by 0 then.
bool correct(const Interpolation& mesh, const Solver& solver, const Column& column) {
  Vector offsets(mesh.equationCount);
  Parallel::forEach(0, mesh.topology.vertexCount(), [&](std::int64_t i) {
    const auto v = static_cast<std::int32_t>(i);
    if (mesh.equation[at(v)] >= 0) offsets[mesh.equation[at(v)]] = offset(mesh, column, v);
  });
  const Vector z = solver.solve(offsets);
  if (!z.allFinite()) return false;
  Parallel::forEach(0, mesh.topology.faceCount(), [&](std::int64_t i) {
    const std::int32_t h = mesh.topology.faceOffsets()[at(i)];
    double sum = 0;
    for (const std::int32_t corner : {h, h + 1, h + 2}) {
      const std::int32_t equation = mesh.equation[at(mesh.topology.vert(corner))];
      if (equation >= 0) sum += z[equation];
    }
    column.point(mesh.centreOf[at(i)]) += sum;
  });
  return true;
}

double extent(const Interpolation& mesh, const Column& column) {
  double low = column.value(0), high = low;
  for (std::int32_t v = 1; v < mesh.topology.vertexCount(); ++v) {
    low = std::min(low, column.value(v));
    high = std::max(high, column.value(v));
  }
  return std::max(high - low, std::max(std::abs(low), std::abs(high)) * 1e-6);
}

/// How far the face of a null function's pivot stays off its vertex where all others reach theirs.
double miss(const Interpolation& mesh, const Column& column, const NullFunction& function) {
  double sum = 0, pivot = 1;
  for (std::size_t i = 0; i < function.vertices.size(); ++i) {
    const std::int32_t v = function.vertices[i];
    const double weight = function.values[i] * mesh.valence[at(v)];
    sum += weight * (column.value(v) - column.value(function.pivot));
    if (v == function.pivot) pivot = weight;
  }
  return std::abs(sum / pivot);
}

Result<void> checkSolvable(const Interpolation& mesh, const Column& column, double size) {
  for (const NullFunction& function : mesh.nullFunctions) {
    const double distance = miss(mesh, column, function);
    if (distance <= kTolerance * size) continue;
    return fail(ErrorCode::invalidPositions,
                fmt::format("there is no inverse dual: by the way the triangles of this mesh can be coloured, the "
                            "centroids of the faces depend on one another, and the vertices don't fit that: the face "
                            "of {} stays {:.3g} off in number {} of its values where all others reach their vertex; "
                            "move that vertex, or change the valences by flipping an edge",
                            elementName(ElementKind::vertex, function.pivot), distance, column.number),
                function.pivot, ElementKind::vertex);
  }
  return {};
}

Result<void> checkReached(const Interpolation& mesh, const Column& column, double size) {
  for (std::int32_t v = 0; v < mesh.topology.vertexCount(); ++v) {
    const double distance = std::abs(offset(mesh, column, v)) / mesh.valence[at(v)];
    if (distance <= kTolerance * size) continue;
    return fail(ErrorCode::invalidPositions,
                fmt::format("no inverse dual was found: the equations are so nearly dependent that the face of {} "
                            "stays {:.3g} off it; flip an edge to change the valences",
                            elementName(ElementKind::vertex, v), distance),
                v, ElementKind::vertex);
  }
  return {};
}

/// The correction of one number of every vertex. A second solve takes off what rounding left of the first.
Result<void> solveColumn(const Interpolation& mesh, const Solver& solver, const Column& column) {
  const double size = extent(mesh, column);
  if (!std::isfinite(size)) return fail(ErrorCode::invalidPositions, "a vertex has a value that isn't finite; mend it");
  if (const auto solvable = checkSolvable(mesh, column, size); !solvable) return solvable;
  for (int pass = 0; pass < 2; ++pass) {
    if (!correct(mesh, solver, column))
      return fail(ErrorCode::invalidPositions,
                  "the inverse dual's points are too far away to be numbers; bring the "
                  "vertices closer together");
  }
  return checkReached(mesh, column, size);
}

Result<void> solve(const Interpolation& mesh, std::span<const double> values, std::int32_t length,
                   std::span<double> points) {
  Solver solver(normalMatrix(mesh));
  if (solver.info() != Eigen::Success)
    return fail(ErrorCode::invalidMesh,
                "the equations of the inverse dual can't be factorised; flip an edge to change "
                "the valences");
  for (std::int32_t number = 0; number < length; ++number)
    if (const auto done = solveColumn(mesh, solver, {values, points, length, number}); !done) return done;
  return {};
}

/// The lowest caller's number of a face that isn't a triangle; faceCount() where all are.
std::int32_t firstOtherFace(const Topology& topology, std::int32_t& sides) {
  std::int32_t first = topology.faceCount();
  for (std::int32_t f = 0; f < topology.faceCount(); ++f) {
    if (topology.sides(f) == 3 || topology.inputFace(f) >= first) continue;
    first = topology.inputFace(f);
    sides = topology.sides(f);
  }
  return first;
}

Result<void> checkTriangles(const Topology& topology) {
  std::int32_t sides = 3;
  if (const std::int32_t face = firstOtherFace(topology, sides); face < topology.faceCount())
    return fail(ErrorCode::invalidMesh,
                fmt::format("{} has {} sides, and only a mesh of triangles has an inverse dual; cut its faces into "
                            "triangles",
                            elementName(ElementKind::face, face), sides),
                face, ElementKind::face);
  if (topology.closed()) return {};
  const std::int32_t v = topology.vert(topology.boundary().front());
  return fail(ErrorCode::invalidMesh,
              fmt::format("{} is on a boundary, where the inverse dual has no face to pass through it; close the mesh",
                          elementName(ElementKind::vertex, v)),
              v, ElementKind::vertex);
}

}  // namespace

Result<Conversion> inverseDual(const Topology& topology) {
  if (const auto sound = checkTriangles(topology); !sound) return tl::unexpected(sound.error());
  Result<Conversion> result = dual(topology);
  if (!result) return result;
  const auto mesh = makeInterpolation(topology, countFacesAt(topology));
  result->correction = [mesh](std::span<const double> values, std::int32_t length, std::span<double> points) {
    return solve(*mesh, values, length, points);
  };
  return result;
}

}  // namespace honeycomb::Far
