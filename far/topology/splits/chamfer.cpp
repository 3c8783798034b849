#include "far/topology/splits/chamfer.h"

#include "far/topology/splits/chamfer_slots.h"
#include "far/topology/splits/closed_forms.h"

namespace honeycomb::Far {

namespace {

Census grow(const Census& p) {
  Census c;
  const std::int64_t inside = insideEdges(p);
  c.exact = p.exact && p.boundaryEdges == 0;  // how many boundary vertices have two edges is not known
  c.vertices = p.halfEdges + p.vertices;
  c.faces = p.faces + inside;
  c.halfEdges = p.halfEdges + 6 * inside;
  c.edges = 2 * p.halfEdges;
  c.boundaryEdges = p.boundaryEdges == 0 ? 0 : c.halfEdges;
  return c;
}

Result<SplitResult> apply(const Topology& parent) {
  const auto fits = checkSlots(4 * std::int64_t{parent.halfEdgeCount()}, parent);
  if (!fits) return tl::unexpected(fits.error());
  return parent.closed() ? chamferClosed(parent) : chamferBySlots(parent);
}

}  // namespace

SplitResult chamferBySlots(const Topology& parent) {
  return assemble(ChamferSlots(parent));
}

Split chamfer() {
  return {"chamfer", apply, grow};
}

}  // namespace honeycomb::Far
