#pragma once

#include <algorithm>
#include <cstdint>

#include "osd/piece.h"
#include "osd/simd/point_access.h"

/// What the dispatched kernels get: plain pointers and numbers. Code compiled for one target calls no function that is
/// shared with the rest of the program, so that none of its instructions gets there.
namespace honeycomb::Osd::Simd {

/// Faces or rows that follow each other, with as many indices and outputs each.
struct Run {
  const float* source;
  std::int64_t sourceStride;
  std::int32_t narrowPoint;  ///< see Piece; -1: none
  Access access;
  const std::int32_t* index;  ///< of the first
  const float* weights;
  float* target;  ///< output of the first
  std::int64_t targetStride;
  std::int64_t count;   ///< faces or rows
  std::int32_t inputs;  ///< indices each
};

/// Rows of their own length.
struct RowRun {
  const float* source;
  std::int64_t sourceStride;
  std::int32_t narrowPoint;
  Access access;
  const std::int32_t* index;
  const float* weights;
  const std::int32_t* offsets;  ///< of the first row, and of what follows the last
  const std::int32_t* outputs;  ///< of the first row; null: rows write one point after the other
  float* target;                ///< null outputs: of the first row; else point 0
  std::int64_t targetStride;
  std::int64_t count;
};

/// A face by projections: see Far::ProjectedFace.
struct LargeFace {
  const float* source;
  std::int64_t sourceStride;
  std::int32_t narrowPoint;
  Access access;
  const std::int32_t* index;
  const float* weights;
  float* target;  ///< the first output
  std::int64_t targetStride;
  std::int64_t corners;
  std::int64_t outputs;
  std::int64_t firstCorner;
};

/// How far a kernel came, and how many items the plain kernels are to do before it is called again: those that read the
/// narrow point, or the last ones of the run.
struct Progress {
  std::int64_t done;
  std::int64_t plain;
};

/// Does the items begin .. end-1: vectors(from, count) -> Progress does what it can, plain(from, to) what it leaves.
template <class Vectors, class Plain>
void runBoth(std::int64_t begin, std::int64_t end, const Vectors& vectors, const Plain& plain) {
  while (begin < end) {
    const Progress progress = vectors(begin, end - begin);
    begin += progress.done;
    const std::int64_t next = std::min(end, begin + progress.plain);
    if (begin < next) plain(begin, next);
    begin = next;
  }
}

/// How the points of a piece are written, if one after the other (`ascending`).
inline Access accessOf(const Piece<float>& piece, bool ascending) {
  if (piece.width == 1) return Access::one;
  if (piece.width == 2) return Access::two;
  if (piece.width == kPiece || piece.padded) return Access::whole;
  return ascending && piece.out.stride == piece.width ? Access::overlapping : Access::three;
}

/// The same for faces, nearly all points of a level, which are streamed if the target is that large.
inline Access faceAccessOf(const Piece<float>& piece) {
  const bool aligned = reinterpret_cast<std::uintptr_t>(piece.out.data) % 16 == 0 && piece.out.stride == kPiece;
  return piece.streamed && aligned && piece.width == kPiece ? Access::streamed : accessOf(piece, true);
}

}  // namespace honeycomb::Osd::Simd
