#include "far/topology/splits/ambo.h"

#include "far/base/index.h"
#include "far/topology/splits/closed_forms.h"
#include "far/topology/splits/slot_rule.h"

/// Slots of half-edge h, with n and p the next and previous half-edge and e(h) the vertex of its edge, which has the
/// number of the edge's lower half-edge:
///     A = 2h    e(h) -> e(n)   in face(h)
///     B = 2h+1  e(n) -> e(h)   in the face of the vertex that h enters
/// A boundary half-edge b of rank r:
///     Z = 2H+r  e(b) -> e(the boundary half-edge that follows)   in the face of the vertex that b enters
namespace honeycomb::Far {

namespace {

class AmboSlots : public SlotRule {
 public:
  using SlotRule::SlotRule;

  std::int32_t slotCount() const override { return 2 * parent().halfEdgeCount() + parent().boundaryEdgeCount(); }
  std::int32_t vertexSlotCount() const override { return parent().halfEdgeCount(); }
  bool hasCornerPoints() const override { return false; }

  void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const override {
    for (const std::int32_t h : parent().halfEdgesOf(f)) slots.push_back(slot(h, A));
  }

  void vertexLoop(std::int32_t v, std::vector<std::int32_t>& slots) const override {
    if (!parent().keepsFace(v)) return;
    for (const std::int32_t h : parent().halfEdgesFrom(v)) {
      const std::int32_t p = parent().prev(h);
      slots.push_back(slot(p, B));
      if (parent().twin(p) < 0) slots.push_back(closing(p));
    }
  }

  std::int32_t start(std::int32_t s) const override {
    if (s >= 2 * parent().halfEdgeCount()) return parent().boundary()[at(s - 2 * parent().halfEdgeCount())];
    return edge(s % 2 == A ? s / 2 : parent().next(s / 2));
  }

  std::int32_t twin(std::int32_t s) const override {
    if (s >= 2 * parent().halfEdgeCount()) return -1;
    const std::int32_t h = s / 2;
    if (s % 2 == B) return slot(h, A);
    return parent().keepsFace(parent().dest(h)) ? slot(h, B) : -1;
  }

  std::vector<OtherPoint> otherPoints() const override {
    std::vector<OtherPoint> points;
    for (std::int32_t h = 0; h < parent().halfEdgeCount(); ++h) {
      if (parent().leads(h)) points.push_back({h, {PointKind::edgeMiddle, h}});
    }
    return points;
  }

 private:
  enum Letter : std::int32_t { A, B };
  static std::int32_t slot(std::int32_t h, Letter letter) { return 2 * h + letter; }
  std::int32_t closing(std::int32_t b) const { return 2 * parent().halfEdgeCount() + rank(b); }
  std::int32_t edge(std::int32_t h) const { return parent().leads(h) ? h : parent().twin(h); }
};

Census grow(const Census& p) {
  Census c;
  c.exact = p.exact && p.boundaryEdges == 0;  // how many boundary vertices have a single face is not known
  c.vertices = p.edges;
  c.faces = p.faces + p.vertices;
  c.halfEdges = 2 * p.halfEdges + p.boundaryEdges;
  c.boundaryEdges = p.boundaryEdges;  // one each, with a face of the vertex or without
  c.edges = (c.halfEdges + c.boundaryEdges) / 2;
  return c;
}

Result<SplitResult> apply(const Topology& parent) {
  const auto fits = checkSlots(2 * std::int64_t{parent.halfEdgeCount()} + parent.boundaryEdgeCount(), parent);
  if (!fits) return tl::unexpected(fits.error());
  if (const auto sound = checkVertexFaces(parent); !sound) return tl::unexpected(sound.error());
  return parent.closed() ? amboClosed(parent) : amboBySlots(parent);
}

}  // namespace

SplitResult amboBySlots(const Topology& parent) {
  return assemble(AmboSlots(parent));
}

Split ambo() {
  return {"ambo", apply, grow};
}

}  // namespace honeycomb::Far
