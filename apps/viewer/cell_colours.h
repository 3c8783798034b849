#pragma once

#include <cstdint>
#include <vector>

#include "apps/viewer/style.h"
#include "far/tables/refinement.h"

namespace honeycomb::Viewer {

/// A colour for each face of level k, as CellMeshContent wants them: by its number of sides. Hexagons, which nearly all
/// faces of a refined mesh are, also take on the colour of what they descend from, so that the control mesh stays
/// readable on the smooth surface: the side count of the control face, or the pale petals round a control vertex.
std::vector<std::uint32_t> cellColours(const Far::Refinement& refinement, std::int32_t level,
                                       const Palette& palette = {});

}  // namespace honeycomb::Viewer
