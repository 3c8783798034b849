#include "far/topology/splits/dual.h"

#include <fmt/format.h>

#include "far/base/index.h"
#include "far/topology/splits/closed_forms.h"
#include "far/topology/splits/slot_rule.h"

/// Slot h, of half-edge h of vertex v: from the vertex of face(h) to that of the next face round v, in the face of v.
/// The vertex of a face has the face's number.
namespace honeycomb::Far {

namespace {

class DualSlots : public SlotRule {
 public:
  using SlotRule::SlotRule;

  std::int32_t slotCount() const override { return parent().halfEdgeCount(); }
  std::int32_t vertexSlotCount() const override { return parent().faceCount(); }
  bool hasCornerPoints() const override { return false; }

  void faceLoop(std::int32_t, std::vector<std::int32_t>&) const override {}
  void vertexLoop(std::int32_t v, std::vector<std::int32_t>& slots) const override {
    if (parent().onBoundary(v)) return;
    for (const std::int32_t h : parent().halfEdgesFrom(v)) slots.push_back(h);
  }

  std::int32_t start(std::int32_t s) const override { return parent().face(s); }
  std::int32_t twin(std::int32_t s) const override {
    const std::int32_t p = parent().prev(s);
    return parent().onBoundary(parent().vert(p)) ? -1 : parent().next(parent().twin(p));
  }

  std::vector<OtherPoint> otherPoints() const override {
    std::vector<OtherPoint> points;
    for (std::int32_t f = 0; f < parent().faceCount(); ++f) {
      if (insideRuns(parent(), f) >= 0) points.push_back({f, {PointKind::faceCentre, parent().faceOffsets()[at(f)]}});
    }
    return points;
  }

  /// How many runs of inside vertices a face has between boundary vertices: 0 when all are inside, -1 when none is.
  static std::int32_t insideRuns(const Topology& topology, std::int32_t f) {
    std::int32_t runs = 0;
    bool any = false;
    for (const std::int32_t h : topology.halfEdgesOf(f)) {
      const bool inside = !topology.onBoundary(topology.vert(h));
      any = any || inside;
      if (inside && topology.onBoundary(topology.dest(h))) ++runs;
    }
    return any ? runs : -1;
  }
};

Result<void> check(const Topology& parent) {
  if (const auto sound = checkVertexFaces(parent); !sound) return sound;
  if (parent.closed()) return {};
  bool any = false;
  for (std::int32_t v = 0; v < parent.vertexCount() && !any; ++v) any = !parent.onBoundary(v);
  if (!any) {
    return fail(ErrorCode::invalidMesh,
                "every vertex is on a boundary, so the dual has no faces; give a larger mesh or convert it otherwise");
  }
  for (std::int32_t f = 0; f < parent.faceCount(); ++f) {
    if (DualSlots::insideRuns(parent, f) < 2) continue;
    return fail(ErrorCode::invalidMesh,
                fmt::format("{} has vertices inside the mesh that lie apart, so the dual would have a bow-tie there; "
                            "split the face or convert otherwise",
                            elementName(ElementKind::face, parent.inputFace(f))),
                parent.inputFace(f), ElementKind::face);
  }
  return {};
}

Census grow(const Census& p) {
  Census c;
  c.exact = p.exact && p.boundaryEdges == 0;
  c.vertices = p.faces;
  c.faces = p.vertices;
  c.edges = p.edges;
  c.halfEdges = p.halfEdges;
  c.boundaryEdges = p.boundaryEdges == 0 ? 0 : p.halfEdges;
  return c;
}

Result<SplitResult> apply(const Topology& parent) {
  if (const auto sound = check(parent); !sound) return tl::unexpected(sound.error());
  return parent.closed() ? dualClosed(parent) : dualBySlots(parent);
}

}  // namespace

SplitResult dualBySlots(const Topology& parent) {
  return assemble(DualSlots(parent));
}

Split dualSplit() {
  return {"dual", apply, grow};
}

}  // namespace honeycomb::Far
