#pragma once

#include <map>
#include <vector>

#include "far/tables/level_table.h"
#include "tests/support/poly_mesh.h"

namespace honeycomb::Test {

/// Source point -> weight.
using StencilRow = std::map<std::int32_t, double>;

/// The rows of a level table as its definition in far/tables/level_table.h says, batch by batch, without any shortcut.
/// A row that no batch or more than one batch writes is left empty, and so is noticed: its weights don't add up to 1.
std::vector<StencilRow> expandRows(const Far::LevelTable& table);

/// The rows from the control points: `outer` after `inner`.
std::vector<StencilRow> composeRows(const std::vector<StencilRow>& outer, const std::vector<StencilRow>& inner);

std::vector<Vec3> applyRows(const std::vector<StencilRow>& rows, const std::vector<Vec3>& points);

}  // namespace honeycomb::Test
