#include "far/topology/splits/expand.h"

#include "far/base/index.h"
#include "far/topology/splits/closed_forms.h"
#include "far/topology/splits/slot_rule.h"

/// Slots of half-edge h of vertex v, with n and p the next and previous half-edge of h and t its twin; x_h is the
/// corner of h in the new face of face(h):
///     A = 4h    x_h -> x_n        in face(h)       C = 4h+2  x_h -> x_{next t}   in the quad of h
///     B = 4h+1  x_n -> x_h        in the quad of h  D = 4h+3  x_{next t} -> x_h   in the face of v
namespace honeycomb::Far {

namespace {

class ExpandSlots : public SlotRule {
 public:
  using SlotRule::SlotRule;

  std::int32_t slotCount() const override { return 4 * parent().halfEdgeCount(); }
  std::int32_t vertexSlotCount() const override { return parent().halfEdgeCount(); }

  void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const override {
    for (const std::int32_t h : parent().halfEdgesOf(f)) slots.push_back(slot(h, A));
  }

  void vertexLoop(std::int32_t v, std::vector<std::int32_t>& slots) const override {
    if (parent().onBoundary(v)) return;
    for (const std::int32_t h : parent().halfEdgesFrom(v)) slots.push_back(slot(h, D));
  }

  bool hasEdgeFaces() const override { return true; }
  void edgeLoop(std::int32_t h, std::vector<std::int32_t>& slots) const override {
    const std::int32_t t = parent().twin(h);
    if (t >= 0) slots.insert(slots.end(), {slot(h, B), slot(h, C), slot(t, B), slot(t, C)});
  }

  std::int32_t start(std::int32_t s) const override {
    const std::int32_t h = s / 4;
    switch (s % 4) {
      case B:
        return parent().next(h);
      case D:
        return parent().next(parent().twin(h));
      default:
        return h;
    }
  }

  std::int32_t twin(std::int32_t s) const override {
    const std::int32_t h = s / 4;
    switch (s % 4) {
      case A:
        return parent().twin(h) < 0 ? -1 : slot(h, B);
      case B:
        return slot(h, A);
      case C:
        return parent().onBoundary(parent().vert(h)) ? -1 : slot(h, D);
      default:
        return slot(h, C);
    }
  }

 private:
  enum Letter : std::int32_t { A, B, C, D };
  static std::int32_t slot(std::int32_t h, Letter letter) { return 4 * h + letter; }
};

Census grow(const Census& p) {
  Census c;
  const std::int64_t inside = insideEdges(p);
  c.exact = p.exact && p.boundaryEdges == 0;  // how many edges meet the boundary is not known
  c.vertices = p.halfEdges;
  c.faces = p.faces + inside + p.vertices - (p.exact ? p.real + p.mid + p.corner + p.fixedCorner : 0);
  c.halfEdges = p.halfEdges + 6 * inside;
  c.edges = p.halfEdges + 2 * inside;
  c.boundaryEdges = p.boundaryEdges == 0 ? 0 : c.halfEdges;
  return c;
}

Result<SplitResult> apply(const Topology& parent) {
  const auto fits = checkSlots(4 * std::int64_t{parent.halfEdgeCount()}, parent);
  if (!fits) return tl::unexpected(fits.error());
  if (const auto sound = checkVertexFaces(parent); !sound) return tl::unexpected(sound.error());
  return parent.closed() ? expandClosed(parent) : expandBySlots(parent);
}

}  // namespace

SplitResult expandBySlots(const Topology& parent) {
  return assemble(ExpandSlots(parent));
}

Split expand() {
  return {"expand", apply, grow};
}

}  // namespace honeycomb::Far
