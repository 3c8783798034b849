#pragma once

#include <cstdint>
#include <vector>

#include "far/topology/topology.h"

namespace honeycomb::Far {

/// A face or a vertex at which a crease was closed, and the steps for which the sharpest of these was still sharp.
struct ClosedCrease {
  std::int32_t element = 0;
  double sharpness = 0;
};

/// One entry an element, ascending, with the largest sharpness.
std::vector<ClosedCrease> sharpestEach(std::vector<ClosedCrease> closed);

/// A topology made from another by opening or closing its creases, and what its parts were made from.
struct Reshaped {
  Topology topology;
  std::vector<std::int32_t> vertexOf;  ///< per vertex: the vertex it was, or the first of those it unites
  std::vector<std::int32_t> faceOf;    ///< per face: the same
  std::vector<std::int32_t> firstOf;   ///< per half-edge: the half-edge it was, or the first of those it joins
  std::vector<std::int32_t> lastOf;    ///< per half-edge: the last
  std::vector<std::int32_t> united;    ///< per vertex it was made from: the first of those it is united with; empty
                                       ///< when none are
  std::vector<ClosedCrease> faces;     ///< that differ from what they were where a crease was closed, ascending
  std::vector<ClosedCrease> vertices;  ///< that lay on a crease that was closed, ascending
};

/// Level 0 cut open along its creases that are sharper than `sharpness` steps. Faces and half-edges keep their numbers;
/// a vertex that falls into parts keeps its number for one of them, the others come behind all vertices.
///
/// A vertex through which a crease passes becomes an ordinary boundary vertex on both sides. Where a crease ends,
/// changes its sharpness, meets the boundary or more than one other, and where the caller tagged a corner, the parts
/// become corners, so that the sides stay together.
Reshaped cutCreases(const Topology& control, double sharpness);

/// A refined level, cut open, with the creases closed that are at most `sharpness` steps sharp: cut faces grow
/// together, the points where edges cross the crease are dissolved, edges and vertices on it united. Corners at which
/// no crease ends any more go back to what they would be without.
Reshaped weldCreases(const Topology& level, double sharpness);

/// Is level 0 not cut open yet?
inline bool uncut(const Topology& topology) {
  return !topology.creases().empty() && topology.twin(topology.creases().front().halfEdge) >= 0;
}

/// The creases of a cut topology by half-edges of its boundary.
class CreaseSides {
 public:
  explicit CreaseSides(const Topology& topology);
  /// The half-edge on the other side of the cut; -1 on a boundary that is no crease.
  std::int32_t mate(std::int32_t b) const {
    const CreaseEdge* side = find(b);
    return side == nullptr ? -1 : side->mate;
  }
  /// 0 on a boundary that is no crease.
  double sharpness(std::int32_t b) const {
    const CreaseEdge* side = find(b);
    return side == nullptr ? 0 : side->sharpness;
  }

 private:
  const CreaseEdge* find(std::int32_t b) const;
  std::vector<CreaseEdge> sides_;  // each crease from both sides, ascending
};

}  // namespace honeycomb::Far
