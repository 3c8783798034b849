#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/base/array.h"
#include "far/base/result.h"
#include "far/tables/level_table.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {

/// What the rows of a stencil table give.
enum class StencilKind : std::uint8_t {
  points,        ///< points of a level
  vertexLimits,  ///< limit positions and tangents of vertices of the last level
  faceLimits     ///< limit positions and tangents of faces of the last level
};

/// Which rows a stencil table has.
struct StencilChoice {
  /// What the rows are of.
  enum class Of : std::uint8_t { all, faces, vertices };
  Of of = Of::all;
  std::vector<std::int32_t> numbers = {};  ///< faces or vertices of the level; see StencilTable::outputs

  /// Every point, vertex or face.
  static StencilChoice all() { return {}; }
  /// The faces with these numbers, or their vertices: see StencilTable::build().
  static StencilChoice faces(std::vector<std::int32_t> numbers) { return {Of::faces, std::move(numbers)}; }
  /// The vertices with these numbers.
  static StencilChoice vertices(std::vector<std::int32_t> numbers) { return {Of::vertices, std::move(numbers)}; }
};

/// What StencilTable::build() is to flatten.
struct StencilOptions {
  StencilKind kind = StencilKind::points;
  std::int32_t level = 0;  ///< of points: 1..levelCount, 0 for the last; limits are of the last
  StencilChoice choice = {};
  std::int64_t memoryLimit = 0;  ///< bytes the table may take; 0: no limit
};

/// The weight arrays of a stencil table.
enum class StencilWeights : std::uint8_t { position, tangent1, tangent2 };

/// Points of a level, or limits, straight from the control points: compressed sparse rows, each with its entries sorted
/// by control point. For partial updates, points that hang on a surface, and other people's evaluators; the whole of a
/// level is evaluated faster level by level, with less memory.
///     row r = (weights[b] in[indices[b]] + weights[b+1] in[indices[b+1]]) + ...   b = offsets[r] .. offsets[r+1]-1
/// The rows of points and of limit positions sum to 1, those of tangents to 0. The tangents have the same indices;
/// their length has no meaning, their cross product T1 x T2 is the normal. Results are those of the chained evaluation
/// up to rounding. Immutable.
struct StencilTable {
  std::int32_t sourceCount = 0;          ///< control points read
  std::vector<std::int32_t> outputs;     ///< the point, vertex or face of the level that each row gives
  std::vector<std::int32_t> offsets{0};  ///< rows + 1
  Array<std::int32_t> indices;           ///< control points
  std::vector<double> weights;
  std::vector<float> weightsSingle;        ///< the same, rounded
  std::vector<double> tangent1, tangent2;  ///< of limits; else empty
  std::vector<float> tangent1Single, tangent2Single;

  std::int32_t rowCount() const { return static_cast<std::int32_t>(outputs.size()); }
  bool hasTangents() const { return !tangent1.empty(); }

  /// One of the weight arrays in the precision of the points.
  template <class Real>
  std::span<const Real> weightsAs(StencilWeights which = StencilWeights::position) const;

  /// The rows as loose rows that write point r of rowCount(), for every evaluator of level tables: the same bits.
  LevelTable asLevelTable(StencilWeights which = StencilWeights::position) const;

  /// Bytes held by the arrays.
  std::int64_t byteCount() const;

  /// Composes the levels of a refinement, in parallel. Rows, in this order:
  ///     all       every point of the level (central control vertices included), every vertex, every face
  ///     faces     of points and vertex limits: the vertices of the chosen faces, each once, in the order in which the
  ///               faces' loops come to them; of face limits: the chosen faces, one row for each number given
  ///     vertices  the chosen vertices, one row for each number given; not of face limits
  /// No row is composed that isn't asked for.
  /// Errors: invalidOption for a level, face or vertex (the element) that isn't there, for limits of a refinement built
  /// without; tooLarge, before the table is allocated, past 2^31 - 1 entries or options.memoryLimit.
  static Result<StencilTable> build(const Refinement& refinement, const StencilOptions& options = {});
};

/// In double.
template <>
inline std::span<const double> StencilTable::weightsAs<double>(StencilWeights which) const {
  return which == StencilWeights::position ? weights : which == StencilWeights::tangent1 ? tangent1 : tangent2;
}
/// In float.
template <>
inline std::span<const float> StencilTable::weightsAs<float>(StencilWeights which) const {
  return which == StencilWeights::position   ? weightsSingle
         : which == StencilWeights::tangent1 ? tangent1Single
                                             : tangent2Single;
}

}  // namespace honeycomb::Far
