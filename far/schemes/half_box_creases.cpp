#include "far/schemes/half_box_creases.h"

#include <cmath>

#include "far/schemes/creases.h"
#include "far/schemes/zip_boundary.h"
#include "far/topology/splits/clamp_bricks.h"

namespace honeycomb::Far {

Result<void> chooseForCreases(const Topology& control, HalfBoxOptions& options) {
  for (const CreaseEdge& crease : control.creases()) {
    if (!std::isinf(crease.sharpness)) {
      return refuseCrease(control, crease,
                          "half-box has no rule for creases that become smooth; give it sharpness 10, "
                          "which is infinite, or use akleman or zhang-wang");
    }
  }
  const CreaseEdge& first = control.creases().front();
  const bool converts =
      options.conversion == HalfBoxConversion::automatic || options.conversion == HalfBoxConversion::akleman;
  if (!converts) {
    return refuseCrease(control, first, "half-box keeps creases through the akleman conversion only; choose it");
  }
  if (!control.closed() && options.boundary != HalfBoxBoundary::clamped) {
    return refuseCrease(control, first,
                        "on a mesh with a border, half-box needs that clamped too; choose the clamped "
                        "boundary");
  }
  options.conversion = HalfBoxConversion::akleman;
  options.boundary = HalfBoxBoundary::clamped;
  return {};
}

Scheme clampBricksStep() {
  Scheme scheme;
  scheme.name = "clamp";
  scheme.split = clampBricks();
  scheme.creases = {CreaseRule::Reach::infinite, true, scheme.split};
  scheme.pointRow = [](const SourceLevel& parent, const NewPoint& point, Row& row) {
    if (point.kind == PointKind::vertexPoint) {
      row.push_back({parent.topology().vert(point.halfEdge), 1});
    } else {
      addZipBoundaryRow(parent.topology(), point, 0, row);
    }
  };
  return scheme;
}

}  // namespace honeycomb::Far
