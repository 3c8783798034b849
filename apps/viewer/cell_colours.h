#pragma once

#include <cstdint>
#include <vector>

#include "apps/viewer/style.h"
#include "far/tables/refinement.h"

namespace honeycomb::Viewer {

/// What a face's colour says.
enum class Colouring {
  plain,    ///< nothing: one colour for all
  descent,  ///< its number of sides. Hexagons, which nearly all faces of a refined mesh are, also take on the colour
            ///< of what they descend from, so that the control mesh stays readable on the smooth surface: the side
            ///< count of the control face, or the pale petals round a control vertex
  sides,    ///< its number of sides alone
  extraordinary  ///< how many faces it is away from the next one that is no hexagon
};

/// A colour for each face of level k, as CellMeshContent wants them. Linear.
std::vector<std::uint32_t> cellColours(const Far::Refinement& refinement, std::int32_t level,
                                       Colouring colouring = Colouring::descent, const Palette& palette = {});

/// Faces between each face and the next one that is no hexagon, across edges: 0 for those themselves; `most` for all
/// that are farther. Linear.
std::vector<std::int32_t> ringsFromExtraordinary(const Far::Topology& topology, std::int32_t most);

}  // namespace honeycomb::Viewer
