#pragma once

#include "far/tables/level_table.h"
#include "far/tables/replaced_rows.h"
#include "far/topology/crease_children.h"

namespace honeycomb::Far {

/// The rows of the points in which creases end inside the mesh. A corner that stays where it is would leave a spike
/// there; such an end, if the caller didn't tag it, comes to lie in the barycentre of the new points of the face round
/// it, and with it the face's central control vertex. `child` is cut open, made by `table`, and has these creases.
RowChanges creaseEndRows(const Topology& child, const CreaseChildren& creases, const LevelTable& table,
                         bool centralPoints);

}  // namespace honeycomb::Far
