#pragma once

#include <cstdint>
#include <vector>

#include "far/topology/split.h"

namespace honeycomb::Far {

/// A refinement rule as slots: every half-edge and every vertex that the rule may make has a number of its own by index
/// algebra from the parent's half-edges. Which slots are alive, and where they stand in the loops of the new faces, is
/// the rule's business, one file each; assemble() numbers the live ones by scans, in slot order.
class SlotRule {
 public:
  explicit SlotRule(const Topology& parent) : parent_(parent), rank_(boundaryRanks(parent)) {}
  virtual ~SlotRule() = default;
  SlotRule(const SlotRule&) = delete;
  SlotRule& operator=(const SlotRule&) = delete;

  /// Numbers of half-edge and of vertex slots.
  virtual std::int32_t slotCount() const = 0;
  virtual std::int32_t vertexSlotCount() const = 0;

  /// Appends the slots of the face that face f of the parent becomes, in order; none if it vanishes.
  virtual void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const = 0;
  /// The slots of the face that vertex v of the parent becomes.
  virtual void vertexLoop(std::int32_t, std::vector<std::int32_t>&) const {}
  /// The slots of the face that the edge of half-edge h becomes; h is the lower of the two, or on the boundary.
  virtual void edgeLoop(std::int32_t, std::vector<std::int32_t>&) const {}
  /// Does any edge become a face?
  virtual bool hasEdgeFaces() const { return false; }
  virtual FaceKind faceKind(std::int32_t) const { return FaceKind::full; }
  virtual FaceKind vertexKind(std::int32_t) const { return FaceKind::full; }
  virtual FaceKind edgeKind(std::int32_t) const { return FaceKind::full; }
  /// The vertex slot that a live half-edge slot starts at.
  virtual std::int32_t start(std::int32_t slot) const = 0;
  /// The live slot opposite a live slot, -1 on the new boundary.
  virtual std::int32_t twin(std::int32_t slot) const = 0;
  /// Of a live slot on the new boundary.
  virtual EdgeTag edgeTag(std::int32_t) const { return EdgeTag::onLine; }
  /// Of a vertex slot on the new boundary.
  virtual VertexTag vertexTag(std::int32_t) const { return VertexTag::real; }

  /// Do the half-edges of whole face-faces start at corner points, one each, which then take their numbers?
  virtual bool hasCornerPoints() const { return true; }
  /// Is the child closed, with three edges at every vertex?
  virtual bool makesThreeValent() const { return false; }
  /// The other live vertex slots, in the order of their numbers, and what they are.
  struct OtherPoint {
    std::int32_t slot;
    NewPoint point;
  };
  virtual std::vector<OtherPoint> otherPoints() const { return {}; }

  const Topology& parent() const { return parent_; }

 protected:
  /// The place of boundary half-edge b among them.
  std::int32_t rank(std::int32_t b) const { return rank_[static_cast<std::size_t>(b)]; }

 private:
  const Topology& parent_;
  std::vector<std::int32_t> rank_;
};

/// Lays the live slots out as loops of sorted faces: whole face-faces in the parent's order, whole vertex-faces and
/// edge-faces by side count, then the faces cut by the boundary by kind, parent and side count.
SplitResult assemble(const SlotRule& rule);

/// tooLarge when a level of that many half-edge slots would pass 2^31 - 1.
Result<void> checkSlots(std::int64_t slots, const Topology& parent);

/// invalidMesh, the vertex as element, when an inside vertex has fewer than three edges: the face it becomes under a
/// split that gives it a side an edge would be none.
Result<void> checkVertexFaces(const Topology& parent);

}  // namespace honeycomb::Far
