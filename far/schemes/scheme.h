#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "far/topology/split.h"

namespace honeycomb::Far {

/// The stencil of a whole N-gon, in the form all schemes of the family share. The new point i of the face is
///     sum_k c_k p_{i+k},   c_k = [k=0] here + [k=1] next + mean + cosine cos(2 pi k/N) + sine sin(2 pi k/N)
/// so that a row, its even/odd parts, its projections and its mirrored halves all follow from five numbers.
struct CirculantRule {
  double here = 0, next = 0, mean = 0, cosine = 0, sine = 0;
};

/// c_0 .. c_{N-1} of a rule.
std::vector<double> firstRow(const CirculantRule& rule, std::int32_t sides);

/// How the corner points of half faces (brick boundary) are found.
enum class HalfFaces : std::uint8_t {
  mirrored,  ///< by faceRule on the polygon completed by its mirror image
  ownRows    ///< by boundaryRow
};

/// One entry of a stencil.
struct Weight {
  std::int32_t point = 0;
  double weight = 0;
};
using Row = std::vector<Weight>;

/// A subdivision scheme as a value: which split, and the weights of its few stencil shapes. Made by the functions of
/// far/schemes, one file a scheme; copied freely.
struct Scheme {
  std::string name;
  Split split;
  /// Stencil of the corner points of whole faces with that many sides.
  std::function<CirculantRule(std::int32_t sides)> faceRule;
  HalfFaces halfFaces = HalfFaces::mirrored;
  /// Stencil of a point that the boundary rule adds, in vertices of the parent; see NewPoint.
  std::function<Row(const Topology& parent, const NewPoint& point)> boundaryRow;
};

}  // namespace honeycomb::Far
