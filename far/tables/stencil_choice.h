#pragma once

#include "far/tables/stencil_table.h"

namespace honeycomb::Far {

/// The points, vertices or faces that the rows of a stencil table give: StencilTable::outputs. `pointCount`: points of
/// the level. Errors: invalidOption, with its number as element, for a face or vertex that the level doesn't have.
Result<std::vector<std::int32_t>> stencilOutputs(const Topology& level, std::int32_t levelNumber,
                                                 std::int32_t pointCount, const StencilOptions& options);

}  // namespace honeycomb::Far
