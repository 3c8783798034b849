#pragma once

#include <cstdint>
#include <map>
#include <string_view>

#include "far/base/result.h"
#include "far/schemes/scheme.h"
#include "far/topology/splits/zip.h"

namespace honeycomb::Far {

/// The weight a(N) that a corner point keeps on its own corner in an N-gon: larger holds the shape, smaller rounds it.
struct Tension {
  /// How a(N) depends on N.
  enum class Rule : std::uint8_t {
    paper,  ///< a(N) = 0.45 + 1.25/N: Akleman and Srinivasan, "Honeycomb Subdivision"
    sqrt3,  ///< the a(N) that makes the subdominant eigenvalue 1/sqrt 3 for N >= 4, so that the regular mesh reproduces
            ///< linear functions; a(3) = 1
    topmod,   ///< a(N) = 1/sqrt 2 - 1/4 + 1.25/N: the program TopMod
    constant  ///< `value` for every N
  };
  Rule rule = Rule::paper;
  double value = 0;                             ///< of Rule::constant, in (0, 1)
  std::map<std::int32_t, double> bySides = {};  ///< side counts with an a(N) of their own, in (0, 1)

  /// a(sides).
  double at(std::int32_t sides) const;
};

/// What akleman() is free to choose.
struct AklemanOptions {
  Tension tension;
  double edgeParameter = 0.5;  ///< t in [0, 1]: where along its edge a corner point sits
  BoundaryRule boundary = BoundaryRule::brick;
  double boundaryWeight = 0.25;  ///< s of the eq16 boundary, in [0, 1]
};

/// E. Akleman, V. Srinivasan, "Honeycomb Subdivision", ISCIS 2002, eq 1 and 2:
///     v'_n = sum_k c_k v_{n+k},  c_k = (1-t) A_k + t A_{k-1},  A_0 = a,  A_d = (3 + 2 cos(2 pi d/N)) (1-a)/(3N-5)
/// Errors: invalidOption for a tension, edge parameter or boundary weight out of range, or not a number.
Result<Scheme> akleman(const AklemanOptions& options = {});

}  // namespace honeycomb::Far
