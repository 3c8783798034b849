// Where the points of the wanted level go to: straight into the caller's buffer, or past the caches. Compiled once a
// Highway target; no include guard but Highway's.
#if defined(HONEYCOMB_OSD_SIMD_SINKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_SINKS_INL_H
#undef HONEYCOMB_OSD_SIMD_SINKS_INL_H
#else
#define HONEYCOMB_OSD_SIMD_SINKS_INL_H
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstdint>
#include <cstring>

#include "osd/simd/points-inl.h"
#include "osd/tile_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Own points index[0], index[step], .. of a tile.
template <class D>
HWY_INLINE hn::Vec<D> loadOwn(D d, const float* own, const Far::TilePoint* index, std::size_t step) {
  if constexpr (kBlocks<D> == 1) {
    return hn::Load(d, own + std::size_t{Kernels::kTileStride / 2} * index[0]);
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, loadOwn(half, own, index + kBlocks<D> / 2 * step, step), loadOwn(half, own, index, step));
  }
}

/// Numbers from one point to the next where Access tells, 0 elsewhere.
template <Access kAccess>
constexpr std::int64_t kFixedStride = kAccess == Access::overlapping ? 3 : 0;

/// The n points of the faces of a vector, one face behind the other, from p on. The last point is written without
/// touching what is behind it.
template <Access kAccess, int k = 0, class D>
HWY_INLINE void storeInRow(D d, const hn::Vec<D>* out, int n, float* p, std::int64_t stride) {
  constexpr bool kEnds = k + 1 == kBlocks<D>;
  constexpr Access kLast = kEnds && kAccess == Access::overlapping ? Access::three : kAccess;
  HWY_UNROLL(8)
  for (int i = 0; i + 1 < n; ++i) storePoint<kAccess>(blockOf<k>(d, out[i]), p + (k * n + i) * stride);
  storePoint<kLast>(blockOf<k>(d, out[n - 1]), p + (k * n + n - 1) * stride);
  if constexpr (!kEnds) storeInRow<kAccess, k + 1>(d, out, n, p, stride);
}

/// Straight into the target.
template <Access kAccess>
class DirectSink {
 public:
  DirectSink(const View<float>& target, float*) : target_(target) {}

  /// The n outputs of each of a vector's faces (rows: n is 1), the first of which is number `face` of its step.
  template <class D>
  HWY_INLINE void put(D d, const hn::Vec<D>* out, int n, const Kernels::Outputs& outputs, std::int32_t face) const {
    constexpr std::int32_t kLast = kBlocks<D> - 1;
    if (outputs.each == nullptr) {
      storeInRow<kAccess>(d, out, n, point(outputs.first + face * n), stride());
    } else if (const std::int32_t* o = outputs.each + face; o[kLast] == o[0] + kLast * n) {
      storeInRow<kAccess>(d, out, n, point(o[0]), stride());
    } else {
      putApart(d, out, n, o);
    }
  }
  void finish() const {}

 private:
  HWY_INLINE std::int64_t stride() const { return kFixedStride<kAccess> > 0 ? kFixedStride<kAccess> : target_.stride; }
  HWY_INLINE float* point(std::int64_t i) const { return target_.data + i * stride(); }

  template <int k = 0, class D>
  HWY_INLINE void putApart(D d, const hn::Vec<D>* out, int n, const std::int32_t* outputs) const {
    constexpr Access kLast = kAccess == Access::overlapping ? Access::three : kAccess;
    float* p = point(outputs[k]);
    HWY_UNROLL(8)
    for (int i = 0; i + 1 < n; ++i) storePoint<kAccess>(blockOf<k>(d, out[i]), p + i * stride());
    storePoint<kLast>(blockOf<k>(d, out[n - 1]), p + (n - 1) * stride());
    if constexpr (k + 1 < kBlocks<D>) putApart<k + 1>(d, out, n, outputs);
  }

