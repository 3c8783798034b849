#include "far/base/index.h"
#include "far/topology/splits/zip_rules.h"
#include "far/topology/splits/zip_slots.h"

/// The brick rule: the boundary is a mirror line. Cells on it are cut in half, in the spirit of the half polygons of
/// Beets et al. and of Akleman and Srinivasan's bricklayers. With n and p the next and previous half-edge of h:
///     points of boundary edge b:  m (an edge on the line: its middle), or P_o and P_d (a cut: next to its ends); c' a
///     corner that stays. A half-edge beside a mid vertex has no corner point of its own: v'_{p b} = P_o, v'_{n b} =
///     P_d. A  as inside; of a cut: P_o -> P_d (real ends), P_o -> c' or c' -> P_d at a corner B  v'_h -> m for an edge
///     on the line, else as inside C  as inside; starts at P_o for a cut X  P_d -> v'_n, of a cut with real ends Y  m
///     -> v'_b in the face of the vertex that b leaves Z  m or P_d -> the first point of that vertex's face, the new
///     cut (at a corner: -> c') W  c' -> that first point
/// Half faces start with their cut, corner faces with the two edges at their corner.
namespace honeycomb::Far {

namespace {

class BrickSlots : public ZipSlots {
 public:
  using ZipSlots::ZipSlots;

  FaceKind faceKind(std::int32_t f) const override {
    const std::int32_t h = parent().faceOffsets()[at(f)];
    if (!isCut(h)) return FaceKind::full;
    return tagOf(h) == EdgeTag::cut ? FaceKind::half : FaceKind::corner;
  }

  FaceKind vertexKind(std::int32_t v) const override {
    switch (parent().vertexTag(v)) {
      case VertexTag::real:
        return FaceKind::half;
      case VertexTag::corner:
        return FaceKind::corner;
      default:
        return FaceKind::full;
    }
  }

  void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const override {
    const std::int32_t first = parent().faceOffsets()[at(f)];
    const std::int32_t end = parent().faceOffsets()[at(f) + 1];
    std::int32_t h = first;
    std::int32_t last = end;
    const FaceKind kind = faceKind(f);
    if (kind != FaceKind::full) {
      // The cut (or the two parts of it at a corner) is h = first .. lastCut.
      const std::int32_t lastCut = kind == FaceKind::half ? first : first + 1;
      const bool mid = parent().vertexTag(parent().vert(first)) == VertexTag::mid;
      slots.push_back(slot(mid ? end - 1 : first, A));
      if (kind == FaceKind::corner) slots.push_back(slot(lastCut, A));
      if (!mid) slots.push_back(slot(lastCut, X));
      h = lastCut + 1;
      last = mid ? end - 1 : end;
    }
    for (; h < last; ++h) slots.push_back(slot(h, A));
  }

  void vertexLoop(std::int32_t v, std::vector<std::int32_t>& slots) const override {
    if (!own(v)) return;
    const std::int32_t first = parent().outgoing(v);
    if (parent().onBoundary(v)) {
      const std::int32_t entering = parent().enteringBoundary(v);
      slots.push_back(slot(entering, Z));
      if (parent().vertexTag(v) == VertexTag::corner) slots.push_back(slot(entering, W));
      if (!isCut(first)) slots.push_back(slot(first, Y));
    }
    for (const std::int32_t h : parent().halfEdgesFrom(v)) {
      const std::int32_t p = parent().prev(h);
      slots.push_back(slot(h, C));
      if (!isCut(p)) slots.push_back(slot(p, B));
    }
  }

  std::int32_t start(std::int32_t s) const override {
    if (!regular(s)) return boundaryStart(s);
    const std::int32_t h = s / 3;
    if (!isCut(h)) return cornerPoint(h);
    const bool fromCorner = s % 3 == A && parent().vertexTag(parent().vert(h)) == VertexTag::fixedCorner;
    return pointSlot(h, fromCorner ? kFixed : kStart);
  }

  std::int32_t twin(std::int32_t s) const override {
    if (!regular(s)) return boundaryTwin(s);
    const std::int32_t h = s / 3;
    switch (s % 3) {
      case A:
        return faceEdgeTwin(h);
      case B:
        if (parent().twin(h) < 0) return slot(h, Y);
        return own(parent().vert(h)) ? slot(parent().twin(h), B) : -1;
      default: {
        const std::int32_t p = parent().prev(h);
        return isCut(p) ? slot(p, X) : slot(p, A);
      }
    }
  }

