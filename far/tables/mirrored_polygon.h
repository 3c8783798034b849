#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "far/topology/topology.h"

namespace honeycomb::Far {

/// A half face of the brick boundary seen as one half of a whole polygon of N = 2m corners. Its corners are taken along
/// the path from the end of its cut to the start, q = 0 .. count-1. The corner p of the half that is there has the
/// mirror image p* = (1+c) a + (1-c) b - p, a and b the path's ends:
///     real ends   polygon p_0 .. p_m, p_{m-1}* .. p_1*     p_i at q = i,  c = cos(pi i/m)
///     mid ends    polygon p_1 .. p_m, p_m* .. p_1*         p_i at q = i,  c = cos(pi (i-1/2)/m)/cos(pi/(2m))
class MirroredPolygon {
 public:
  /// Face f of the topology, a half face: its loop starts with the cut.
  MirroredPolygon(const Topology& topology, std::int32_t f);

  std::int32_t count() const { return count_; }     ///< corners on the path
  std::int32_t sides() const { return 2 * half_; }  ///< N; 2 when there is no edge between the mid ends' neighbours
  /// The vertex at q on the path.
  std::int32_t vertex(std::int32_t q) const;
  /// The path edges with a corner point of their own: q = firstEdge .. firstEdge + edgeCount - 1, from q to q+1.
  std::int32_t firstEdge() const { return mid_ ? 1 : 0; }
  std::int32_t edgeCount() const { return mid_ ? count_ - 3 : count_ - 1; }
  /// The polygon corner at q.
  std::int32_t cornerAt(std::int32_t q) const { return mid_ ? q - 1 : q; }

  /// Polygon corner j as path corners with weights.
  struct Term {
    std::int32_t q;
    double weight;
  };
  std::array<Term, 3> corner(std::int32_t j) const;
  /// Weights on polygon corners folded onto the path.
  std::vector<double> fold(const std::vector<double>& polygonWeights) const;

 private:
  double mirrorCosine(std::int32_t i) const;

  const Topology& topology_;
  std::int32_t first_;  // half-edge of the cut
  std::int32_t count_;
  bool mid_;
  std::int32_t half_;
};

}  // namespace honeycomb::Far
