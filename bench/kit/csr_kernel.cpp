#include "bench/kit/csr_kernel.h"

#include <cstring>

#include "far/base/index.h"

// A stencil kernel as good as the format allows, for the tiles to be compared with: a point is one register, a row has
// two chains of additions, and multiplications and additions are fused where the processor can (this file is compiled
// with contraction: results agree with the level tables within rounding only).

namespace honeycomb::Bench {

namespace {

/// Entries from a row to what it asks of memory for the rows to come, some fifty of them: a third less time on tables
/// that outgrow the second-level cache. Asking past the end does no harm.
constexpr std::int64_t kAhead = 512;

using Float4 = float __attribute__((vector_size(16)));

[[gnu::always_inline]] inline Float4 point(const float* control, std::int32_t index) {
  Float4 p;
  std::memcpy(&p, control + std::int64_t{4} * index, sizeof p);
  return p;
}

template <int Stride>
[[gnu::always_inline]] inline void rows(const CsrJob& job, std::int64_t begin, std::int64_t end) {
  const std::int32_t* offsets = job.table.offsets.data();
  const std::int32_t* indices = job.table.indices.data();
  const float* weights = job.table.weightsSingle.data();
  const float* control = job.control;
  float* refined = job.refined;
  std::int32_t b = offsets[begin];
  for (std::int64_t r = begin; r < end; ++r) {
    const std::int32_t last = offsets[r + 1];
    Float4 even{}, odd{};
    __builtin_prefetch(weights + b + kAhead);
    __builtin_prefetch(indices + b + kAhead);
    for (; b + 1 < last; b += 2) {
      even += weights[b] * point(control, indices[b]);
      odd += weights[b + 1] * point(control, indices[b + 1]);
    }
    if (b < last) even += weights[b] * point(control, indices[b]);
    b = last;
    even += odd;
    // A packed point is written with a fourth number, which the next row's replaces: the last row has no next.
    std::memcpy(refined + Stride * r, &even, Stride == 4 || r + 1 < end ? sizeof even : 3 * sizeof(float));
  }
}

void rows4(const CsrJob& job, std::int64_t begin, std::int64_t end) {
  rows<4>(job, begin, end);
}
void rows3(const CsrJob& job, std::int64_t begin, std::int64_t end) {
  rows<3>(job, begin, end);
}

#ifdef __x86_64__
[[gnu::target("avx2,fma")]] void rows4Fused(const CsrJob& job, std::int64_t begin, std::int64_t end) {
  rows<4>(job, begin, end);
}
[[gnu::target("avx2,fma")]] void rows3Fused(const CsrJob& job, std::int64_t begin, std::int64_t end) {
  rows<3>(job, begin, end);
}
#endif

}  // namespace

CsrRows csrRows(std::int32_t stride) {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return stride == 4 ? rows4Fused : rows3Fused;
#endif
  return stride == 4 ? rows4 : rows3;
}

}  // namespace honeycomb::Bench
