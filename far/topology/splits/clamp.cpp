#include "far/topology/splits/clamp.h"

#include "far/base/index.h"
#include "far/topology/splits/slot_rule.h"
#include "far/topology/three_valent.h"

/// A row of inside vertices q_1 .. q_m of face f has the edge c -> q_1 into it and the edge t: q_m -> out of it, and
/// behind t the boundary half-edge b. Every edge between an inside and a boundary vertex is the c of one face and, by
/// its other half-edge, the t of the next. Slots of half-edge h:
///     A = 3h    as h in its face; of c: R -> q_1, of t: q_m -> L, of b: L -> R or L -> J
///     B = 3h+1  opposite A in a triangle: of c: q_1 -> R, of t: L -> q_m;  of b: J -> R in the face
///     C = 3h+2  of c: R_f -> L_g in the triangle
/// Vertex slots: v the vertex itself; V + c the point R, V + t the point L, V + b the point J.
namespace honeycomb::Far {

namespace {

class ClampSlots : public SlotRule {
 public:
  using SlotRule::SlotRule;

  std::int32_t slotCount() const override { return 3 * parent().halfEdgeCount(); }
  std::int32_t vertexSlotCount() const override { return parent().vertexCount() + parent().halfEdgeCount(); }
  bool hasCornerPoints() const override { return false; }

  FaceKind faceKind(std::int32_t f) const override {
    const Rows rows = rowsOf(f);
    return rows.count == 0 ? FaceKind::full : rowKind(rows.first);
  }
  void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const override {
    const Rows rows = rowsOf(f);
    if (rows.count == 1) rowLoop(rows.first, slots);
    if (!rows.allInside) return;
    for (const std::int32_t h : parent().halfEdgesOf(f)) slots.push_back(slot(h, A));
  }

  FaceKind vertexKind(std::int32_t) const override { return FaceKind::clampedGap; }
  void vertexLoop(std::int32_t v, std::vector<std::int32_t>& slots) const override {
    if (!parent().onBoundary(v)) return;
    const std::int32_t c = parent().nextOutgoing(parent().outgoing(v));
    if (c < 0 || parent().onBoundary(parent().dest(c))) return;
    slots.insert(slots.end(), {slot(c, C), slot(parent().twin(c), B), slot(c, B)});
  }

  /// The rows of faces with several of them.
  bool hasEdgeFaces() const override { return true; }
  FaceKind edgeKind(std::int32_t h) const override {
    const std::int32_t c = rowOfEdge(h);
    return c < 0 ? FaceKind::full : rowKind(c);
  }
  void edgeLoop(std::int32_t h, std::vector<std::int32_t>& slots) const override {
    const std::int32_t c = rowOfEdge(h);
    if (c >= 0 && rowsOf(parent().face(c)).count > 1) rowLoop(c, slots);
  }

  std::int32_t start(std::int32_t s) const override {
    const std::int32_t h = s / 3;
    const bool inside = !parent().onBoundary(parent().vert(h));
    switch (s % 3) {
      case A:
        if (inside) return parent().vert(h);
        return besideSlot(entersRow(h) ? h : parent().prev(h));
      case B:
        return entersRow(h) ? parent().dest(h) : besideSlot(h);
      default:
        return besideSlot(h);
    }
  }

  std::int32_t twin(std::int32_t s) const override {
    const std::int32_t h = s / 3;
    const bool crossing = entersRow(h) || leavesRow(h);
    switch (s % 3) {
      case A:
        if (crossing) return slot(h, B);
        return parent().twin(h) < 0 ? -1 : slot(parent().twin(h), A);
      case B:
        return crossing ? slot(h, A) : -1;
      default:
        return -1;
    }
  }

  std::vector<OtherPoint> otherPoints() const override {
    std::vector<OtherPoint> points;
    for (std::int32_t v = 0; v < parent().vertexCount(); ++v) {
      if (!parent().onBoundary(v)) points.push_back({v, {PointKind::vertexPoint, parent().outgoing(v)}});
    }
    for (std::int32_t h = 0; h < parent().halfEdgeCount(); ++h) {
      if (entersRow(h) || leavesRow(h)) points.push_back({besideSlot(h), {PointKind::besideEdge, h}});
    }
    for (const std::int32_t b : parent().boundary()) {
      const std::int32_t t = parent().prev(b);
      if (!leavesRow(t) || rowKind(rowStart(t)) != FaceKind::clampedCorner) continue;
      points.push_back({besideSlot(b), {PointKind::faceCentre, b}});
    }
    return points;
  }

