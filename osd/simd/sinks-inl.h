// A tile's own points, and where those of the wanted level go to: straight into the caller's buffer, or past the
// caches. Compiled once a Highway target; no include guard but Highway's.
#if defined(HONEYCOMB_OSD_SIMD_SINKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_SINKS_INL_H
#undef HONEYCOMB_OSD_SIMD_SINKS_INL_H
#else
#define HONEYCOMB_OSD_SIMD_SINKS_INL_H
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

#include "osd/simd/points-inl.h"
#include "osd/simd/stream-inl.h"
#include "osd/tile_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace honeycomb::Osd::Simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// An own point of a tile.
HWY_INLINE const float* ownPoint(const float* own, Far::TilePoint point) {
  return own + std::size_t{Kernels::kTileStride / 2} * point;
}

/// Own points index[0], index[step], .. of a tile.
template <class D>
HWY_INLINE hn::Vec<D> loadOwn(D d, const float* own, const Far::TilePoint* index, std::size_t step) {
  if constexpr (kBlocks<D> == 1) {
    return hn::Load(d, ownPoint(own, index[0]));
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, loadOwn(half, own, index + kBlocks<D> / 2 * step, step), loadOwn(half, own, index, step));
  }
}

/// Where the points of the wanted level go to, `length` numbers each: straight into the caller's buffer, or into
/// `stream`. kPacked: 3 or 4, points of so many numbers without gaps; 0: of 1 to 4 with any, which are not streamed. To
/// be passed by value: stores to points of unknown whereabouts then leave its numbers in registers.
template <int kPacked, bool kPastCaches>
class Sink {
 public:
  static constexpr int kNumbers = kPacked;
  static constexpr bool kStreamed = kPastCaches;

  Sink(const View<float>& target, int length, Stream& stream)
      : data_(target.data), stride_(target.stride), length_(length), stream_(&stream) {}

  /// The n outputs of each of a vector's faces (rows: n is 1), the first of which is number `face` of its step. Faces
  /// of a step have ascending outputs: the first and the last tell whether they follow each other.
  template <class D>
  HWY_INLINE void put(D d, const hn::Vec<D>* out, int n, const Kernels::Outputs& outputs, std::int32_t face) const {
    constexpr std::int32_t kLast = kBlocks<D> - 1;
    const std::int32_t* const each = outputs.each + face;
    put(d, out, n, outputs, face, outputs.each == nullptr || each[kLast] == each[0] + kLast * n);
  }

  /// The same of outputs in any order, which loose rows have.
  template <class D>
  HWY_INLINE void putInAnyOrder(D d, const hn::Vec<D>* out, int n, const Kernels::Outputs& outputs,
                                std::int32_t face) const {
    const std::int32_t* const each = outputs.each + face;
    bool follow = true;
    for (int k = 1; outputs.each != nullptr && k < kBlocks<D>; ++k) follow &= each[k] == each[0] + k * n;
    put(d, out, n, outputs, face, follow);
  }

  /// For forVectors(): how many of `vectors` times `points` outputs that follow each other from `first` on have room.
  HWY_INLINE std::int32_t fits(std::int32_t first, std::int32_t vectors, int points) const {
    if constexpr (!kStreamed) return vectors;
    return std::min(vectors, stream_->roomFor(data_ + first * stride(), points * stride()));
  }
  /// Where `points` of them are to be put.
  HWY_INLINE float* begin(std::int32_t first, int points) const {
    if constexpr (!kStreamed) return data_ + first * stride();
    return stream_->take(points * stride());
  }
  /// The same for faces whose outputs don't follow each other.
  HWY_INLINE float* beginApart() const { return kStreamed ? stream_->apart() : nullptr; }
  /// Puts the n outputs of each of a vector's faces to `to`; returns where the next vector's go.
  template <class D>
  HWY_INLINE float* putNext(D d, const hn::Vec<D>* out, int n, float* to, const Kernels::Outputs& outputs,
                            std::int32_t face) const {
    if constexpr (!kStreamed) {
      if (to == nullptr) {
        putApart(d, out, n, outputs.each + face);
        return nullptr;
      }
      if constexpr (kPacked > 0) announce(to, kBlocks<D> * n * kPacked);
    }
    putRow(d, out, n, to);
    return to + kBlocks<D> * n * stride();
  }
  /// Behind faces whose outputs don't follow each other.
  HWY_INLINE void endApart(const Kernels::Outputs& outputs, std::int32_t face, int faces, int n) const {
    if constexpr (kStreamed) stream_->takeApart(data_, stride(), outputs.each + face, faces, n * stride());
  }

