#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "far/base/result.h"
#include "far/schemes/scheme.h"
#include "far/topology/splits/zip.h"

namespace honeycomb::Far {

/// a_N: how far the central control vertex of an N-gon moves towards the barycentre of its corners in a step.
struct CentralPull {
  /// How a_N depends on N.
  enum class Rule : std::uint8_t {
    paper,    ///< (4 - cos(2 pi/N))/9, as printed
    kobbelt,  ///< (4 - 2 cos(2 pi/N))/9, Kobbelt's sqrt 3 weight, almost surely what is meant: b - a = |lambda_1|^2
    constant  ///< `value` for every N
  };
  Rule rule = Rule::paper;
  double value = 0;

  /// a of a face with that many sides.
  double at(std::int32_t sides) const;
};

/// What zhangWang() is free to choose; the letters are the paper's.
struct ZhangWangOptions {
  CentralPull pull;              ///< a_N
  double spread = 2.0 / 3;       ///< b_N: how far corner points lie from the central control vertex, in (0, 1)
  double vertexPull = 0.5;       ///< c_n: how far the central control vertex of a vertex's face moves to those round it
  std::optional<double> alpha;   ///< share of the neighbours in that, in [0, 1]; none: all neighbours and faces alike
  double boundaryWeight = 0.25;  ///< s_n of the eq16 boundary, in [0, 1]
  BoundaryRule boundary = BoundaryRule::eq16;
  /// Control vertices (inside the mesh) that the limit surface is to pass through. That it passes through the central
  /// control vertices which are barycentres needs no tag.
  std::vector<std::int32_t> interpolatedVertices = {};
  bool unchecked = false;  ///< take a_N and b_N whose surface has no tangent plane
};

/// The chain of `levels` steps of Zhang H.-X., Wang G.-J., "Honeycomb Subdivision", Journal of Software 2002, for
/// `control`. Faces have central control vertices q (RefineOptions::centralPoints: given; else barycentres):
///     v'_h    = (1 - b_N) q + b_N (v_h + v_{h+1})/2                                        (eq 2)
///     q'      = (1 - a_N) q + a_N p       of a face, p the barycentre of its corners       (eq 3)
///     q'      = (1 - c_n) v + c_n (sum_i alpha_i p_i + sum_i beta_i q_i)     of a vertex   (eq 4)
/// Boundaries: eq16, the paper's; brick, where a half face's central control vertex is the middle of its cut.
/// Errors: invalidOption for a weight out of range, or when a and b of a side count of the mesh are not within
///     b (1 - cos(pi/N)) < a < b (1 + cos(pi/N)),
/// which is |b - a| < |lambda_1| and what eq 12 of the paper should say; or when an interpolated vertex is not inside.
Result<std::vector<Scheme>> zhangWang(const Topology& control, std::int32_t levels,
                                      const ZhangWangOptions& options = {});

}  // namespace honeycomb::Far