  EdgeTag edgeTag(std::int32_t s) const override {
    if (regular(s)) {
      const std::int32_t h = s / 3;
      if (s % 3 == B) return EdgeTag::onLine;
      return isCut(h) ? tagOf(h) : tagOf(parent().next(h));
    }
    const bool corner = parent().vertexTag(parent().dest(boundaryEdge(s))) == VertexTag::corner;
    return corner ? EdgeTag::cutToCorner : EdgeTag::cut;
  }

  VertexTag vertexTag(std::int32_t vertexSlot) const override {
    const std::int32_t local = vertexSlot - parent().halfEdgeCount();
    if (local < 0) return VertexTag::interior;
    const std::int32_t b = parent().boundary()[at(local / 3)];
    if (local % 3 == kFixed) return VertexTag::fixedCorner;
    if (!isCut(b)) return VertexTag::mid;
    const std::int32_t end = local % 3 == kStart ? parent().vert(b) : parent().dest(b);
    return parent().vertexTag(end) == VertexTag::mid ? VertexTag::real : VertexTag::mid;
  }

  std::vector<OtherPoint> otherPoints() const override {
    std::vector<OtherPoint> points;
    for (const FaceRun& run : parent().runs()) {
      if (!isCutByBrick(run.kind)) continue;
      const PointKind kind = run.kind == FaceKind::half ? PointKind::halfFaceCorner : PointKind::cornerFaceCorner;
      for (std::int32_t h = run.firstHalfEdge; h < run.firstHalfEdge + run.faceCount * run.sides; ++h) {
        if (!isCut(h) && cornerPoint(h) == h) points.push_back({h, {kind, h}});
      }
    }
    for (const std::int32_t b : parent().boundary()) appendEdgePoints(b, points);
    return points;
  }

 private:
  /// The points of a boundary edge: its middle or the start of a cut, the end of a cut, the corner it leaves.
  static constexpr std::int32_t kStart = 0, kEnd = 1, kFixed = 2;

  bool isCut(std::int32_t h) const { return parent().twin(h) < 0 && tagOf(h) != EdgeTag::onLine; }
  EdgeTag tagOf(std::int32_t b) const { return parent().boundaryTags()[at(rank(b))]; }

  /// Does v become a face?
  bool own(std::int32_t v) const {
    const VertexTag tag = parent().vertexTag(v);
    return tag != VertexTag::mid && tag != VertexTag::fixedCorner;
  }

  /// The vertex slot of v'_h, h not a cut.
  std::int32_t cornerPoint(std::int32_t h) const {
    const std::int32_t n = parent().next(h);
    if (isCut(n) && parent().vertexTag(parent().vert(n)) == VertexTag::mid) return pointSlot(n, kStart);
    const std::int32_t p = parent().prev(h);
    if (isCut(p) && parent().vertexTag(parent().vert(h)) == VertexTag::mid) return pointSlot(p, kEnd);
    return h;
  }

  std::int32_t boundaryStart(std::int32_t s) const {
    const std::int32_t b = boundaryEdge(s);
    switch (boundaryLetter(s)) {
      case X:
        return pointSlot(b, kEnd);
      case Y:
        return pointSlot(b, kStart);
      case Z:
        return pointSlot(b, isCut(b) ? kEnd : kStart);
      default:
        return pointSlot(parent().outgoing(parent().dest(b)), kFixed);
    }
  }

  std::int32_t boundaryTwin(std::int32_t s) const {
    const std::int32_t b = boundaryEdge(s);
    switch (boundaryLetter(s)) {
      case X:
        return slot(parent().next(b), C);
      case Y:
        return slot(b, B);
      default:
        return -1;
    }
  }

  std::int32_t faceEdgeTwin(std::int32_t h) const {
    if (isCut(h)) return -1;
    return own(parent().dest(h)) ? slot(parent().next(h), C) : -1;
  }

  void appendEdgePoints(std::int32_t b, std::vector<OtherPoint>& points) const {
    const VertexTag from = parent().vertexTag(parent().vert(b));
    if (!isCut(b)) {
      points.push_back({pointSlot(b, kStart), {PointKind::edgeMiddle, b}});
    } else {
      if (from != VertexTag::fixedCorner) points.push_back({pointSlot(b, kStart), {PointKind::cutStart, b}});
      if (parent().vertexTag(parent().dest(b)) != VertexTag::fixedCorner) {
        points.push_back({pointSlot(b, kEnd), {PointKind::cutEnd, b}});
      }
    }
    if (from == VertexTag::corner || from == VertexTag::fixedCorner) {
      points.push_back({pointSlot(b, kFixed), {PointKind::fixedCorner, b}});
    }
  }
};

}  // namespace

SplitResult zipBrick(const Topology& parent) {
  return assemble(BrickSlots(parent));
}

}  // namespace honeycomb::Far