 private:
  // Known to the compiler only where points overlap: it puts stores that can't out of order, and processors take two at
  // a time only to the same cache line. Measured for xyzw: 8 % slower.
  HWY_INLINE std::int64_t stride() const { return kPacked == 3 ? 3 : stride_; }

  template <class D>
  HWY_INLINE void put(D d, const hn::Vec<D>* out, int n, const Kernels::Outputs& outputs, std::int32_t face,
                      bool follow) const {
    const std::int32_t* const each = outputs.each + face;
    if (outputs.each == nullptr) {
      putRow(d, out, n, place(outputs.first + face * n, kBlocks<D> * n));
    } else if (follow) {
      putRow(d, out, n, place(each[0], kBlocks<D> * n));
    } else {
      putApart(d, out, n, each);
    }
  }

  HWY_INLINE float* place(std::int32_t output, int points) const {
    float* const p = data_ + output * stride();
    if constexpr (kStreamed) return stream_->room(p, points * stride());
    if constexpr (kPacked > 0) announce(p, points * kPacked);
    return p;
  }

  /// Brings what is probably written next into the caches, as many numbers as are written to p. Faces have ascending
  /// outputs, but leave too many gaps for processors to see it coming. Measured: 256 bytes ahead 5 % less time for
  /// points, 16 % where normals are written too; 2048 bytes ahead are too many.
  HWY_INLINE static void announce(const float* p, int numbers) {
    constexpr int kLine = 16;
    constexpr std::uintptr_t kAhead = 256;
    const std::uintptr_t next = reinterpret_cast<std::uintptr_t>(p) + kAhead;  // may lie behind the target's end
    HWY_UNROLL(8)
    for (int i = 0; i < numbers; i += kLine) hwy::Prefetch(reinterpret_cast<const float*>(next) + i);
  }

  /// What is behind the last point stays untouched: it may be another thread's.
  template <int k = 0, class D>
  HWY_INLINE void putRow(D d, const hn::Vec<D>* out, int n, float* p) const {
    constexpr bool kEnds = k + 1 == kBlocks<D>;
    putFace<k>(d, out, n, p, kEnds);
    if constexpr (!kEnds) putRow<k + 1>(d, out, n, p + n * stride());
  }

  template <int k = 0, class D>
  HWY_INLINE void putApart(D d, const hn::Vec<D>* out, int n, const std::int32_t* each) const {
    putFace<k>(d, out, n, place(each[k], n), true);
    if constexpr (k + 1 < kBlocks<D>) putApart<k + 1>(d, out, n, each);
  }

  /// Block k of out[..] to p and behind it.
  template <int k, class D>
  HWY_INLINE void putFace(D d, const hn::Vec<D>* out, int n, float* p, bool ends) const {
    HWY_UNROLL(8)
    for (int i = 0; i + 1 < n; ++i) putPoint(blockOf<k>(d, out[i]), p + i * stride(), false);
    putPoint(blockOf<k>(d, out[n - 1]), p + (n - 1) * stride(), ends);
  }

  HWY_INLINE void putPoint(BlockVector v, float* p, bool last) const {
    if constexpr (kPacked > 0) {
      kPacked == 3 && last && !kStreamed ? storePoint<Access::three>(v, p) : storePoint<Access::whole>(v, p);
      return;
    }
    switch (length_) {
      case 1:
        return storePoint<Access::one>(v, p);
      case 2:
        return storePoint<Access::two>(v, p);
      case 3:
        return storePoint<Access::three>(v, p);
      default:
        return storePoint<Access::whole>(v, p);
    }
  }

  float* data_;
  std::int64_t stride_;
  int length_;
  Stream* stream_;
};

