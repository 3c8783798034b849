#pragma once

#include "far/tables/level_table.h"
#include "far/tables/replaced_rows.h"
#include "far/topology/crease_cut.h"
#include "far/topology/split.h"

namespace honeycomb::Far {

/// A step from a level in one of two shapes, its creases open or closed; the table's sources are the points of the
/// level as it is.
struct ShapedStep {
  const Topology& parent;
  const SplitResult& split;
  const LevelTable& table;
};

/// In the last step of a crease, of which s <= 1 steps are left, the mesh is closed there and its points are
/// (1 - s) times those of the smooth step plus s times those of the sharp step: the rows that differ from the smooth
/// step's. `closed` tells how the smooth step's parent was made from the sharp step's.
RowChanges blendCreases(const Reshaped& closed, const ShapedStep& smooth, const ShapedStep& sharp, bool centralPoints);

}  // namespace honeycomb::Far
