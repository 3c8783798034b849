#include "far/topology/splits/chamfer_clamped.h"

#include <algorithm>

#include "far/base/index.h"
#include "far/topology/splits/chamfer_slots.h"
#include "far/topology/three_valent.h"

/// Slots of half-edge h outside gaps as in chamfer.cpp, where every corner point of a side or corner is an s1(h):
///     A = 4h    s1(h) -> s1(n)   in face(h)           C = 4h+2  s1(h) -> s2(v)   in the face of the edge of h
///     B = 4h+1  s1(n) -> s1(h)   opposite A           D = 4h+3  s2(v) -> s1(h)   in the face of the edge of p
/// A gap h_0 = R_f -> L_g, h_1 = L_g -> v, h_2 = v -> R_f has Lm in the vertex slot h_0 and Rm in h_1:
///     A(h_0) = Lm -> Rm     A(h_1) = Rm -> s1(g,v)   A(h_2) = s1(f,v) -> Lm      in the new side
///     B(h_0) = R'_f -> Lm   B(h_2) = Lm -> s1(f,v)                              in the new gap of h_2
///     C(h_0) = Rm -> L'_g   B(h_1) = s1(g,v) -> Rm                              in the new gap of h_1
namespace honeycomb::Far {

namespace {

class ClampedSlots : public ChamferSlots {
 public:
  explicit ClampedSlots(const Topology& parent)
      : ChamferSlots(parent), firstCut_(parent.halfEdgeCount()), firstGap_(firstCut_) {
    for (const FaceRun& run : parent.runs()) {
      if (run.kind != FaceKind::full) firstCut_ = std::min(firstCut_, run.firstHalfEdge);
      if (run.kind == FaceKind::clampedGap) firstGap_ = std::min(firstGap_, run.firstHalfEdge);
    }
  }

  FaceKind faceKind(std::int32_t f) const override {
    return parent().faceOffsets()[at(f)] < firstCut_ ? FaceKind::full : parent().run(f).kind;
  }
  void faceLoop(std::int32_t f, std::vector<std::int32_t>& slots) const override {
    if (!inGap(parent().faceOffsets()[at(f)])) ChamferSlots::faceLoop(f, slots);
  }

  FaceKind edgeKind(std::int32_t h) const override {
    if (parent().twin(h) < 0) return FaceKind::clampedSide;
    return inGap(h) || inGap(parent().twin(h)) ? FaceKind::clampedGap : FaceKind::full;
  }
  void edgeLoop(std::int32_t h, std::vector<std::int32_t>& slots) const override {
    const std::int32_t t = parent().twin(h);
    if (t < 0) {
      if (inGap(h)) sideLoop(h, slots);
    } else if (inGap(t)) {
      gapLoop(t, slots);
    } else if (inGap(h)) {
      gapLoop(h, slots);
    } else {
      ChamferSlots::edgeLoop(h, slots);
    }
  }

  std::int32_t start(std::int32_t s) const override {
    const std::int32_t h = s / 4;
    return inGap(h) ? gapStart(h, static_cast<Letter>(s % 4)) : ChamferSlots::start(s);
  }

  std::int32_t twin(std::int32_t s) const override {
    const std::int32_t h = s / 4;
    switch (s % 4) {
      case A:
        return parent().twin(h) < 0 ? -1 : slot(h, B);
      case B:
        return parent().twin(h) < 0 ? -1 : slot(h, A);
      case C:
        return inGap(h) ? -1 : slot(h, D);
      default:
        return slot(h, C);
    }
  }

  std::vector<OtherPoint> otherPoints() const override {
    std::vector<OtherPoint> points;
    for (std::int32_t v = 0; v < parent().vertexCount(); ++v) {
      if (parent().onBoundary(v)) continue;
      points.push_back({parent().halfEdgeCount() + v, {PointKind::vertexPoint, parent().outgoing(v)}});
    }
    for (const FaceRun& run : parent().runs()) {
      for (std::int32_t f = run.firstFace; run.kind != FaceKind::full && f < run.firstFace + run.faceCount; ++f) {
        appendFacePoints(run.kind, parent().faceOffsets()[at(f)], run.sides, points);
      }
    }
    return points;
  }