  View<float> target_;
};

/// Past the caches: outputs that follow each other are gathered in a buffer of some kilobytes, and leave it as whole
/// cache lines by non-temporal stores. For targets without gaps between points: xyz (stride 3) or xyzw (stride 4).
///     buffer   | not ours | gathered ................ | slack
///              0          begin_                      fill_           numbers
///     target   line_      (a whole number of cache lines before)
template <Access kAccess>
class StreamSink {
 public:
  /// `buffer`: kStreamRoom numbers on a cache line.
  StreamSink(const View<float>& target, float* buffer) : target_(target.data), buffer_(buffer) {}

  template <class D>
  HWY_INLINE void put(D d, const hn::Vec<D>* out, int n, const Kernels::Outputs& outputs, std::int32_t face) {
    constexpr std::int32_t kLast = kBlocks<D> - 1;
    const std::int32_t* o = outputs.each;
    if (o == nullptr || o[face + kLast] == o[face] + kLast * n) {
      putRow(d, out, n, outputs.of(face, n));
    } else {
      putApart(d, out, n, o + face);
    }
  }

  void finish() {
    flush();
    hwy::FlushStream();
  }

 private:
  static constexpr std::int64_t kStride = kAccess == Access::overlapping ? 3 : 4;
  static constexpr std::int64_t kLine = 16;  // numbers of a cache line

  template <class D>
  HWY_INLINE void putRow(D d, const hn::Vec<D>* out, int n, std::int32_t output) {
    makeRoom(target_ + output * kStride);
    storeInRow<Access::whole>(d, out, n, buffer_ + fill_, kStride);
    fill_ += kBlocks<D> * n * kStride;
  }

  template <int k = 0, class D>
  HWY_INLINE void putApart(D d, const hn::Vec<D>* out, int n, const std::int32_t* outputs) {
    makeRoom(target_ + outputs[k] * kStride);
    HWY_UNROLL(8)
    for (int i = 0; i < n; ++i) storePoint<Access::whole>(blockOf<k>(d, out[i]), buffer_ + fill_ + i * kStride);
    fill_ += n * kStride;
    if constexpr (k + 1 < kBlocks<D>) putApart<k + 1>(d, out, n, outputs);
  }

  /// Makes the buffer ready to take what goes to p.
  HWY_INLINE void makeRoom(float* p) {
    if (p == line_ + fill_) {
      if (fill_ >= Kernels::kStreamNumbers) sendLines();
      return;
    }
    flush();
    begin_ = fill_ = static_cast<std::int64_t>(reinterpret_cast<std::uintptr_t>(p) / sizeof(float) % kLine);
    line_ = p - fill_;
  }

  /// Sends the whole lines and keeps the begun one.
  HWY_NOINLINE void sendLines() {
    const hn::CappedTag<float, 16> d;
    std::int64_t i = 0;
    if (begin_ > 0 && fill_ >= kLine) {
      std::memcpy(line_ + begin_, buffer_ + begin_, at(kLine - begin_) * sizeof(float));
      i = kLine;
    }
    const std::int64_t end = fill_ / kLine * kLine;
    for (; i < end; i += static_cast<std::int64_t>(hn::Lanes(d))) hn::Stream(hn::Load(d, buffer_ + i), d, line_ + i);
    if (end == 0) return;
    std::memcpy(buffer_, buffer_ + end, at(fill_ - end) * sizeof(float));
    line_ += end;
    fill_ -= end;
    begin_ = 0;
  }

  HWY_NOINLINE void flush() {
    sendLines();
    if (fill_ > begin_) std::memcpy(line_ + begin_, buffer_ + begin_, at(fill_ - begin_) * sizeof(float));
    begin_ = fill_;
  }

  float* target_;
  float* buffer_;
  float* line_ = nullptr;
  std::int64_t begin_ = 0;
  std::int64_t fill_ = 0;
};

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
