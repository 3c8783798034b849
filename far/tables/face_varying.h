#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "far/tables/refinement.h"

namespace honeycomb::Far {

/// Values at the corners of control faces: texture coordinates with seams, colours with borders. They don't deform.
struct FaceVaryingChannel {
  std::int32_t length = 2;                ///< numbers a value
  std::span<const double> values;         ///< `length` numbers each
  std::span<const std::int32_t> corners;  ///< a value for each corner of the control polygons, in the caller's order
};

/// One level of a channel.
struct FaceVaryingLevel {
  std::int32_t valueCount = 0;
  std::vector<std::int32_t> corners;  ///< per half-edge: the value of the corner it leaves, in its face
  LevelTable table;                   ///< from the values of the level before to these; empty at level 0
};

/// A face-varying channel through all levels: which values a level has, which corners they are at, and a level table
/// that computes them from those of the level before, for any evaluator.
///
/// Two faces share a value where their charts agree. A seam is an edge with different values on its two sides.
///   - A face made from a face refines from its corners alone, exactly as if it stood in its own mesh.
///   - A face made from a vertex or an edge takes the chart of its first face: that of the vertex's outgoing(), that of
///     the edge's lower half-edge. All its corners are evaluated in that chart, so that no face reaches across the
///     texture. A corner that lies in another face is that face's own refined corner, carried over by the similarity of
///     the plane (rotation, uniform scale, translation) that takes the two values of the seam's edge in the other chart
///     to those in this one; a stencil that reads several faces reads each of their points so. Round a vertex the way
///     that crosses the fewest seams counts.
///   - Values whose length isn't 2, and charts without area, can't be continued so. There the corner takes the value
///   that
///     the chart has at the vertex itself (at the nearer end of the edge), which adds nothing that wasn't there.
///   - What reads all corners of a face of more than kLargestCirculant sides is carried over as that face's own point,
///   and clamped as a whole: rows beside such a face have few entries. Where parts of a face grow together, so is what
///   is read of each part.
///   - Where a crease grew together, what isn't met round the vertex is looked for over one more face: its part of the
///   face that grew together, from which the crease is crossed. The few points that can't be seen so either take the
///   chart's value at the vertex.
/// The continued points are points of the chart's plane and are written as weights on three corners of the chart's
/// face, which is why a table depends on the values it was built for, and why its rows sum to 1 like all others.
/// Without a seam the tables are those of the refinement: the same bits as a primvar of the vertices.
class FaceVarying {
 public:
  /// Linear in the refinement, however large its faces and vertices. Corners of a vertex with equal values are taken
  /// for one value. Errors: invalidOption, naming face and corner (counted from 0), for a corner whose value doesn't
  /// exist; for values that aren't finite, a length below 1 or spans of the wrong size.
  static Result<FaceVarying> build(const Refinement& refinement, const FaceVaryingChannel& channel);

  std::int32_t levelCount() const { return static_cast<std::int32_t>(levels_.size()) - 1; }
  /// Level k, 0 .. levelCount().
  const FaceVaryingLevel& level(std::int32_t k) const { return levels_[static_cast<std::size_t>(k)]; }
  const FaceVaryingLevel& last() const { return levels_.back(); }
  /// Has the control mesh a seam?
  bool hasSeams() const { return seams_; }

  std::int64_t byteCount() const;

 private:
  FaceVarying(std::vector<FaceVaryingLevel> levels, bool seams) : levels_(std::move(levels)), seams_(seams) {}

  std::vector<FaceVaryingLevel> levels_;
  bool seams_ = false;
};

}  // namespace honeycomb::Far
