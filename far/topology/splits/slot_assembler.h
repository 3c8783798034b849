#pragma once

#include <cstdint>
#include <vector>

#include "far/topology/split.h"

namespace honeycomb::Far {

/// A zip rule on a mesh with a boundary, as slots. Every old half-edge h has the slots A = 3h, B = 3h+1, C = 3h+2 of
/// zip_closed.cpp; every boundary edge b of rank r has four more, X = 3H+4r .. W = 3H+4r+3. New vertices have slots
/// too: h for the corner point v'_h, and H+3r .. H+3r+2 for the points of boundary edge b. Which slots are alive, and
/// where they stand in the loops, is the rule's business; numbers are given by scans in slot order.
class ZipSlots {
 public:
  explicit ZipSlots(const Topology& parent)
      : parent_(parent), rank_(boundaryRanks(parent)), halfEdges_(parent.halfEdgeCount()) {}
  virtual ~ZipSlots() = default;
  ZipSlots(const ZipSlots&) = delete;
  ZipSlots& operator=(const ZipSlots&) = delete;

  /// The slots of the face that face f of the parent becomes, in order; none if it vanishes.
  virtual void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const = 0;
  /// The slots of the face that vertex v of the parent becomes.
  virtual void vertexLoop(std::int32_t v, std::vector<std::int32_t>& slots) const = 0;
  virtual FaceKind faceKind(std::int32_t) const { return FaceKind::full; }
  virtual FaceKind vertexKind(std::int32_t) const { return FaceKind::full; }
  /// The vertex slot that a live half-edge slot starts at.
  virtual std::int32_t start(std::int32_t slot) const = 0;
  /// The live slot opposite a live slot, -1 on the new boundary.
  virtual std::int32_t twin(std::int32_t slot) const = 0;
  /// Of a live slot on the new boundary.
  virtual EdgeTag edgeTag(std::int32_t) const { return EdgeTag::onLine; }
  /// Of a vertex slot on the new boundary.
  virtual VertexTag vertexTag(std::int32_t) const { return VertexTag::real; }
  /// The live vertex slots that are not corner points of whole face-faces, in slot order, and what they are.
  struct OtherPoint {
    std::int32_t slot;
    NewPoint point;
  };
  virtual std::vector<OtherPoint> otherPoints() const { return {}; }

  const Topology& parent() const { return parent_; }
  std::int32_t slotCount() const { return 3 * halfEdges_ + 4 * parent_.boundaryEdgeCount(); }
  std::int32_t vertexSlotCount() const { return halfEdges_ + 3 * parent_.boundaryEdgeCount(); }

 protected:
  enum Letter : std::int32_t { A, B, C };
  enum BoundaryLetter : std::int32_t { X, Y, Z, W };
  static std::int32_t slot(std::int32_t h, Letter letter) { return 3 * h + letter; }
  std::int32_t slot(std::int32_t b, BoundaryLetter letter) const { return 3 * halfEdges_ + 4 * rank(b) + letter; }
  std::int32_t pointSlot(std::int32_t b, std::int32_t which) const { return halfEdges_ + 3 * rank(b) + which; }
  std::int32_t rank(std::int32_t b) const { return rank_[static_cast<std::size_t>(b)]; }
  bool regular(std::int32_t slot) const { return slot < 3 * halfEdges_; }
  /// Of a slot with a BoundaryLetter: its edge and letter.
  std::int32_t boundaryEdge(std::int32_t slot) const {
    return parent_.boundary()[static_cast<std::size_t>((slot - 3 * halfEdges_) / 4)];
  }
  BoundaryLetter boundaryLetter(std::int32_t slot) const {
    return static_cast<BoundaryLetter>((slot - 3 * halfEdges_) % 4);
  }

 private:
  const Topology& parent_;
  std::vector<std::int32_t> rank_;
  std::int32_t halfEdges_;
};

/// Lays the live slots out as loops of sorted faces: whole face-faces in the parent's order, whole vertex-faces by
/// side count, then the faces cut by the boundary by kind, parent and side count.
SplitResult assemble(const ZipSlots& slots);

}  // namespace honeycomb::Far