 private:
  enum Letter : std::int32_t { A, B, C };
  static std::int32_t slot(std::int32_t h, Letter letter) { return 3 * h + letter; }
  std::int32_t besideSlot(std::int32_t h) const { return parent().vertexCount() + h; }

  /// Is h the edge c of a row, or the edge t?
  bool entersRow(std::int32_t h) const {
    return parent().onBoundary(parent().vert(h)) && !parent().onBoundary(parent().dest(h));
  }
  bool leavesRow(std::int32_t h) const {
    return !parent().onBoundary(parent().vert(h)) && parent().onBoundary(parent().dest(h));
  }

  /// The rows of inside vertices of a face, and the edge into the first.
  struct Rows {
    bool allInside = true;
    std::int32_t count = 0;
    std::int32_t first = -1;
  };
  Rows rowsOf(std::int32_t f) const {
    Rows rows;
    for (const std::int32_t h : parent().halfEdgesOf(f)) {
      rows.allInside = rows.allInside && !parent().onBoundary(parent().vert(h));
      if (!entersRow(h)) continue;
      if (rows.count++ == 0) rows.first = h;
    }
    return rows;
  }
  /// The edge into a row by the edge out of it.
  std::int32_t rowStart(std::int32_t t) const {
    std::int32_t h = t;
    while (!entersRow(h)) h = parent().prev(h);
    return h;
  }
  /// The edge into the row that the edge of h leads to, -1 for other edges.
  std::int32_t rowOfEdge(std::int32_t h) const {
    if (entersRow(h)) return h;
    return leavesRow(h) ? parent().twin(h) : -1;
  }

  FaceKind rowKind(std::int32_t c) const {
    std::int32_t inside = 0;
    for (std::int32_t h = parent().next(c); !parent().onBoundary(parent().vert(h)); h = parent().next(h)) ++inside;
    return parent().sides(parent().face(c)) == 2 * inside ? FaceKind::clampedSide : FaceKind::clampedCorner;
  }
  void rowLoop(std::int32_t c, std::vector<std::int32_t>& slots) const {
    const std::size_t first = slots.size();
    slots.push_back(slot(c, A));
    std::int32_t h = parent().next(c);
    for (; !parent().onBoundary(parent().vert(h)); h = parent().next(h)) slots.push_back(slot(h, A));
    std::vector<std::int32_t> cut{slot(h, A)};
    if (rowKind(c) == FaceKind::clampedCorner) cut.push_back(slot(h, B));
    slots.insert(slots.begin() + static_cast<std::ptrdiff_t>(first), cut.begin(), cut.end());
  }
};

/// How many boundary vertices have three edges, and how many faces have 2m sides, is not known.
Census grow(const Census& p) {
  Census c;
  c.exact = p.exact && p.boundaryEdges == 0;
  c.vertices = p.vertices + 2 * p.boundaryEdges;
  c.faces = p.faces + 2 * p.boundaryEdges;
  c.halfEdges = p.halfEdges + 4 * p.boundaryEdges;
  c.edges = p.edges + 3 * p.boundaryEdges;
  c.boundaryEdges = 3 * p.boundaryEdges;
  return c;
}

Result<SplitResult> apply(const Topology& parent) {
  if (const auto fits = checkSlots(3 * std::int64_t{parent.halfEdgeCount()}, parent); !fits) {
    return tl::unexpected(fits.error());
  }
  if (const auto three = checkThreeValent(parent); !three) return tl::unexpected(three.error());
  SplitResult result = assemble(ClampSlots(parent));
  if (result.topology.faceCount() == 0) {
    return fail(ErrorCode::invalidMesh,
                "every vertex is on the boundary, so the clamped boundary leaves nothing of the mesh; give a larger "
                "mesh");
  }
  return result;
}

}  // namespace

Split clamp() {
  return {"clamp", apply, grow};
}

}  // namespace honeycomb::Far
