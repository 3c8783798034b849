#pragma once

#include <cstdint>
#include <map>

#include "far/schemes/scheme.h"

namespace honeycomb::Far {

/// The weights b_n by numbers of sides: see HalfBoxOptions.
using TunedWeights = std::map<std::int32_t, double>;

/// S1 of P. Barendrecht, M. Sabin, J. Kosinka, "A bivariate C1 subdivision scheme based on cubic half-box splines",
/// CAGD 2019, Fig 5 and eq 7.
CirculantRule halfBoxRule(std::int32_t sides);

/// S2 of the vertex that half-edge h leaves (on a boundary the boundary one), which has three edges; tuned by its faces
/// that are not cut by a clamped boundary.
void addHalfBoxVertexRow(const Topology& topology, std::int32_t h, const TunedWeights& tuned, Row& row);

}  // namespace honeycomb::Far