 private:
  bool inGap(std::int32_t h) const { return h >= firstGap_; }
  /// The half-edges of a gap come in threes.
  std::int32_t placeInGap(std::int32_t h) const { return (h - firstGap_) % 3; }

  void sideLoop(std::int32_t h0, std::vector<std::int32_t>& slots) const {
    const std::int32_t intoG = parent().twin(h0 + 1);
    const std::int32_t outOfF = parent().next(parent().twin(h0 + 2));
    slots.insert(slots.end(), {slot(h0, A), slot(h0 + 1, A), slot(intoG, C), slot(outOfF, D), slot(h0 + 2, A)});
  }
  /// Of h_1 or h_2 of a gap.
  void gapLoop(std::int32_t h, std::vector<std::int32_t>& slots) const {
    const std::int32_t beside = parent().twin(h);
    if (placeInGap(h) == 1) {
      slots.insert(slots.end(), {slot(h - 1, C), slot(beside, B), slot(h, B)});
    } else {
      slots.insert(slots.end(), {slot(h - 2, B), slot(h, B), slot(beside, B)});
    }
  }
  std::int32_t gapStart(std::int32_t h, Letter letter) const {
    switch (placeInGap(h)) {
      case 0:
        if (letter == A) return h;
        return letter == B ? parent().twin(h + 2) : h + 1;
      case 1:
        return letter == A ? h : parent().twin(h);
      default:
        return letter == A ? parent().next(parent().twin(h)) : h - 2;
    }
  }

  static void appendFacePoints(FaceKind kind, std::int32_t first, std::int32_t sides, std::vector<OtherPoint>& points) {
    points.push_back({first, {PointKind::cutStart, first}});
    if (kind == FaceKind::clampedGap) {
      points.push_back({first + 1, {PointKind::cutEnd, first}});
      return;
    }
    const bool corner = kind == FaceKind::clampedCorner;
    if (corner) points.push_back({first + 1, {PointKind::fixedCorner, first + 1}});
    const std::int32_t right = first + (corner ? 2 : 1);
    points.push_back({right, {PointKind::cutEnd, right - 1}});
    for (std::int32_t h = right + 1; h < first + sides; ++h) {
      points.push_back({h, {corner ? PointKind::cornerFaceCorner : PointKind::halfFaceCorner, h}});
    }
  }

  std::int32_t firstCut_;  ///< the first half-edge of a face that is not whole
  std::int32_t firstGap_;  ///< the first half-edge of a gap
};

/// s1 of every corner outside gaps, s2 of every inside vertex, two points a gap; an edge inside, its hexagon.
Census grow(const Census& p) {
  Census c;
  c.exact = p.exact;
  const std::int64_t gaps = p.exact ? p.gaps : 0;
  const std::int64_t boundary = p.exact ? p.boundaryEdges : 0;
  c.vertices = p.halfEdges + p.vertices - gaps - boundary;
  c.faces = p.faces + p.edges - boundary;
  c.edges = 2 * p.halfEdges - boundary - gaps;
  c.halfEdges = 4 * p.halfEdges - 3 * boundary - 4 * gaps;
  c.boundaryEdges = p.exact ? p.boundaryEdges + 2 * gaps : 3 * p.boundaryEdges;
  c.gaps = 2 * p.gaps;
  return c;
}

bool hasClampedBoundary(const Topology& topology) {
  std::int32_t firstCut = topology.halfEdgeCount();
  for (const FaceRun& run : topology.runs()) {
    if (isCutByBrick(run.kind)) return false;
    if (run.kind != FaceKind::full) firstCut = std::min(firstCut, run.firstHalfEdge);
  }
  return topology.closed() || topology.boundary().front() >= firstCut;
}

Result<SplitResult> apply(const Topology& parent) {
  if (const auto fits = checkSlots(4 * std::int64_t{parent.halfEdgeCount()}, parent); !fits) {
    return tl::unexpected(fits.error());
  }
  if (!hasClampedBoundary(parent)) {
    return fail(ErrorCode::invalidMesh, "the boundary of the mesh is not clamped; put a clamp step before this one");
  }
  if (parent.closed()) {
    if (const auto three = checkThreeValent(parent); !three) return tl::unexpected(three.error());
  }
  return assemble(ClampedSlots(parent));
}

}  // namespace

Split chamferClamped() {
  return {"chamfer-clamped", apply, grow};
}

}  // namespace honeycomb::Far
