#include "far/base/index.h"
#include "far/topology/splits/zip_rules.h"
#include "far/topology/splits/zip_slots.h"

/// Zhang and Wang, "Honeycomb Subdivision", section 4.2 and eq 16: every face gives a face; a boundary vertex with more
/// than two edges gives one too, closed by a new point v_b of its own; a boundary vertex with two edges gives none.
///     Y  v'_bin -> v_b,   Z  v_b -> v'_bout       on the boundary half-edge bin that enters the vertex
namespace honeycomb::Far {

namespace {

class Eq16Slots : public ZipSlots {
 public:
  using ZipSlots::ZipSlots;

  void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const override {
    for (const std::int32_t h : parent().halfEdgesOf(f)) slots.push_back(slot(h, A));
  }

  void vertexLoop(std::int32_t v, std::vector<std::int32_t>& slots) const override {
    if (!parent().keepsFace(v)) return;
    for (const std::int32_t h : parent().halfEdgesFrom(v)) {
      const std::int32_t p = parent().prev(h);
      slots.push_back(slot(h, C));
      if (parent().twin(p) >= 0) {
        slots.push_back(slot(p, B));
      } else {
        slots.push_back(slot(p, Y));
        slots.push_back(slot(p, Z));
      }
    }
  }

  std::int32_t start(std::int32_t s) const override {
    if (regular(s)) return s / 3;
    const std::int32_t b = boundaryEdge(s);
    return boundaryLetter(s) == Y ? b : ownPoint(parent().dest(b));
  }

  std::int32_t twin(std::int32_t s) const override {
    if (!regular(s)) return -1;
    const std::int32_t h = s / 3;
    switch (s % 3) {
      case A:
        return parent().keepsFace(parent().dest(h)) ? slot(parent().next(h), C) : -1;
      case B:
        return parent().keepsFace(parent().vert(h)) ? slot(parent().twin(h), B) : -1;
      default:
        return slot(parent().prev(h), A);
    }
  }

  std::vector<OtherPoint> otherPoints() const override {
    std::vector<OtherPoint> points;
    for (const std::int32_t b : parent().boundary()) {
      if (parent().keepsFace(parent().vert(b))) {
        points.push_back({ownPoint(parent().vert(b)), {PointKind::boundaryVertex, b}});
      }
    }
    return points;
  }

 private:
  std::int32_t ownPoint(std::int32_t v) const { return pointSlot(parent().outgoing(v), 0); }
};

}  // namespace

SplitResult zipEq16(const Topology& parent) {
  return assemble(Eq16Slots(parent));
}

}  // namespace honeycomb::Far
