#include "far/tables/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// Large enough that a piece's box costs nothing beside its points.
constexpr std::int64_t kPiece = 1 << 16;

template <class Real>
Box<Real> nothing() {
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

/// A comparison with a NaN is false, which leaves the box as it is.
template <class Real>
void grow(Box<Real>& box, const Real* low, const Real* high) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (low[c] < box.low[c]) box.low[c] = low[c];
    if (high[c] > box.high[c]) box.high[c] = high[c];
  }
}

/// A whole large face's weights are two diagonals plus x + y cos + z sin, at least x - |(y, z)|. What the mirror image
/// adds to a half face's is not looked into.
bool nonNegative(const LevelTable& table, const ProjectedFace& face) {
  if (face.outputs != face.corners) return false;
  const double* w = table.weights.data() + face.firstWeight;
  const double* x = w + 2 + 3 * std::int64_t{face.corners};
  const double* y = x + face.outputs;
  const double* z = y + face.outputs;
  bool positive = w[0] >= 0 && w[1] >= 0;
  for (std::int32_t i = 0; i < face.outputs; ++i) positive = positive && x[i] >= std::hypot(y[i], z[i]);
  return positive;
}

bool nonNegative(const LevelTable& table) {
  const auto positive = [&table](std::int64_t first, std::int64_t count) {
    const auto begin = table.weights.begin() + first;
    return std::all_of(begin, begin + count, [](double w) { return w >= 0; });
  };
  return std::all_of(table.circulants.begin(), table.circulants.end(),
                     [&](const CirculantBatch& batch) { return positive(batch.firstRow, batch.sides); }) &&
         std::all_of(table.dense.begin(), table.dense.end(),
                     [&](const DenseRows& rows) { return positive(rows.firstWeight, rows.width); }) &&
         positive(table.loose.firstWeight, table.loose.offsets.back()) &&
         positive(table.summed.rows.firstWeight, table.summed.rows.offsets.back()) &&
         positive(table.summed.firstShare, table.summed.shareOffsets.back()) &&
         std::all_of(table.projected.begin(), table.projected.end(), [&](const ProjectedFace& face) {
           return face.outputs > 0 ? nonNegative(table, face) : positive(face.firstWeight + 2, face.corners);
         });
}

}  // namespace

template <class Real>
Box<Real> bounds(std::span<const Real> points, std::int32_t stride) {
  const auto count = points.size() < 3 ? 0 : static_cast<std::int64_t>((points.size() - 3) / at(stride)) + 1;
  const std::int64_t pieces = (count + kPiece - 1) / kPiece;
  std::vector<Box<Real>> boxes(at(pieces), nothing<Real>());
  Parallel::forEach(
      0, pieces,
      [&](std::int64_t piece) {
        const std::int64_t end = std::min(count, (piece + 1) * kPiece);
        for (std::int64_t i = piece * kPiece; i < end; ++i) {
          const Real* p = points.data() + i * stride;
          grow(boxes[at(piece)], p, p);
        }
      },
      1);
  Box<Real> all = nothing<Real>();
  for (const Box<Real>& box : boxes) grow(all, box.low.data(), box.high.data());
  return all;
}

template Box<float> bounds(std::span<const float>, std::int32_t);
template Box<double> bounds(std::span<const double>, std::int32_t);

bool isConvex(const Refinement& refinement) {
  for (std::int32_t k = 1; k <= refinement.levelCount(); ++k) {
    if (!nonNegative(refinement.level(k).table)) return false;
  }
  return true;
}

}  // namespace honeycomb::Far
