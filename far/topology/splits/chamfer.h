#pragma once

#include "far/topology/split.h"

namespace honeycomb::Far {

/// The split of half-box splines (Barendrecht, Sabin, Kosinka, "A bivariate C1 subdivision scheme based on cubic
/// half-box splines", section 3): every face gives a face of the same number of sides inside it, every edge a hexagon
/// between those of its faces; vertices keep their edges.
///     closed: H' = 4H, V' = H + V, F' = F + E
/// At a boundary edges on it and vertices with two edges make nothing ("natural"): the surface ends with the patches of
/// the vertices inside.
Split chamfer();

}  // namespace honeycomb::Far
