#pragma once

#include "far/schemes/scheme.h"

namespace honeycomb::Far {

/// The corner weights of Doo and Sabin for a face of N sides,
///     alpha_0 = 1/4 + 5/(4N),  alpha_k = (3 + 2 cos(2 pi k/N))/(4N)
/// which half-box splines share for all faces but hexagons (Barendrecht, Sabin, Kosinka, "A bivariate C1 subdivision
/// scheme based on cubic half-box splines", eq 7).
CirculantRule dooSabinRule(std::int32_t sides);

/// D. Doo, M. Sabin, "Behaviour of recursive division surfaces near extraordinary points", on the expand split.
Scheme dooSabin();

}  // namespace honeycomb::Far
