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

#include <cstdint>
#include <cstring>

#include "osd/simd/points-inl.h"
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

/// What goes past the caches: outputs that follow each other are gathered in a buffer of some kilobytes, and leave it
/// as whole cache lines by non-temporal stores.
///     buffer   | not ours | gathered ................ | slack
///              0          begin_                      fill_           numbers
///     target   line_      (a whole number of cache lines before)
/// The lines where a row begins and ends belong to others in part and must be read first. Nothing behind a store that
/// waits for that leaves the processor, so such pieces are asked for at once and written some pieces later: where
/// memory is the limit that takes 5 to 15 % less time.
class Stream {
 public:
  /// `buffer`: kStreamRoom numbers on a cache line.
  explicit Stream(float* buffer) : buffer_(buffer) {}

  /// Where to write the `count` numbers that go to p.
  HWY_INLINE float* room(float* p, std::int64_t count) {
    if (p != line_ + fill_ || fill_ >= Kernels::kStreamNumbers) makeRoom(p);
    float* const to = buffer_ + fill_;
    fill_ += count;
    return to;
  }

  /// To be called behind the last numbers.
  void finish() {
    flush();
    for (Piece& piece : pieces_) {
      if (piece.count > 0) write(piece);
    }
    hwy::FlushStream();
  }

 private:
  static constexpr std::int64_t kLine = 16;  // numbers of a cache line
  static constexpr std::size_t kPieces = 8;

  // What goes to a part of a line.
  struct Piece {
    float* to = nullptr;
    std::size_t count = 0;
    float numbers[kLine];
  };

  static void write(Piece& piece) {
    std::memcpy(piece.to, piece.numbers, piece.count * sizeof(float));
    piece.count = 0;
  }

  void putOff(float* to, const float* from, std::int64_t count) {
    Piece& piece = pieces_[nextPiece_++ % kPieces];
    if (piece.count > 0) write(piece);
    hwy::Prefetch(to);
    piece.to = to;
    piece.count = at(count);
    std::memcpy(piece.numbers, from, piece.count * sizeof(float));
  }

  HWY_NOINLINE void makeRoom(float* p) {
    if (p == line_ + fill_) return sendLines();
    flush();
    begin_ = fill_ = static_cast<std::int64_t>(reinterpret_cast<std::uintptr_t>(p) / sizeof(float) % kLine);
    line_ = p - fill_;
  }

  /// Sends the whole lines and keeps the begun one.
  HWY_NOINLINE void sendLines() {
    const hn::CappedTag<float, 16> d;
    std::int64_t i = 0;
    if (begin_ > 0 && fill_ >= kLine) {
      putOff(line_ + begin_, buffer_ + begin_, kLine - begin_);
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
    if (fill_ > begin_) putOff(line_ + begin_, buffer_ + begin_, fill_ - begin_);
    begin_ = fill_;
  }

  float* buffer_;
  float* line_ = nullptr;
  std::int64_t begin_ = 0;
  std::int64_t fill_ = 0;
  Piece pieces_[kPieces];
  std::size_t nextPiece_ = 0;
};

/// Where the points of the wanted level go to, `length` numbers each: straight into the caller's buffer, or into
/// `stream`. kPacked: 3 or 4, points of so many numbers without gaps; 0: of 1 to 4 with any, which are not streamed. To
/// be passed by value: stores to points of unknown whereabouts then leave its numbers in registers.
template <int kPacked, bool kStreamed>
class Sink {
 public:
  static constexpr int kNumbers = kPacked;

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

  /// Where the n outputs of each of kFaces faces of a step, the first of which is number `face`, go to if they follow
  /// each other; null if they don't.
  template <int kFaces>
  HWY_INLINE float* inRow(const Kernels::Outputs& outputs, std::int32_t face, int n) const {
    constexpr std::int32_t kLast = kFaces - 1;
    if (outputs.each == nullptr) return place(outputs.first + face * n, kFaces * n);
    const std::int32_t* const each = outputs.each + face;
    return each[kLast] == each[0] + kLast * n ? place(each[0], kFaces * n) : nullptr;
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
