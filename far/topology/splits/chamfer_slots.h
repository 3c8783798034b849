#pragma once

#include "far/topology/splits/slot_rule.h"

namespace honeycomb::Far {

/// Slots of half-edge h of vertex v, with n and p the next and previous half-edge of h and t its twin:
///     s1(h) = h   the corner of h in the new face of face(h)          s2(v) = H + v   the new place of v
///     A = 4h    s1(h) -> s1(n)   in face(h)          C = 4h+2  s1(h) -> s2(v)   in the hexagon of h
///     B = 4h+1  s1(n) -> s1(h)   in the hexagon of h  D = 4h+3  s2(v) -> s1(h)   in the hexagon of p
/// The hexagon of edge h from v to w:  s2(v), s1(next t), s1(t), s2(w), s1(n), s1(h).
class ChamferSlots : public SlotRule {
 public:
  using SlotRule::SlotRule;

  std::int32_t slotCount() const override { return 4 * parent().halfEdgeCount(); }
  std::int32_t vertexSlotCount() const override { return parent().halfEdgeCount() + parent().vertexCount(); }

  void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const override {
    for (const std::int32_t h : parent().halfEdgesOf(f)) slots.push_back(slot(h, A));
  }

  bool makesThreeValent() const override { return parent().threeValent(); }
  bool hasEdgeFaces() const override { return true; }
  void edgeLoop(std::int32_t h, std::vector<std::int32_t>& slots) const override {
    const std::int32_t t = parent().twin(h);
    if (t < 0) return;
    slots.insert(slots.end(), {slot(parent().next(t), D), slot(t, B), slot(t, C), slot(parent().next(h), D), slot(h, B),
                               slot(h, C)});
  }

  std::int32_t start(std::int32_t s) const override {
    const std::int32_t h = s / 4;
    switch (s % 4) {
      case B:
        return parent().next(h);
      case D:
        return parent().halfEdgeCount() + parent().vert(h);
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
        return parent().twin(parent().prev(h)) < 0 ? -1 : slot(h, D);
      default:
        return parent().twin(h) < 0 ? -1 : slot(h, C);
    }
  }

  std::vector<OtherPoint> otherPoints() const override {
    std::vector<OtherPoint> points;
    for (std::int32_t v = 0; v < parent().vertexCount(); ++v) {
      if (!parent().keepsFace(v)) continue;
      points.push_back({parent().halfEdgeCount() + v, {PointKind::vertexPoint, parent().outgoing(v)}});
    }
    return points;
  }

 protected:
  enum Letter : std::int32_t { A, B, C, D };
  static std::int32_t slot(std::int32_t h, Letter letter) { return 4 * h + letter; }
};

}  // namespace honeycomb::Far
