// Large faces on vectors: one point a vector, the three sums of a face side by side.
#include "osd/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "osd/simd/projected_faces.cpp"
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

/// The sums S, C and D of ProjectedFace.
struct Sums {
  BlockVector s, c, d;
};

template <Access kAccess>
HWY_INLINE BlockVector corner(const LargeFace& face, std::int64_t j) {
  return loadPoint<kAccess>(face.source + face.index[j] * face.sourceStride);
}

template <Access kAccess>
HWY_INLINE Sums sumsOfBlock(const LargeFace& face, std::int64_t first, std::int64_t end) {
  const Block tag;
  const float* s = face.weights + 2;
  const float* c = s + face.corners;
  const float* d = c + face.corners;
  const BlockVector p = corner<kAccess>(face, first);
  Sums sums{hn::Set(tag, s[first]) * p, hn::Set(tag, c[first]) * p, hn::Set(tag, d[first]) * p};
  for (std::int64_t j = first + 1; j < end; ++j) {
    const BlockVector q = corner<kAccess>(face, j);
    sums.s = sums.s + hn::Set(tag, s[j]) * q;
    sums.c = sums.c + hn::Set(tag, c[j]) * q;
    sums.d = sums.d + hn::Set(tag, d[j]) * q;
  }
  return sums;
}

template <Access kAccess>
HWY_INLINE Sums sumsOf(const LargeFace& face) {
  constexpr std::int64_t kStep = Far::kProjectionBlock;
  Sums total = sumsOfBlock<kAccess>(face, 0, face.corners < kStep ? face.corners : kStep);
  for (std::int64_t first = kStep; first < face.corners; first += kStep) {
    const Sums sums = sumsOfBlock<kAccess>(face, first, face.corners < first + kStep ? face.corners : first + kStep);
    total = {total.s + sums.s, total.c + sums.c, total.d + sums.d};
  }
  return total;
}

template <Access kAccess>
void projectOf(const LargeFace& face) {
  const Block tag;
  const Sums sums = sumsOf<kAccess>(face);
  const BlockVector here = hn::Set(tag, face.weights[0]);
  const BlockVector next = hn::Set(tag, face.weights[1]);
  const float* x = face.weights + 2 + 3 * face.corners;
  const float* y = x + face.outputs;
  const float* z = y + face.outputs;
  std::int64_t a = face.firstCorner;
  for (std::int64_t i = 0; i < face.outputs; ++i) {
    const std::int64_t b = a + 1 == face.corners ? 0 : a + 1;
    const BlockVector ends = here * corner<kAccess>(face, a) + next * corner<kAccess>(face, b);
    const BlockVector out =
        ((ends + hn::Set(tag, x[i]) * sums.s) + hn::Set(tag, y[i]) * sums.c) + hn::Set(tag, z[i]) * sums.d;
    float* target = face.target + i * face.targetStride;
    if (kAccess == Access::overlapping && i + 1 == face.outputs) {
      storePoint<Access::three>(out, target);
    } else {
      storePoint<kAccess>(out, target);
    }
    a = b;
  }
}

/// False: the face is one for the plain kernels.
bool project(const LargeFace& face) {
  if (face.narrowPoint >= 0 && contains(face.index, face.corners, face.narrowPoint)) return false;
  switch (face.access) {
    case Access::whole:
      projectOf<Access::whole>(face);
      return true;
    case Access::overlapping:
      projectOf<Access::overlapping>(face);
      return true;
    case Access::three:
      projectOf<Access::three>(face);
      return true;
    case Access::two:
      projectOf<Access::two>(face);
      return true;
    default:
      projectOf<Access::one>(face);
      return true;
  }
}

#else

bool project(const LargeFace&) {
  return false;
}

#endif

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace honeycomb::Osd::Simd {

HWY_EXPORT(project);

void projectedFaces(const Far::LevelTable& table, const Piece<float>& piece, std::int64_t begin, std::int64_t end) {
  for (std::int64_t f = begin; f < end; ++f) {
    const Far::ProjectedFace& face = table.projected[at(f)];
    if (face.outputs == 0) continue;
    const LargeFace large{.source = piece.in.data,
                          .sourceStride = piece.in.stride,
                          .narrowPoint = piece.narrowPoint,
                          .access = accessOf(piece, true),
                          .index = table.indices.data() + face.firstIndex,
                          .weights = table.weightsSingle.data() + face.firstWeight,
                          .target = piece.out.point(face.firstOutput),
                          .targetStride = piece.out.stride,
                          .corners = face.corners,
                          .outputs = face.outputs,
                          .firstCorner = face.firstCorner};
    if (!HWY_DYNAMIC_DISPATCH(project)(large)) Plain::projectedFaces(table, piece, f, f + 1);
  }
}

}  // namespace honeycomb::Osd::Simd
#endif
