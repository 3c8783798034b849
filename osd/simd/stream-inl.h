// What goes past the caches. Compiled once a Highway target; no include guard but Highway's.
#if defined(HONEYCOMB_OSD_SIMD_STREAM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HONEYCOMB_OSD_SIMD_STREAM_INL_H
#undef HONEYCOMB_OSD_SIMD_STREAM_INL_H
#else
#define HONEYCOMB_OSD_SIMD_STREAM_INL_H
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

/// Outputs of vectors of faces that are found at once, at most.
constexpr int kMostTogether = 64;

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
    makeReady(p);
    return take(count);
  }

  /// How many times `count` numbers have room that go to p and behind it; at least once.
  HWY_INLINE std::int32_t roomFor(float* p, std::int64_t count) {
    makeReady(p);
    return static_cast<std::int32_t>((Kernels::kStreamNumbers - fill_ + count - 1) / count);
  }
  /// Where to write so many of the numbers that there is room for.
  HWY_INLINE float* take(std::int64_t count) {
    float* const to = buffer_ + fill_;
    fill_ += count;
    return to;
  }

  /// Where the outputs of some faces stand, face after face, that don't follow each other in the target.
  float* apart() { return apart_; }
  /// Takes these: `count` numbers of face k go to data + each[k] * stride.
  void takeApart(float* data, std::int64_t stride, const std::int32_t* each, int faces, std::int64_t count) {
    for (int k = 0; k < faces; ++k) {
      float* const to = room(data + each[k] * stride, count);
      std::memcpy(to, apart_ + k * count, at(count) * sizeof(float));
    }
  }

  /// To be called behind the last numbers.
  void finish() {
    sendLines();
    endRow();
    for (Piece& piece : pieces_) write(piece);
    hwy::FlushStream();
  }

 private:
  using Line = HWY_CAPPED(float, 16);
  static constexpr std::int64_t kLine = 16;  // numbers of a cache line
  static constexpr std::size_t kPieces = 8;

  // What goes to a part of a line, numbers begin .. end - 1.
  struct Piece {
    float* line = nullptr;
    std::int64_t begin = 0;
    std::int64_t end = 0;
    alignas(64) float numbers[kLine];
  };

  static HWY_INLINE void copyLine(const float* from, float* to) {
    const Line d;
    HWY_UNROLL(4)
    for (std::int64_t i = 0; i < kLine; i += 4 * kBlocks<Line>) hn::Store(hn::Load(d, from + i), d, to + i);
  }

  static HWY_INLINE void write(Piece& piece) {
    if (piece.begin == piece.end) return;
    if constexpr (kBlocks<Line> == 4) {  // without a call and branches that nobody can foresee
      const Line d;
      const auto ours = hn::AndNot(hn::FirstN(d, at(piece.begin)), hn::FirstN(d, at(piece.end)));
      hn::BlendedStore(hn::Load(d, piece.numbers), ours, d, piece.line);
    } else {
      std::memcpy(piece.line + piece.begin, piece.numbers + piece.begin, at(piece.end - piece.begin) * sizeof(float));
    }
    piece.begin = piece.end;
  }

  /// Numbers begin .. end - 1 of the line at `line`, which stands at `from`.
  HWY_INLINE void putOff(float* line, const float* from, std::int64_t begin, std::int64_t end) {
    Piece& piece = pieces_[nextPiece_++ % kPieces];
    write(piece);
    hwy::Prefetch(line);
    piece.line = line;
    piece.begin = begin;
    piece.end = end;
    copyLine(from, piece.numbers);
  }

  HWY_INLINE void makeReady(float* p) {
    if (p != line_ + fill_ || fill_ >= Kernels::kStreamNumbers) makeRoom(p);
  }

  HWY_NOINLINE void makeRoom(float* p) {
    sendLines();
    if (p == line_ + fill_) return;
    endRow();
    begin_ = fill_ = static_cast<std::int64_t>(reinterpret_cast<std::uintptr_t>(p) / sizeof(float) % kLine);
    line_ = p - fill_;
  }

  /// Sends the whole lines and keeps the begun one.
  HWY_INLINE void sendLines() {
    const Line d;
    const std::int64_t end = fill_ / kLine * kLine;
    if (end == 0) return;
    std::int64_t i = 0;
    if (begin_ > 0) {
      putOff(line_, buffer_, begin_, kLine);
      i = kLine;
    }
    HWY_UNROLL(4)
    for (; i < end; i += 4 * kBlocks<Line>) hn::Stream(hn::Load(d, buffer_ + i), d, line_ + i);
    copyLine(buffer_ + end, buffer_);
    line_ += end;
    fill_ -= end;
    begin_ = 0;
  }

  /// Puts off what is left of it.
  HWY_INLINE void endRow() {
    if (fill_ > begin_) putOff(line_, buffer_, begin_, fill_);
    begin_ = fill_;
  }

  float* buffer_;
  float* line_ = nullptr;
  std::int64_t begin_ = 0;
  std::int64_t fill_ = 0;
  Piece pieces_[kPieces];
  std::size_t nextPiece_ = 0;
  float apart_[kMostTogether * 4 + 1];  // a point more than it has numbers is written
};

}  // namespace honeycomb::Osd::Simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