/// Stands for the sink of what isn't written.
struct NoSink {
  HWY_INLINE std::int32_t fits(std::int32_t, std::int32_t vectors, int) const { return vectors; }
  HWY_INLINE float* begin(std::int32_t, int) const { return nullptr; }
  HWY_INLINE float* beginApart() const { return nullptr; }
  template <class D>
  HWY_INLINE float* putNext(D, const hn::Vec<D>*, int, float*, const Kernels::Outputs&, std::int32_t) const {
    return nullptr;
  }
  HWY_INLINE void endApart(const Kernels::Outputs&, std::int32_t, int, int) const {}
};

/// How many times K faces from face `face` on, `most` times at most, have n outputs each that follow each other; 0 if
/// those of the first K don't. Faces of a step have ascending outputs: the first and the last tell.
template <int K>
HWY_INLINE std::int32_t vectorsInRow(const Kernels::Outputs& outputs, int n, std::int32_t face, std::int32_t most) {
  if (outputs.each == nullptr) return most;
  const std::int32_t* const each = outputs.each + face;
  std::int32_t vectors = 0;
  while (vectors < most && each[K * vectors + K - 1] == each[0] + (K * vectors + K - 1) * n) ++vectors;
  return vectors;
}

/// Calls body(face, to, alsoTo) for faces `face`, face + K, .. of a step as long as there are K more; returns the first
/// that is left. Their n outputs each go to `sink` and to `also`, at which body puts them: to = sink.putNext(.., to,
/// ..). `outputs`: null if nothing is written.
/// Streams are asked for room for rows of faces, not for each vector: no vector stays in a register over a call, and
/// all of a kernel's weights would go to memory and back (measured: 5 to 10 % of a tile's time). Straight into the
/// target there are no calls, and short rows would be loops whose end nobody foresees (measured: 3 %).
template <int K, class Sink, class Also, class Body>
HWY_INLINE std::int32_t forVectors(const Kernels::Outputs* outputs, int n, std::int32_t face, std::int32_t end,
                                   Sink sink, Also also, const Body& body) {
  static_assert(K * 8 <= kMostTogether);  // faces of more sides come one at a time
  while (face + K <= end) {
    const std::int32_t begin = face;
    std::int32_t vectors = Sink::kStreamed ? (end - face) / K : 1;
    float* to = nullptr;
    float* alsoTo = nullptr;
    bool follow = true;
    if (outputs != nullptr) {
      const std::int32_t first = outputs->of(face, n);
      vectors = vectorsInRow<K>(*outputs, n, face, also.fits(first, sink.fits(first, vectors, K * n), K * n));
      follow = vectors > 0;
      to = follow ? sink.begin(first, vectors * K * n) : sink.beginApart();
      alsoTo = follow ? also.begin(first, vectors * K * n) : also.beginApart();
    }
    if constexpr (Sink::kStreamed) {
      for (const std::int32_t stop = face + std::max(vectors, 1) * K; face < stop; face += K) body(face, to, alsoTo);
    } else {
      body(face, to, alsoTo);
      face += K;
    }
    if (!follow) {
      sink.endApart(*outputs, begin, K, n);
      also.endApart(*outputs, begin, K, n);
    }
  }
  return face;
}

/// Calls body(sink) with the sink for points of kPacked numbers without gaps.
template <int kPacked, class Body>
HWY_INLINE void withPackedSink(const View<float>& target, float* buffer, const Body& body) {
  Stream stream(buffer);
  if (buffer == nullptr) return body(Sink<kPacked, false>(target, kPacked, stream));
  body(Sink<kPacked, true>(target, kPacked, stream));
  stream.finish();
}

/// Calls body(sink) with the sink for points of one to three numbers (or four with gaps) in `target`; `buffer`: as
/// Stream's, null if nothing is to be streamed.
template <class Body>
HWY_INLINE void withSmallSink(const View<float>& target, int length, float* buffer, const Body& body) {
  if (length == 3 && target.stride == 3) return withPackedSink<3>(target, buffer, body);
  Stream none(nullptr);
  body(Sink<0, false>(target, length, none));
}

/// The same for points of one to four.
template <class Body>
HWY_INLINE void withSink(const View<float>& target, int length, float* buffer, const Body& body) {
  if (length == 4 && target.stride == 4) return withPackedSink<4>(target, buffer, body);
  withSmallSink(target, length, buffer, body);
}

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
