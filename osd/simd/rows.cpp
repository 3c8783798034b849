// Rows on vectors: K dense rows at a time, rows of their own length and large faces one after the other.
#include "osd/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "osd/simd/rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway's own first.
#include "osd/simd/level_kernels.h"
#include "osd/simd/points-inl.h"
#include "osd/simd/run.h"

#if HWY_ONCE
#include "far/base/index.h"
#include "osd/plain_kernels.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

#if HONEYCOMB_HAS_VECTORS

using Rows = hn::ScalableTag<float>;
using RowsVector = hn::Vec<Rows>;
constexpr int kRows = kBlocks<Rows>;

/// N entries a row; 0: run.inputs.
template <Access kAccess, int N>
Progress denseOf(const Run run) {
  const Rows d;
  const int n = N > 0 ? N : run.inputs;
  const std::int64_t last = run.count - kRows - (kAccess == Access::overlapping ? 1 : 0);
  const std::int32_t* index = run.index;
  std::int64_t g = 0;
  for (; g <= last; g += kRows, index += kRows * n) {
    if (run.narrowPoint >= 0 && contains(index, std::int64_t{kRows} * n, run.narrowPoint)) return {g, kRows};
    RowsVector sum = hn::Set(d, run.weights[0]) * loadPoints<kAccess>(d, run.source, run.sourceStride, index, n);
    HWY_UNROLL(8)
    for (int j = 1; j < n; ++j) {
      sum = sum + hn::Set(d, run.weights[j]) * loadPoints<kAccess>(d, run.source, run.sourceStride, index + j, n);
    }
    storeFaces<kAccess>(d, &sum, 1, run.target + g * run.targetStride, run.targetStride);
  }
  return {g, run.count - g};
}

template <Access kAccess>
Progress denseByWidth(const Run& run) {
  switch (run.inputs) {
    case 2:
      return denseOf<kAccess, 2>(run);
    case 3:
      return denseOf<kAccess, 3>(run);
    case 4:
      return denseOf<kAccess, 4>(run);
    case 7:
      return denseOf<kAccess, 7>(run);
    default:
      return denseOf<kAccess, 0>(run);
  }
}

template <Access kAccess>
Progress looseOf(const RowRun run) {
  const Block d;
  // Rows that write one point after the other leave the last to the plain kernels, as groups of faces do.
  const std::int64_t end = run.count - (kAccess == Access::overlapping ? 1 : 0);
  for (std::int64_t r = 0; r < end; ++r) {
    const std::int32_t first = run.offsets[r];
    const std::int32_t past = run.offsets[r + 1];
    if (run.narrowPoint >= 0 && contains(run.index + first, past - first, run.narrowPoint)) return {r, 1};
    const auto point = [&](std::int32_t b)
                           HWY_ATTR { return loadPoint<kAccess>(run.source + run.index[b] * run.sourceStride); };
    BlockVector sum = hn::Set(d, run.weights[first]) * point(first);
    for (std::int32_t b = first + 1; b < past; ++b) sum = sum + hn::Set(d, run.weights[b]) * point(b);
    const std::int64_t output = run.outputs != nullptr ? run.outputs[r] : r;
    storePoint<kAccess>(sum, run.target + output * run.targetStride);
  }
  return {end, run.count - end};
}

Progress dense(const Run& run) {
  switch (run.access) {
    case Access::whole:
      return denseByWidth<Access::whole>(run);
    case Access::overlapping:
      return denseByWidth<Access::overlapping>(run);
    case Access::three:
      return denseByWidth<Access::three>(run);
    case Access::two:
      return denseByWidth<Access::two>(run);
    default:
      return denseByWidth<Access::one>(run);
  }
}

Progress loose(const RowRun& run) {
  switch (run.access) {
    case Access::whole:
      return looseOf<Access::whole>(run);
    case Access::overlapping:
      return looseOf<Access::overlapping>(run);
    case Access::three:
      return looseOf<Access::three>(run);
    case Access::two:
      return looseOf<Access::two>(run);
    default:
      return looseOf<Access::one>(run);
  }
}

#else

Progress dense(const Run& run) {
  return {0, run.count};
}
Progress loose(const RowRun& run) {
  return {0, run.count};
}

#endif

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace honeycomb::Osd::Simd {

HWY_EXPORT(dense);
HWY_EXPORT(loose);

void denseRows(const Far::LevelTable& table, const Far::DenseRows& batch, const Piece<float>& piece, std::int64_t begin,
               std::int64_t end) {
  const auto vectors = [&](std::int64_t from, std::int64_t count) {
    const Run run{.source = piece.in.data,
                  .sourceStride = piece.in.stride,
                  .narrowPoint = piece.narrowPoint,
                  .access = accessOf(piece, true),
                  .index = table.indices.data() + batch.firstIndex + from * batch.width,
                  .weights = table.weightsSingle.data() + batch.firstWeight,
                  .target = piece.out.data + (batch.firstOutput + from) * piece.out.stride,
                  .targetStride = piece.out.stride,
                  .count = count,
                  .inputs = batch.width};
    return HWY_DYNAMIC_DISPATCH(dense)(run);
  };
  runBoth(begin, end, vectors,
          [&](std::int64_t from, std::int64_t to) { Plain::denseRows(table, batch, piece, from, to); });
}

void looseRows(const Far::LevelTable& table, const Piece<float>& piece, std::int64_t begin, std::int64_t end) {
  const Far::LooseRows& rows = table.loose;
  const auto vectors = [&](std::int64_t from, std::int64_t count) {
    const RowRun run{.source = piece.in.data,
                     .sourceStride = piece.in.stride,
                     .narrowPoint = piece.narrowPoint,
                     .access = accessOf(piece, false),
                     .index = table.indices.data() + rows.firstIndex,
                     .weights = table.weightsSingle.data() + rows.firstWeight,
                     .offsets = rows.offsets.data() + from,
                     .outputs = rows.outputs.data() + from,
                     .target = piece.out.data,
                     .targetStride = piece.out.stride,
                     .count = count};
    return HWY_DYNAMIC_DISPATCH(loose)(run);
  };
  runBoth(begin, end, vectors, [&](std::int64_t from, std::int64_t to) { Plain::looseRows(table, piece, from, to); });
}

void stencilRows(const Far::StencilTable& table, Far::StencilWeights which, const Piece<float>& piece,
                 std::int64_t begin, std::int64_t end) {
  const auto vectors = [&](std::int64_t from, std::int64_t count) {
    const RowRun run{.source = piece.in.data,
                     .sourceStride = piece.in.stride,
                     .narrowPoint = piece.narrowPoint,
                     .access = accessOf(piece, true),
                     .index = table.indices.data(),
                     .weights = table.weightsAs<float>(which).data(),
                     .offsets = table.offsets.data() + from,
                     .outputs = nullptr,
                     .target = piece.out.data + from * piece.out.stride,
                     .targetStride = piece.out.stride,
                     .count = count};
    return HWY_DYNAMIC_DISPATCH(loose)(run);
  };
  runBoth(begin, end, vectors,
          [&](std::int64_t from, std::int64_t to) { Plain::stencilRows(table, which, piece, from, to); });
}

}  // namespace honeycomb::Osd::Simd
#endif
