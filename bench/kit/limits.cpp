#include "bench/kit/limits.h"

#include <array>
#include <cstring>

#include "far/base/parallel.h"
#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace honeycomb::Bench {

namespace {

/// Numbers of a piece of work: 256 kB.
constexpr std::int64_t kPiece = 65536;
/// Numbers stored at a time: a cache line.
constexpr std::int64_t kLine = 16;

using Fill = void (*)(const float* from, float* to, std::int64_t count);

void copyPiece(const float* from, float* to, std::int64_t count) {
  std::memcpy(to, from, static_cast<std::size_t>(count) * sizeof(float));
}

#ifdef __x86_64__
void write16(const float*, float* to, std::int64_t count) {
  const __m128 value = _mm_setr_ps(0, 1, 2, 3);
  for (std::int64_t i = 0; i < count; i += 4) _mm_store_ps(to + i, value);
}

[[gnu::target("avx")]] void write32(const float*, float* to, std::int64_t count) {
  const __m256 value = _mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7);
  for (std::int64_t i = 0; i < count; i += 8) _mm256_store_ps(to + i, value);
}

void writePast(const float*, float* to, std::int64_t count) {
  const __m128 value = _mm_setr_ps(0, 1, 2, 3);
  for (std::int64_t i = 0; i < count; i += 4) _mm_stream_ps(to + i, value);
  _mm_sfence();
}
#else
void write16(const float*, float* to, std::int64_t count) {
  for (std::int64_t i = 0; i < count; ++i) to[i] = static_cast<float>(i % 4);
}
constexpr Fill writePast = write16;
#endif

Fill bestWrite() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx")) return write32;
#endif
  return write16;
}

Prepared prepare(std::span<const float> from, std::span<float> to, Threads threads, Fill fill) {
  Prepared prepared;
  const std::int64_t lines = static_cast<std::int64_t>(to.size()) / kLine;
  prepared.frame = [from, to, threads, fill, lines]() -> Result<void> {
    const auto piece = [&](std::int64_t begin, std::int64_t end) {
      fill(from.data() + begin * kLine, to.data() + begin * kLine, (end - begin) * kLine);
    };
    if (threads == Threads::one) {
      piece(0, lines);
    } else {
      Parallel::forRange(0, lines, kPiece / kLine, piece);
    }
    return {};
  };
  prepared.vertices = 1;
  return prepared;
}

template <Threads threads>
Prepared prepareWrite(std::span<const float> from, std::span<float> to) {
  return prepare(from, to, threads, bestWrite());
}
template <Threads threads>
Prepared prepareWritePast(std::span<const float> from, std::span<float> to) {
  return prepare(from, to, threads, writePast);
}
template <Threads threads>
Prepared prepareCopy(std::span<const float> from, std::span<float> to) {
  return prepare(from, to, threads, copyPiece);
}

}  // namespace

std::span<const LimitEntry> limits() {
  static constexpr std::array kLimits{
      LimitEntry{"write_gb_s", Threads::one, prepareWrite<Threads::one>},
      LimitEntry{"write_nt_gb_s", Threads::one, prepareWritePast<Threads::one>},
      LimitEntry{"copy_gb_s", Threads::one, prepareCopy<Threads::one>},
      LimitEntry{"write_gb_s", Threads::all, prepareWrite<Threads::all>},
      LimitEntry{"write_nt_gb_s", Threads::all, prepareWritePast<Threads::all>},
      LimitEntry{"copy_gb_s", Threads::all, prepareCopy<Threads::all>},
  };
  return kLimits;
}

}  // namespace honeycomb::Bench
