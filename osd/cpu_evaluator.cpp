#include "osd/cpu_evaluator.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "osd/cpu_kernels.h"
#include "osd/cpu_pieces.h"
#include "osd/plain_kernels.h"
#include "osd/simd/level_kernels.h"

namespace honeycomb::Osd {

namespace {

/// Points below which a batch stays on the calling thread: about 10 us of work on vectors (1.2 ns a point), several
/// times the cost of a task.
constexpr std::int64_t kPointsPerTask = 8192;
/// Bytes of a target from which whole pieces are written past the caches. Points of xyzw, torus of quads, one thread:
/// 17 MB 1.5 times as fast, 69 MB 1.2 to 1.5, 173 MB 1.2 to 1.5; below, whoever reads them next finds them in the
/// cache.
constexpr std::int64_t kStreamedBytes = std::int64_t{16} << 20;
/// A row from the control points has about ten times the entries of a row from the level before.
constexpr std::int64_t kPointsPerStencil = 10;

/// Runs body on [0, count) in one piece or in parallel pieces of about kPointsPerTask points. It is handed on by
/// reference: a std::function of the body itself would allocate in every frame.
template <class Body>
void split(CpuEvaluator::Threads threads, std::int64_t count, std::int64_t pointsPerItem, const Body& body) {
  if (count == 0) return;
  if (threads == CpuEvaluator::Threads::one) return body(std::int64_t{0}, count);
  Parallel::forRange(0, count, std::max<std::int64_t>(1, kPointsPerTask / pointsPerItem), std::cref(body));
}

/// The kernels by name: plain ones and those on vectors.
struct PlainKernels {
  static void circulantFaces(const auto&... arguments) { Plain::circulantFaces(arguments...); }
  static void denseRows(const auto&... arguments) { Plain::denseRows(arguments...); }
  static void projectedFaces(const auto&... arguments) { Plain::projectedFaces(arguments...); }
  static void looseRows(const auto&... arguments) { Plain::looseRows(arguments...); }
  static void stencilRows(const auto&... arguments) { Plain::stencilRows(arguments...); }
};
struct SimdKernels {
  static void circulantFaces(const auto&... arguments) { Simd::circulantFaces(arguments...); }
  static void denseRows(const auto&... arguments) { Simd::denseRows(arguments...); }
  static void projectedFaces(const auto&... arguments) { Simd::projectedFaces(arguments...); }
  static void looseRows(const auto&... arguments) { Simd::looseRows(arguments...); }
  static void stencilRows(const auto&... arguments) { Simd::stencilRows(arguments...); }
};

/// Calls body(kernels) with those for the points' precision.
template <class Real, class Body>
void withKernels(CpuEvaluator::Instructions instructions, const Body& body) {
  if constexpr (std::is_same_v<Real, float>) {
    if (instructions == CpuEvaluator::Instructions::vectors) return body(SimdKernels{});
  }
  body(PlainKernels{});
}

/// Rows that read the sums of large faces: plain, whatever the others are. They are few, and only at a first level.
template <class Real>
void evaluateSummed(CpuEvaluator::Threads threads, const Far::LevelTable& table, const Piece<Real>& piece) {
  if (table.summed.rowCount() == 0) return;
  std::vector<Real> sums(table.projected.size() * at(kPiece));
  split(threads, static_cast<std::int64_t>(table.projected.size()), kPointsPerTask,
        [&](std::int64_t begin, std::int64_t end) { Plain::faceSums<Real>(table, piece, sums, begin, end); });
  split(threads, table.summed.rowCount(), 1,
        [&](std::int64_t begin, std::int64_t end) { Plain::summedRows<Real>(table, piece, sums, begin, end); });
}

/// All batches of a level on a piece of each point. They write different points, so their order has no meaning.
template <class Kernels, class Real>
void evaluatePiece(CpuEvaluator::Threads threads, Kernels kernels, const Far::LevelTable& table,
                   const Piece<Real>& piece) {
  for (const Far::CirculantBatch& batch : table.circulants) {
    split(threads, batch.faceCount, batch.sides,
          [&](std::int64_t begin, std::int64_t end) { kernels.circulantFaces(table, batch, piece, begin, end); });
  }
  for (const Far::DenseRows& batch : table.dense) {
    split(threads, batch.rowCount, 1,
          [&](std::int64_t begin, std::int64_t end) { kernels.denseRows(table, batch, piece, begin, end); });
  }
  split(threads, static_cast<std::int64_t>(table.projected.size()), kPointsPerTask,
        [&](std::int64_t begin, std::int64_t end) { kernels.projectedFaces(table, piece, begin, end); });
  split(threads, table.loose.rowCount(), 1,
        [&](std::int64_t begin, std::int64_t end) { kernels.looseRows(table, piece, begin, end); });
  evaluateSummed(threads, table, piece);
}

/// Calls body(piece) for points of any length, `sourceCount` of them to read. `padded`: the target's points have room
/// for whole pieces and are read next.
template <class Real, class Body>
void forPieces(const Points<Real>& source, std::int32_t sourceCount, const PointsOut<Real>& target,
               std::int64_t targetCount, bool padded, const Body& body) {
  for (std::int32_t done = 0; done < source.desc.length; done += kPiece) {
    const std::int64_t first = source.desc.offset + done;
    const std::int64_t wholeEnd = first + std::int64_t{sourceCount - 1} * source.desc.stride + kPiece;
    Piece<Real> piece;
    piece.in = {source.data.data() + first, source.desc.stride};
    piece.out = {target.data.data() + target.desc.offset + done, target.desc.stride};
    piece.width = std::min(kPiece, source.desc.length - done);
    if (wholeEnd > static_cast<std::int64_t>(source.data.size())) piece.narrowPoint = sourceCount - 1;
    piece.padded = padded;
    piece.streamed = !padded && targetCount * target.desc.stride * std::int64_t{sizeof(Real)} >= kStreamedBytes;
    body(piece);
  }
}

template <class Real>
void evaluateLevel(CpuEvaluator::Threads threads, CpuEvaluator::Instructions instructions, const Far::LevelTable& table,
                   const Points<Real>& source, const PointsOut<Real>& target, bool padded = false) {
  forPieces(source, table.sourceCount, target, table.targetCount, padded, [&](const Piece<Real>& piece) {
    withKernels<Real>(instructions, [&](auto kernels) { evaluatePiece(threads, kernels, table, piece); });
  });
}

/// Points between levels are padded to whole pieces where vectors read and write them.
BufferDescriptor scratchDescriptor(CpuEvaluator::Instructions instructions, std::int32_t length) {
  if (instructions == CpuEvaluator::Instructions::plain || length < 3) return {0, length, length};
  return {0, length, (length + kPiece - 1) / kPiece * kPiece};
}

template <class Real>
void evaluateFrames(CpuEvaluator::Threads threads, const Far::LimitRows& rows, const View<const Real>& in,
                    const View<Real>& positions, const View<Real>& normals) {
  for (const Far::FrameBatch& batch : rows.batches) {
    split(threads, batch.count, batch.sides, [&](std::int64_t begin, std::int64_t end) {
      Kernels::frames(rows, batch, in, positions, normals, begin, end);
    });
  }
}

template <class Real>
Result<void> checkLimits(const Points<Real>& points, std::int64_t pointCount, const PointsOut<Real>& positions,
                         const PointsOut<Real>& normals, std::int64_t elements) {
  if (pointCount == 0) return fail(ErrorCode::invalidOption, "the refinement was built without limits");
  if (points.desc.length != 3) return fail(ErrorCode::invalidOption, "limits are of positions: length 3");
  const auto size = [](const auto& span) { return static_cast<std::int64_t>(span.size()); };
  if (auto ok = checkDescriptor(points.desc, size(points.data), pointCount, "points"); !ok) return ok;
  for (const PointsOut<Real>* out : {&positions, &normals}) {
    if (out->data.empty()) continue;
    if (out->desc.length != 3) return fail(ErrorCode::invalidOption, "limit positions and normals have length 3");
    if (auto ok = checkDescriptor(out->desc, size(out->data), elements, "limits"); !ok) return ok;
  }
  return {};
}

}  // namespace

template <>
std::vector<float>& CpuEvaluator::scratch<float>(std::int32_t which) {
  return single_[which];
}
template <>
std::vector<double>& CpuEvaluator::scratch<double>(std::int32_t which) {
  return double_[which];
}

template <class Real>
Result<void> CpuEvaluator::evaluate(const Far::LevelTable& table, const Points<Real>& source,
                                    const PointsOut<Real>& target) {
  if (auto ok = checkPoints(source, table.sourceCount, target, table.targetCount); !ok) return ok;
  evaluateLevel(threads_, instructions_, table, source, target);
  return {};
}

template <class Real>
Result<void> CpuEvaluator::evaluate(Far::LevelTables levels, std::int32_t level, const Points<Real>& control,
                                    const PointsOut<Real>& refined) {
  if (level < 1 || level > levels.levelCount()) {
    return fail(ErrorCode::invalidOption,
                fmt::format("level {} is out of range; use 1 to {}", level, levels.levelCount()));
  }
  if (auto ok = checkPoints(control, levels.table(1).sourceCount, refined, levels.table(level).targetCount); !ok) {
    return ok;
  }
  const BufferDescriptor between = scratchDescriptor(instructions_, control.desc.length);
  Points<Real> source = control;
  for (std::int32_t k = 1; k < level; ++k) {
    const Far::LevelTable& table = levels.table(k);
    std::vector<Real>& points = scratch<Real>(k % 2);
    const std::size_t size = at(table.targetCount) * at(between.stride);
    if (points.size() < size) points.resize(size);
    evaluateLevel(threads_, instructions_, table, source, PointsOut<Real>{points, between}, between.stride >= kPiece);
    source = {points, between};
  }
  evaluateLevel(threads_, instructions_, levels.table(level), source, refined);
  return {};
}

template <class Real>
Result<void> CpuEvaluator::vertexLimits(const Far::LimitTable& limits, const Points<Real>& points,
                                        const PointsOut<Real>& positions, const PointsOut<Real>& normals) {
  if (auto ok = checkLimits(points, limits.child.sourceCount, positions, normals, limits.vertices.elementCount); !ok) {
    return ok;
  }
  std::vector<Real>& child = scratch<Real>(0);
  const std::size_t size = 3 * at(limits.child.targetCount);
  if (child.size() < size) child.resize(size);
  evaluateLevel(threads_, instructions_, limits.child, points, PointsOut<Real>{child, {0, 3, 3}});
  evaluateFrames(threads_, limits.vertices, View<const Real>{child.data(), 3}, viewOf(positions), viewOf(normals));
  evaluateFrames(threads_, limits.verticesHere, viewOf(points), viewOf(positions), viewOf(normals));
  return {};
}

template <class Real>
Result<void> CpuEvaluator::faceLimits(const Far::LimitTable& limits, const Points<Real>& points,
                                      const PointsOut<Real>& positions, const PointsOut<Real>& normals) {
  if (auto ok = checkLimits(points, limits.faces.sourceCount, positions, normals, limits.faces.elementCount); !ok) {
    return ok;
  }
  evaluateFrames(threads_, limits.faces, viewOf(points), viewOf(positions), viewOf(normals));
  return {};
}

template <class Real>
Result<void> CpuEvaluator::evaluate(const Far::StencilTable& table, const Points<Real>& control,
                                    const PointsOut<Real>& target, Far::StencilWeights which) {
  if (which != Far::StencilWeights::position && !table.hasTangents()) {
    return fail(ErrorCode::invalidOption, "the stencil table has no tangents; build one of limits");
  }
  if (auto ok = checkPoints(control, table.sourceCount, target, table.rowCount()); !ok) return ok;
  forPieces(control, table.sourceCount, target, table.rowCount(), false, [&](const Piece<Real>& piece) {
    withKernels<Real>(instructions_, [&](auto kernels) {
      split(threads_, table.rowCount(), kPointsPerStencil,
            [&](std::int64_t begin, std::int64_t end) { kernels.stencilRows(table, which, piece, begin, end); });
    });
  });
  return {};
}

#define HONEYCOMB_INSTANTIATE(Real)                                                                                   \
  template Result<void> CpuEvaluator::evaluate(const Far::LevelTable&, const Points<Real>&, const PointsOut<Real>&);  \
  template Result<void> CpuEvaluator::evaluate(Far::LevelTables, std::int32_t, const Points<Real>&,                   \
                                               const PointsOut<Real>&);                                               \
  template Result<void> CpuEvaluator::vertexLimits(const Far::LimitTable&, const Points<Real>&,                       \
                                                   const PointsOut<Real>&, const PointsOut<Real>&);                   \
  template Result<void> CpuEvaluator::faceLimits(const Far::LimitTable&, const Points<Real>&, const PointsOut<Real>&, \
                                                 const PointsOut<Real>&);                                             \
  template Result<void> CpuEvaluator::evaluate(const Far::StencilTable&, const Points<Real>&, const PointsOut<Real>&, \
                                               Far::StencilWeights);
HONEYCOMB_INSTANTIATE(float)
HONEYCOMB_INSTANTIATE(double)
#undef HONEYCOMB_INSTANTIATE

}  // namespace honeycomb::Osd
