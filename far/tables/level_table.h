#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/base/array.h"
#include "far/base/shared_array.h"

namespace honeycomb::Far {

/// Faces with up to this many sides are evaluated by their circulant matrix directly, larger ones by projections.
/// At 64 sides the even/odd form costs 64 operations an output from registers and stack; projections need a second
/// pass over the corners, and a table row of weights for each side count.
constexpr std::int32_t kLargestCirculant = 64;

/// The order of operations of a circulant batch, for every evaluator (each operation rounded). p are the corners of a
/// face, c is the first row of its matrix:
///     direct    N odd; weights c_k
///               out_i = ((c_0 p_i + c_1 p_{i+1}) + c_2 p_{i+2}) + ...   over k < N, index i+k wraps to i+k-N
///     evenOdd   N even, M = N/2; weights E_k = (c_k + c_{k+M})/2, k < M, then O_k = (c_k - c_{k+M})/2
///               q_j = p_j + p_{j+M}, d_j = p_j - p_{j+M} for j < M
///               e_i = (E_0 q_i + E_1 q_{i+1}) + ...   over k < M, index i+k wraps to i+k-M
///               o_i = (O_0 d_i + O_1 d_{i+1}) + ...   over k < M, a wrapped term is subtracted instead of added
///               out_i = e_i + o_i,  out_{i+M} = e_i - o_i for i < M
/// Rows that are their own mirror image about the edge from corner 0 to 1 (c_k = c_{1-k}, mod N) have E_0 = E_1 and
/// O_0 = O_1, and share their sums:
///     quad      N = 4; weights K = E_0, G = O_0;  q, d as above
///               s = K (q_0 + q_1),  o_0 = G (d_0 + d_1),  o_1 = G (d_1 - d_0)
///               out_i = s + o_i,  out_{i+2} = s - o_i for i < 2
///     hexagon   N = 6, O_2 = 0; weights K = E_0, A = E_0 - E_2, G = O_0;  q, d as above
///               s = K ((q_0 + q_1) + q_2),  e_i = s - A q_{i+2}, index i+2 wraps to i-1
///               o_0 = G (d_0 + d_1),  o_1 = G (d_1 + d_2),  o_2 = G (d_2 - d_0)
///               out_i = e_i + o_i,  out_{i+3} = e_i - o_i for i < 3
enum class CirculantForm : std::uint8_t { direct, evenOdd, quad, hexagon };

/// How many weights a form has for faces of `sides` sides.
constexpr std::int32_t formWeightCount(CirculantForm form, std::int32_t sides) {
  if (form == CirculantForm::quad) return 2;
  return form == CirculantForm::hexagon ? 3 : sides;
}

/// G faces of N sides whose N outputs are one circulant matrix times their N corners:
///     out[firstOutput + g*N + i] = sum_k c[k] * in[indices[firstIndex + g*N + (i+k) % N]]
struct CirculantBatch {
  std::int32_t sides = 0;        ///< N, 3..kLargestCirculant
  std::int32_t faceCount = 0;    ///< G
  std::int32_t firstIndex = 0;   ///< in LevelTable::indices, G x N of them
  std::int32_t firstOutput = 0;  ///< outputs are contiguous
  std::int32_t firstRow = 0;     ///< in the weights: the first row c, N of them
  std::int32_t firstForm = 0;    ///< in the weights: those of the form; the same as firstRow for the direct form
  CirculantForm form = CirculantForm::direct;
  std::int32_t formWeights() const { return formWeightCount(form, sides); }
};

/// One large face: a matrix that is two diagonals plus rank three, applied in linear time. Full faces of more than
/// kLargestCirculant sides, and large half faces of the brick boundary, whose mirrored half is folded into the weights.
///     S = sum_j s_j p_j,  C = sum_j c_j p_j,  D = sum_j d_j p_j          p_j = in[indices[firstIndex + j]], j <
///     corners out[firstOutput + i] = ((((w_0 p_a) + w_1 p_b) + x_i S) + y_i C) + z_i D      a = firstCorner + i, b =
///     a+1 mod corners
///
/// Each sum is taken in blocks of kProjectionBlock corners in ascending order, starting from the first product of the
/// block; the block sums are then added in ascending order, starting from the first.
///     weights at firstWeight:  w_0 w_1 | s (corners) | c (corners) | d (corners) | x (outputs) | y (outputs) | z
///     (outputs)
struct ProjectedFace {
  std::int32_t corners = 0;
  std::int32_t outputs = 0;  ///< none: only S is wanted (see SummedRows), and the weights end behind s
  std::int32_t firstCorner = 0;
  std::int32_t firstIndex = 0;
  std::int32_t firstOutput = 0;
  std::int32_t firstWeight = 0;
};
/// Corners whose sum is taken apart before it is added to the others.
constexpr std::int32_t kProjectionBlock = 256;

/// G rows that share their weights, of one output each: new points of edges and vertices, central control vertices.
///     out[firstOutput + g] = (w_0 p_0 + w_1 p_1) + ...      p_j = in[indices[firstIndex + g*width + j]]
/// The order of operations is that of a loose row: a row gives the same bits in either.
struct DenseRows {
  std::int32_t width = 0;        ///< entries a row, 1..kWidestDense
  std::int32_t rowCount = 0;     ///< G
  std::int32_t firstIndex = 0;   ///< in LevelTable::indices, G x width of them
  std::int32_t firstOutput = 0;  ///< outputs are contiguous
  std::int32_t firstWeight = 0;  ///< in the weights: w, width of them
};
/// Rows with more entries are loose ones.
constexpr std::int32_t kWidestDense = 16;

/// Rows with weights or places of their own, in compressed sparse row form:
///     out[outputs[r]] = (weights[b] in[indices[b]] + weights[b+1] in[indices[b+1]]) + ...   b from offsets[r] to
///     offsets[r+1]-1
/// `indices` and `weights` are ranges of the level's arrays: entry b is indices[firstIndex + b] and weight[firstWeight
/// + b].
struct LooseRows {
  Array<std::int32_t> outputs;     ///< output point of each row
  Array<std::int32_t> offsets{0};  ///< rows + 1
  std::int32_t firstIndex = 0;
  std::int32_t firstWeight = 0;
  std::int32_t rowCount() const { return static_cast<std::int32_t>(outputs.size()); }
};

/// Rows with weights and places of their own that also read the sum S of all corners of large faces, which stand in
/// `projected` of the same table, as if it were a point: N rows beside a face of N sides cost O(N).
///     out[rows.outputs[r]] = ((w_0 p_0 + w_1 p_1) + ... + u_0 S_0) + ...
/// The entries w, p are those of a loose row, the first ones; then come the shares u_t = weights[firstShare + t] of
/// S_t = S of projected[faces[t]], t = shareOffsets[r] .. shareOffsets[r+1]-1. A row has at least one term, perhaps
/// shares alone.
struct SummedRows {
  LooseRows rows;
  Array<std::int32_t> shareOffsets{0};  ///< rows + 1
  Array<std::int32_t> faces;            ///< in LevelTable::projected, of each share
  std::int32_t firstShare = 0;          ///< in the weights
  std::int32_t rowCount() const { return rows.rowCount(); }
};

/// What to compute to get the points of a level from those of the level before. Every point of the level is the output
/// of exactly one row of one batch. Weights are computed in double and kept in double and float; every row sums to 1.
struct LevelTable {
  std::int32_t sourceCount = 0;  ///< points of the level before
  std::int32_t targetCount = 0;  ///< points of this level
  std::vector<CirculantBatch> circulants;
  std::vector<ProjectedFace> projected;
  std::vector<DenseRows> dense;
  SummedRows summed;
  LooseRows loose;
  SharedArray<std::int32_t> indices;  ///< source points, of all batches; perhaps the corners of the level before
  Array<double> weights;              ///< of all batches
  Array<float> weightsSingle;         ///< the same, rounded

  /// The weights in the precision of the points.
  template <class Real>
  std::span<const Real> weightsAs() const;

  /// Bytes held by the arrays.
  std::int64_t byteCount() const;
};

template <>
inline std::span<const double> LevelTable::weightsAs<double>() const {
  return weights;
}
template <>
inline std::span<const float> LevelTable::weightsAs<float>() const {
  return weightsSingle;
}

}  // namespace honeycomb::Far
