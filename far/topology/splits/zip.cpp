#include "far/topology/splits/zip.h"

#include "far/topology/splits/slot_rule.h"
#include "far/topology/splits/zip_rules.h"

namespace honeycomb::Far {

namespace {

Census growClosed(const Census& p) {
  Census c;
  c.vertices = p.halfEdges;
  c.edges = p.halfEdges + p.edges;
  c.faces = p.faces + p.vertices;
  c.halfEdges = 3 * p.halfEdges;
  c.exact = p.exact;
  return c;
}

/// Counts what zipBrick makes of each kind of boundary edge and vertex; half-edges follow from Euler's formula.
Census growBrick(const Census& p) {
  Census c;
  c.exact = p.exact;
  const std::int64_t cuts = p.cutReal + p.cutMid;
  const std::int64_t tips = p.tipReal + p.tipMid;
  const std::int64_t cornerPoints = p.halfEdges - cuts - tips - 2 * p.mid;
  c.vertices = cornerPoints + p.onLine + 2 * cuts + tips + p.corner + p.fixedCorner;
  c.faces = p.faces + p.vertices - p.mid - p.fixedCorner;
  c.mid = p.onLine + 2 * p.cutReal + p.tipReal;
  c.real = 2 * p.cutMid + p.tipMid;
  c.fixedCorner = p.corner + p.fixedCorner;
  c.onLine = p.mid;
  c.cutReal = p.cutMid;
  c.cutMid = p.cutReal + p.real;
  c.tipReal = p.tipMid;
  c.tipMid = p.tipReal + 2 * p.corner;
  c.boundaryEdges = c.onLine + c.cutReal + c.cutMid + c.tipReal + c.tipMid;
  const std::int64_t euler = p.vertices - p.edges + p.faces;
  c.edges = c.vertices + c.faces - euler;
  c.halfEdges = 2 * c.edges - c.boundaryEdges;
  return c;
}

/// What eq16 leaves of a boundary depends on its shape: a bound, every boundary vertex counted as keeping a cell.
Census growEq16(const Census& p) {
  Census c = growClosed(p);
  c.exact = p.exact && p.boundaryEdges == 0;
  c.vertices += p.boundaryEdges;
  c.edges += 2 * p.boundaryEdges;
  c.halfEdges += p.boundaryEdges;
  c.boundaryEdges = 2 * p.boundaryEdges;
  return c;
}

/// What drop leaves depends on the boundary's shape too: a bound, nothing counted as dropped.
Census growDrop(const Census& p) {
  Census c = growClosed(p);
  c.exact = p.exact && p.boundaryEdges == 0;
  c.boundaryEdges = p.boundaryEdges == 0 ? 0 : c.halfEdges;
  return c;
}

Census grow(const Census& parent, BoundaryRule boundary) {
  if (parent.boundaryEdges == 0) return growClosed(parent);
  switch (boundary) {
    case BoundaryRule::brick:
      return growBrick(parent);
    case BoundaryRule::eq16:
      return growEq16(parent);
    case BoundaryRule::drop:
      return growDrop(parent);
  }
  return {};
}

SplitResult zipBordered(const Topology& parent, BoundaryRule boundary) {
  switch (boundary) {
    case BoundaryRule::brick:
      return zipBrick(parent);
    case BoundaryRule::eq16:
      return zipEq16(parent);
    case BoundaryRule::drop:
      return zipDrop(parent);
  }
  return {};
}

}  // namespace

Split zip(BoundaryRule boundary) {
  Split split;
  split.name = "zip";
  split.cornerPlace = CornerPlace::edge;
  split.laterLinks = true;
  split.grow = [boundary](const Census& parent) { return grow(parent, boundary); };
  split.apply = [boundary](const Topology& parent) -> Result<SplitResult> {
    // Slots: three a half-edge and four a boundary edge.
    const std::int64_t slots = 3 * std::int64_t{parent.halfEdgeCount()} + 4 * std::int64_t{parent.boundaryEdgeCount()};
    if (auto fits = checkSlots(slots, parent); !fits) return tl::unexpected(fits.error());
    if (parent.closed()) return zipClosed(parent);
    if (boundary != BoundaryRule::brick && isCutByBrick(parent.runs().back().kind)) {
      return fail(ErrorCode::invalidOption,
                  "cells cut by the brick rule can't be refined by another boundary rule; use brick");
    }
    SplitResult result = zipBordered(parent, boundary);
    if (result.topology.faceCount() == 0) {
      return fail(ErrorCode::invalidMesh,
                  "the drop rule leaves nothing of this mesh; use fewer levels or another boundary rule");
    }
    return result;
  };
  return split;
}

}  // namespace honeycomb::Far
