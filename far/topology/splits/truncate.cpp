#include "far/topology/splits/truncate.h"

#include "far/base/index.h"
#include "far/topology/splits/closed_forms.h"
#include "far/topology/splits/slot_rule.h"

/// Slots of half-edge h, with n the next half-edge and t its twin; x_h = h is the point of its edge next to the vertex
/// it leaves, x_t that next to the vertex it enters (H+r on a boundary half-edge of rank r):
///     A = 3h    x_h -> x_t   in face(h)
///     B = 3h+1  x_t -> x_n   in face(h)
///     C = 3h+2  x_n -> x_t   in the face of the vertex that h enters
/// A boundary half-edge b of rank r:
///     Z = 3H+r  x_t -> x of the boundary half-edge that follows   in the face of the vertex that b enters
namespace honeycomb::Far {

namespace {

class TruncateSlots : public SlotRule {
 public:
  using SlotRule::SlotRule;

  std::int32_t slotCount() const override { return 3 * parent().halfEdgeCount() + parent().boundaryEdgeCount(); }
  std::int32_t vertexSlotCount() const override { return parent().halfEdgeCount() + parent().boundaryEdgeCount(); }
  bool hasCornerPoints() const override { return false; }
  bool makesThreeValent() const override { return parent().closed(); }

  void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const override {
    for (const std::int32_t h : parent().halfEdgesOf(f)) {
      slots.push_back(slot(h, A));
      slots.push_back(slot(h, B));
    }
  }

  void vertexLoop(std::int32_t v, std::vector<std::int32_t>& slots) const override {
    if (!parent().keepsFace(v)) return;
    for (const std::int32_t h : parent().halfEdgesFrom(v)) {
      const std::int32_t p = parent().prev(h);
      slots.push_back(slot(p, C));
      if (parent().twin(p) < 0) slots.push_back(3 * parent().halfEdgeCount() + rank(p));
    }
  }

  std::int32_t start(std::int32_t s) const override {
    if (s >= 3 * parent().halfEdgeCount()) return farPoint(parent().boundary()[at(s - 3 * parent().halfEdgeCount())]);
    const std::int32_t h = s / 3;
    switch (s % 3) {
      case A:
        return h;
      case B:
        return farPoint(h);
      default:
        return parent().next(h);
    }
  }

  std::int32_t twin(std::int32_t s) const override {
    if (s >= 3 * parent().halfEdgeCount()) return -1;
    const std::int32_t h = s / 3;
    switch (s % 3) {
      case A:
        return parent().twin(h) < 0 ? -1 : slot(parent().twin(h), A);
      case B:
        return parent().keepsFace(parent().dest(h)) ? slot(h, C) : -1;
      default:
        return slot(h, B);
    }
  }

  std::vector<OtherPoint> otherPoints() const override {
    std::vector<OtherPoint> points;
    for (std::int32_t h = 0; h < parent().halfEdgeCount(); ++h) points.push_back({h, {PointKind::edgeStart, h}});
    for (const std::int32_t b : parent().boundary()) points.push_back({farPoint(b), {PointKind::edgeEnd, b}});
    return points;
  }

 private:
  enum Letter : std::int32_t { A, B, C };
  static std::int32_t slot(std::int32_t h, Letter letter) { return 3 * h + letter; }
  std::int32_t farPoint(std::int32_t h) const {
    return parent().twin(h) < 0 ? parent().halfEdgeCount() + rank(h) : parent().twin(h);
  }
};

Census grow(const Census& p) {
  Census c;
  c.exact = p.exact && p.boundaryEdges == 0;  // how many boundary vertices have a single face is not known
  c.vertices = p.halfEdges + p.boundaryEdges;
  c.faces = p.faces + p.vertices;
  c.halfEdges = 3 * p.halfEdges + p.boundaryEdges;
  c.boundaryEdges = 2 * p.boundaryEdges;
  c.edges = (c.halfEdges + c.boundaryEdges) / 2;
  return c;
}

Result<SplitResult> apply(const Topology& parent) {
  const auto fits = checkSlots(3 * std::int64_t{parent.halfEdgeCount()} + parent.boundaryEdgeCount(), parent);
  if (!fits) return tl::unexpected(fits.error());
  if (const auto sound = checkVertexFaces(parent); !sound) return tl::unexpected(sound.error());
  return parent.closed() ? truncateClosed(parent) : truncateBySlots(parent);
}

}  // namespace

SplitResult truncateBySlots(const Topology& parent) {
  return assemble(TruncateSlots(parent));
}

Split truncate() {
  return {"truncate", apply, grow};
}

}  // namespace honeycomb::Far
