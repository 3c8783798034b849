#pragma once

#include <cstdint>

namespace honeycomb::Osd::Simd {

/// How the up to four values of a point are read from and written to a buffer.
///     whole        four floats in, four floats out: xyzw, or xyz with a float behind it that may be written
///     streamed     the same past the caches: points of 16 bytes, aligned so
///     overlapping  four in, four out, for xyz packed: the fourth is the next point's x, written again with that point;
///                  whoever writes the last point of a range must not write it so
///     three        four in, exactly three out
///     two, one     exactly that many in and out
/// Four floats can't be read at the last point of a buffer of exactly the numbers it needs, if points have three: see
/// Piece::narrowPoint.
enum class Access : std::uint8_t { whole, streamed, overlapping, three, two, one };

}  // namespace honeycomb::Osd::Simd
