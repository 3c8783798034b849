#pragma once

#include "far/topology/splits/slot_rule.h"

namespace honeycomb::Far {

/// What the zip rules on a mesh with a boundary share. Every old half-edge h has the slots A = 3h, B = 3h+1, C = 3h+2
/// of zip_closed.cpp; every boundary edge b of rank r has four more, X = 3H+4r .. W = 3H+4r+3. New vertices have slots
/// too: h for the corner point v'_h, and H+3r .. H+3r+2 for the points of boundary edge b.
class ZipSlots : public SlotRule {
 public:
  explicit ZipSlots(const Topology& parent) : SlotRule(parent), halfEdges_(parent.halfEdgeCount()) {}

  std::int32_t slotCount() const override { return 3 * halfEdges_ + 4 * parent().boundaryEdgeCount(); }
  std::int32_t vertexSlotCount() const override { return halfEdges_ + 3 * parent().boundaryEdgeCount(); }
  bool makesThreeValent() const override { return parent().closed(); }

 protected:
  enum Letter : std::int32_t { A, B, C };
  enum BoundaryLetter : std::int32_t { X, Y, Z, W };
  static std::int32_t slot(std::int32_t h, Letter letter) { return 3 * h + letter; }
  std::int32_t slot(std::int32_t b, BoundaryLetter letter) const { return 3 * halfEdges_ + 4 * rank(b) + letter; }
  std::int32_t pointSlot(std::int32_t b, std::int32_t which) const { return halfEdges_ + 3 * rank(b) + which; }
  bool regular(std::int32_t slot) const { return slot < 3 * halfEdges_; }
  /// Of a slot with a BoundaryLetter: its edge and letter.
  std::int32_t boundaryEdge(std::int32_t slot) const {
    return parent().boundary()[static_cast<std::size_t>((slot - 3 * halfEdges_) / 4)];
  }
  BoundaryLetter boundaryLetter(std::int32_t slot) const {
    return static_cast<BoundaryLetter>((slot - 3 * halfEdges_) % 4);
  }

 private:
  std::int32_t halfEdges_;
};

}  // namespace honeycomb::Far
