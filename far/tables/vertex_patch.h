#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "far/tables/half_box_patch.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// The half-box patch of an inside vertex v with three edges, and the points it reads:
///     half-edge  h_0 = outgoing(v), h_{i+1} = twin(prev(h_i)): counter-clockwise
///     face       f_i = face(h_i);  J_i, the patch's corner i, is the centroid of f_i
///     neighbour  w_i = dest(h_i);  the patch's edge from J_i to J_{i+1} lies across the mesh edge (v, w_{i+1})
///     points     0: v   1..3: w_0 w_1 w_2   then the corners 2 .. sides-2 of f_0, of f_1 and of f_2, from v
/// sides_0 + sides_1 + sides_2 - 5 points; a vertex that stands in several of these places is repeated. Small: holds
/// three half-edges and refers to the topology, which has to outlive it.
class VertexPatch {
 public:
  VertexPatch(const Topology& topology, std::int32_t vertex) : topology_(topology) {
    halfEdges_[0] = topology.outgoing(vertex);
    halfEdges_[1] = topology.nextOutgoing(halfEdges_[0]);
    halfEdges_[2] = topology.nextOutgoing(halfEdges_[1]);
  }

  const std::array<std::int32_t, 3>& halfEdges() const { return halfEdges_; }
  std::array<std::int32_t, 3> faces() const {
    return {topology_.face(halfEdges_[0]), topology_.face(halfEdges_[1]), topology_.face(halfEdges_[2])};
  }
  std::array<std::int32_t, 3> sides() const;
  bool regular() const { return sides() == std::array<std::int32_t, 3>{6, 6, 6}; }

  std::int32_t pointCount() const { return patchPointCount(sides()); }
  /// The vertex of the mesh in place i of the patch's points. Constant time.
  std::int32_t point(std::int32_t i) const;
  /// All points, in order.
  std::vector<std::int32_t> points() const;

  /// Corner j of face i, from v: 0 <= j < sides.
  std::int32_t corner(std::size_t face, std::int32_t j) const;

  /// The faces with the values of their corners: valueOf(vertex). Linear in the sides of faces that aren't hexagons.
  template <class Value, class ValueOf>
  PatchFaces<Value> gather(const ValueOf& valueOf) const {
    PatchFaces<Value> faces;
    for (std::size_t i = 0; i < 3; ++i) {
      faces[i] = gatherPatchFace<Value>(topology_.sides(topology_.face(halfEdges_[i])),
                                        [&](std::int32_t j) { return valueOf(corner(i, j)); });
    }
    return faces;
  }

 private:
  const Topology& topology_;
  std::array<std::int32_t, 3> halfEdges_{};
};

}  // namespace honeycomb::Far
