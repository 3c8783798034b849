#pragma once

#include <cstdint>
#include <vector>

#include "io/scene/skin.h"

namespace honeycomb::Io {

/// Which vertices are one.
struct Weld {
  std::vector<std::int32_t> representative;  ///< per vertex: the first of those it is one with, perhaps itself
  std::int64_t disagreeing = 0;              ///< vertices that lie on another but move differently, and so stay apart
};

/// Joins the vertices that lie within `tolerance` (a distance, 0: the same place) of one that came before and is no
/// other's, if the same joints move both, with weights within 1e-4, and morph offsets agree within the tolerance: file
/// formats split vertices along seams of texture coordinates and normals. Linear in vertices by a spatial hash, unless
/// more than a few disagree at one place.
Weld weldVertices(const Skin& skin, double tolerance);

}  // namespace honeycomb::Io
