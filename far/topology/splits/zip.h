#pragma once

#include <cstdint>

#include "far/topology/split.h"

namespace honeycomb::Far {

/// What the zip split does along a boundary.
enum class BoundaryRule : std::uint8_t {
  brick,  ///< the boundary is a mirror line that cuts cells in half; its curve is smooth, tagged corners stay
  eq16,  ///< Zhang and Wang, "Honeycomb Subdivision", eq 16: a boundary vertex keeps a cell of its own, closed by a new
         ///< point
  drop   ///< cells that would be incomplete are left out; the mesh erodes
};

/// The split of honeycomb subdivision (Akleman and Srinivasan; Zhang and Wang): every face gives a face of the same
/// number of sides inside it, every vertex a face of twice its valence.
///     H' = 3H, V' = H, F' = F + V on a closed mesh.
Split zip(BoundaryRule boundary);

}  // namespace honeycomb::Far
