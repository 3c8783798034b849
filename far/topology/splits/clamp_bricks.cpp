#include "far/topology/splits/clamp_bricks.h"

#include "far/base/index.h"
#include "far/topology/splits/slot_rule.h"

/// Slots of half-edge h, where c leaves the mid vertex between the face f and the next one, g, and t = twin(c):
///     A = 3h    as h in its face; of c: R_f -> q, of t: q -> L_g
///     B = 3h+1  opposite A in the gap: of c: q -> R_f, of t: L_g -> q
///     C = 3h+2  of c: R_f -> L_g in the gap
/// Vertex slots: v the vertex itself; V + 3r, V + 3r + 1, V + 3r + 2 the points next to the start and the end of
/// boundary edge r, and the corner it leaves.
namespace honeycomb::Far {

namespace {

class BrickClampSlots : public SlotRule {
 public:
  using SlotRule::SlotRule;

  std::int32_t slotCount() const override { return 3 * parent().halfEdgeCount(); }
  std::int32_t vertexSlotCount() const override { return parent().vertexCount() + 3 * parent().boundaryEdgeCount(); }
  bool hasCornerPoints() const override { return false; }

  FaceKind faceKind(std::int32_t f) const override {
    const std::int32_t first = parent().faceOffsets()[at(f)];
    if (parent().twin(first) >= 0) return FaceKind::full;
    return isFixed(parent().dest(first)) ? FaceKind::clampedCorner : FaceKind::clampedSide;
  }
  void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const override {
    for (const std::int32_t h : parent().halfEdgesOf(f)) slots.push_back(slot(h, A));
  }

  FaceKind vertexKind(std::int32_t) const override { return FaceKind::clampedGap; }
  void vertexLoop(std::int32_t v, std::vector<std::int32_t>& slots) const override {
    if (parent().vertexTag(v) != VertexTag::mid) return;
    const std::int32_t c = parent().nextOutgoing(parent().outgoing(v));
    slots.insert(slots.end(), {slot(c, C), slot(parent().twin(c), B), slot(c, B)});
  }

  std::int32_t start(std::int32_t s) const override {
    const std::int32_t h = s / 3;
    const bool leaving = leavesMid(h);
    switch (s % 3) {
      case A:
        return leaving ? pointSlot(parent().prev(h), kEnd) : cornerStart(h);
      case B:
        return leaving ? parent().dest(h) : pointSlot(parent().next(h), kStart);
      default:
        return pointSlot(parent().prev(h), kEnd);
    }
  }

  std::int32_t twin(std::int32_t s) const override {
    const std::int32_t h = s / 3;
    switch (s % 3) {
      case A:
        if (parent().twin(h) < 0) return -1;
        return leavesMid(h) || leavesMid(parent().twin(h)) ? slot(h, B) : slot(parent().twin(h), A);
      case B:
        return slot(h, A);
      default:
        return -1;
    }
  }

  std::vector<OtherPoint> otherPoints() const override {
    std::vector<OtherPoint> points;
    for (std::int32_t v = 0; v < parent().vertexCount(); ++v) {
      if (!parent().onBoundary(v)) points.push_back({v, {PointKind::vertexPoint, parent().outgoing(v)}});
    }
    for (const std::int32_t b : parent().boundary()) {
      if (isFixed(parent().vert(b))) {
        points.push_back({pointSlot(b, kFixed), {PointKind::fixedCorner, b}});
      } else {
        points.push_back({pointSlot(b, kStart), {PointKind::cutStart, b}});
      }
      if (!isFixed(parent().dest(b))) points.push_back({pointSlot(b, kEnd), {PointKind::cutEnd, b}});
    }
    return points;
  }

 private:
  enum Letter : std::int32_t { A, B, C };
  static constexpr std::int32_t kStart = 0, kEnd = 1, kFixed = 2;
  static std::int32_t slot(std::int32_t h, Letter letter) { return 3 * h + letter; }
  std::int32_t pointSlot(std::int32_t b, std::int32_t which) const {
    return parent().vertexCount() + 3 * rank(b) + which;
  }

  bool isFixed(std::int32_t v) const { return parent().vertexTag(v) == VertexTag::fixedCorner; }
  /// Is h the edge from a mid vertex to the inside?
  bool leavesMid(std::int32_t h) const {
    return parent().twin(h) >= 0 && parent().vertexTag(parent().vert(h)) == VertexTag::mid;
  }
  std::int32_t cornerStart(std::int32_t h) const {
    if (parent().twin(h) >= 0) return parent().vert(h);
    return pointSlot(h, isFixed(parent().vert(h)) ? kFixed : kStart);
  }
};

Census grow(const Census& p) {
  if (p.boundaryEdges == 0) return p;
  Census c;
  c.exact = p.exact;
  c.vertices = p.vertices - p.mid + 2 * p.cutMid + p.tipMid;
  c.faces = p.faces + p.mid;
  c.boundaryEdges = p.boundaryEdges + p.mid;
  c.gaps = p.mid;
  const std::int64_t euler = p.vertices - p.edges + p.faces;
  c.edges = c.vertices + c.faces - euler;
  c.halfEdges = 2 * c.edges - c.boundaryEdges;
  return c;
}

bool oneBrickStepBehind(const Topology& parent) {
  for (std::size_t rank = 0; rank < parent.boundary().size(); ++rank) {
    const VertexTag tag = parent.vertexTag(parent.vert(parent.boundary()[rank]));
    const bool mid = tag == VertexTag::mid || tag == VertexTag::fixedCorner;
    if (!mid || parent.boundaryTags()[rank] == EdgeTag::onLine) return false;
  }
  return true;
}

Result<SplitResult> apply(const Topology& parent) {
  const std::int64_t slots = 3 * (std::int64_t{parent.halfEdgeCount()} + parent.boundaryEdgeCount());
  if (const auto fits = checkSlots(slots, parent); !fits) return tl::unexpected(fits.error());
  if (!oneBrickStepBehind(parent)) {
    return fail(ErrorCode::invalidMesh,
                "the boundary of the mesh is not as one step of the brick rule leaves it; put one before this step");
  }
  return assemble(BrickClampSlots(parent));
}

}  // namespace

Split clampBricks() {
  return {"clamp-bricks", apply, grow};
}

}  // namespace honeycomb::Far
