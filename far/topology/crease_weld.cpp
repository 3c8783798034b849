#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/crease_cut.h"
#include "far/topology/edge_matching.h"

/// What becomes of a crease between two copies of itself, above and below, when it is closed:
///     half-edges that cut through faces are dropped, the faces above and below grow together;
///     half-edges on the line become twins, their ends are united;
///     points at which an edge crosses the line (mid) are dissolved: the two halves of the edge are joined;
///     a corner that stays where it is disappears with the last cut that runs into it.
namespace honeycomb::Far {

namespace {

/// Which half-edges and vertices of a cut level go when creases are closed.
class Closing {
 public:
  Closing(const Topology& level, double sharpness)
      : level_(level),
        sides_(level),
        sharpness_(sharpness),
        dropped_(at(level.halfEdgeCount()), 0),
        dissolved_(at(level.vertexCount()), 0),
        same_(at(level.vertexCount())) {
    std::iota(same_.begin(), same_.end(), 0);
    for (std::size_t rank = 0; rank < level.boundary().size(); ++rank) {
      const std::int32_t b = level.boundary()[rank];
      if (expires(b)) close(b, level.boundaryTags()[rank]);
    }
    for (std::int32_t v = 0; v < level.vertexCount(); ++v) same_[at(v)] = same_[at(same_[at(v)])];
    releaseCorners();
  }

  const CreaseSides& sides() const { return sides_; }
  bool expires(std::int32_t b) const {
    const double s = sides_.sharpness(b);
    return s > 0 && s <= sharpness_;
  }
  bool survives(std::int32_t h) const { return dropped_[at(h)] == 0 && dissolved_[at(level_.vert(h))] == 0; }
  /// The last of the half-edges that h is joined with.
  std::int32_t last(std::int32_t h) const {
    for (std::int32_t n = after(h); dissolved_[at(level_.vert(n))] != 0; n = after(n)) h = n;
    return h;
  }
  /// The half-edge behind h in the face it comes to lie in.
  std::int32_t after(std::int32_t h) const {
    std::int32_t n = level_.next(h);
    while (dropped_[at(n)] != 0) n = level_.next(sides_.mate(n));
    return n;
  }
  /// The first of the vertices that v is united with.
  std::int32_t same(std::int32_t v) const { return same_[at(v)]; }
  /// Faces that change, and vertices on what is closed; an element may come more than once.
  const std::vector<ClosedCrease>& faces() const { return faces_; }
  const std::vector<ClosedCrease>& vertices() const { return vertices_; }

 private:
  void close(std::int32_t b, EdgeTag tag) {
    const std::int32_t mate = sides_.mate(b);
    unite(level_.vert(b), level_.dest(mate));
    unite(level_.dest(b), level_.vert(mate));
    if (tag != EdgeTag::onLine) {
      dropped_[at(b)] = 1;
      faces_.push_back({level_.face(b), sides_.sharpness(b)});
    }
    for (const std::int32_t v : {level_.vert(b), level_.dest(b)}) {
      if (level_.vertexTag(v) == VertexTag::mid) dissolved_[at(v)] = 1;
      if (level_.vertexTag(v) == VertexTag::real) vertices_.push_back({v, sides_.sharpness(b)});
    }
  }

  /// While vertices are united, same_ has a vertex before v that is united with it; the ways there are cut short.
  std::int32_t firstOf(std::int32_t v) {
    while (same_[at(v)] != v) v = same_[at(v)] = same_[at(same_[at(v)])];
    return v;
  }

  void unite(std::int32_t a, std::int32_t b) {
    a = firstOf(a);
    b = firstOf(b);
    same_[at(std::max(a, b))] = std::min(a, b);
  }

  /// Looks at each corner from one of its copies: where they end at the boundary from the first, else from any.
  void releaseCorners() {
    std::vector<std::uint8_t> seen(at(level_.vertexCount()), 0);
    for (const bool fromBoundary : {true, false}) {
      for (const std::int32_t b : level_.boundary()) {
        const std::int32_t v = level_.vert(b);
        if (level_.vertexTag(v) != VertexTag::fixedCorner || seen[at(v)] != 0) continue;
        if (fromBoundary && sides_.sharpness(level_.enteringBoundary(v)) > 0) continue;
        releaseCorner(v, seen);
      }
    }
  }

  /// Dissolves the copies of a corner that is held neither by the caller nor by what is left of its creases: two of
  /// the same sharpness that meet, or none on the boundary.
  void releaseCorner(std::int32_t first, std::vector<std::uint8_t>& seen) {
    std::vector<std::int32_t> copies;
    std::vector<double> left;
    double closed = 0;
    bool round = false;
    for (std::int32_t v = first; v >= 0 && !round;) {
      copies.push_back(v);
      seen[at(v)] = 1;
      const std::int32_t b = level_.outgoing(v);
      const double s = sides_.sharpness(b);
      if (expires(b)) closed = std::max(closed, s);
      if (s > 0 && !expires(b)) left.push_back(s);
      v = s > 0 ? level_.dest(sides_.mate(b)) : -1;
      round = v == first;
    }
    const bool held = std::binary_search(level_.heldCorners().begin(), level_.heldCorners().end(), first);
    const bool free = round ? left.size() == 2 && left[0] == left[1] : left.empty();
    if (held || !free || closed == 0) return;
    for (const std::int32_t v : copies) {
      dissolved_[at(v)] = 1;
      faces_.push_back({level_.face(level_.outgoing(v)), closed});
    }
  }

  const Topology& level_;
  CreaseSides sides_;
  double sharpness_;
  std::vector<std::uint8_t> dropped_;
  std::vector<std::uint8_t> dissolved_;
  std::vector<std::int32_t> same_;
  std::vector<ClosedCrease> faces_, vertices_;
};

/// A cut face, or what has grown together from several, as its half-edges in the level before.
struct Loop {
  FaceKind kind = FaceKind::full;
  FaceParent parent = FaceParent::face;
  std::int32_t face = 0;  // the first of its faces
  std::vector<std::int32_t> halfEdges;
  double closed = 0;
};

/// Lays the level out again: whole faces keep their places and half-edges, the others follow.
class Weld {
 public:
  Weld(const Topology& level, double sharpness)
      : level_(level), closing_(level, sharpness), id_(at(level.halfEdgeCount()), -1) {
    wholeFaces_ = level.faceCount();
    for (const FaceRun& run : level.runs()) {
      if (run.kind != FaceKind::full) wholeFaces_ = std::min(wholeFaces_, run.firstFace);
    }
    wholeHalfEdges_ = level.faceOffsets()[at(wholeFaces_)];
  }

  Reshaped make() {
    const CreaseSides& sides = closing_.sides();
    std::vector<Loop> loops = cutLoops();
    layOut(loops);
    numberVertices();
    link(sides);
    arrays_.outgoing = outgoingCorners(arrays_.vert, arrays_.twin, arrays_.vertexCount);
    tagBoundary();
    keepCreases(sides);
    arrays_.threeValent = arrays_.boundary.empty();  // as every refined level of the schemes that weld
    collectVertices();
    result_.topology = Topology(std::move(arrays_));
    return std::move(result_);
  }

 private:
  EdgeTag tagOf(std::int32_t b) const {
    const auto boundary = level_.boundary();
    return level_.boundaryTags()[at(std::lower_bound(boundary.begin(), boundary.end(), b) - boundary.begin())];
  }

  std::vector<Loop> cutLoops() {
    closed_.assign(at(level_.faceCount() - wholeFaces_), 0.0);
    for (const ClosedCrease& face : sharpestEach(closing_.faces())) {
      closed_[at(face.element - wholeFaces_)] = face.sharpness;
    }
    std::vector<Loop> loops;
    std::vector<std::uint8_t> seen(at(level_.halfEdgeCount() - wholeHalfEdges_), 0);
    for (std::int32_t h = wholeHalfEdges_; h < level_.halfEdgeCount(); ++h) {
      if (closing_.survives(h) && seen[at(h - wholeHalfEdges_)] == 0) loops.push_back(loopFrom(h, seen));
    }
    std::stable_sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
      return std::tuple(a.kind, a.parent, a.halfEdges.size()) < std::tuple(b.kind, b.parent, b.halfEdges.size());
    });
    return loops;
  }

  Loop loopFrom(std::int32_t first, std::vector<std::uint8_t>& seen) const {
    Loop loop;
    loop.face = level_.face(first);
    loop.parent = level_.parentKind(loop.face);
    std::size_t start = 0;
    std::int32_t h = first;
    do {
      if (level_.twin(h) < 0 && !closing_.expires(h) && tagOf(h) != EdgeTag::onLine) {
        // The loop of a cut face starts with its cut, at a corner with the part into the corner.
        const bool whole = tagOf(h) == EdgeTag::cut || closing_.last(h) != h;
        loop.kind = whole ? FaceKind::half : FaceKind::corner;
        if (level_.vertexTag(level_.vert(h)) != VertexTag::fixedCorner) start = loop.halfEdges.size();
      }
      loop.halfEdges.push_back(h);
      seen[at(h - wholeHalfEdges_)] = 1;
      const std::int32_t last = closing_.last(h);
      for (std::int32_t part = h;; part = closing_.after(part)) {
        loop.closed = std::max(loop.closed, closed_[at(level_.face(part) - wholeFaces_)]);
        if (part == last) break;
      }
      h = closing_.after(last);
    } while (h != first);
    std::rotate(loop.halfEdges.begin(), loop.halfEdges.begin() + static_cast<std::ptrdiff_t>(start),
                loop.halfEdges.end());
    return loop;
  }

  void layOut(const std::vector<Loop>& loops) {
    for (const FaceRun& run : level_.runs()) {
      if (run.kind == FaceKind::full) arrays_.runs.push_back(run);
    }
    const auto offsets = level_.faceOffsets();
    arrays_.faceOffsets.assign(offsets.begin(), offsets.begin() + wholeFaces_ + 1);
    arrays_.face.assign(level_.face().begin(), level_.face().begin() + wholeHalfEdges_);
    result_.faceOf.resize(at(wholeFaces_));
    result_.firstOf.resize(at(wholeHalfEdges_));
    std::iota(result_.faceOf.begin(), result_.faceOf.end(), 0);
    std::iota(result_.firstOf.begin(), result_.firstOf.end(), 0);
    for (const Loop& loop : loops) append(loop);
    for (std::size_t h = 0; h < result_.firstOf.size(); ++h) id_[at(result_.firstOf[h])] = static_cast<std::int32_t>(h);
    result_.lastOf.resize(result_.firstOf.size());
    Parallel::forEach(0, static_cast<std::int64_t>(result_.firstOf.size()), [&](std::int64_t h) {
      const std::int32_t first = result_.firstOf[at(h)];
      result_.lastOf[at(h)] = first < wholeHalfEdges_ ? first : closing_.last(first);
    });
    for (const std::int32_t f : result_.faceOf) arrays_.parents.push_back(level_.parents()[at(f)]);
  }

  void append(const Loop& loop) {
    const auto face = static_cast<std::int32_t>(result_.faceOf.size());
    const auto sides = static_cast<std::int32_t>(loop.halfEdges.size());
    const FaceRun* back = arrays_.runs.empty() ? nullptr : &arrays_.runs.back();
    const bool same = back != nullptr && back->firstFace >= wholeFaces_ && back->kind == loop.kind &&
                      back->parent == loop.parent && back->sides == sides;
    if (!same) arrays_.runs.push_back({loop.kind, loop.parent, sides, face, arrays_.faceOffsets.back(), 0});
    ++arrays_.runs.back().faceCount;
    arrays_.faceOffsets.push_back(arrays_.faceOffsets.back() + sides);
    arrays_.face.resize(arrays_.face.size() + loop.halfEdges.size(), face);
    result_.faceOf.push_back(loop.face);
    result_.firstOf.insert(result_.firstOf.end(), loop.halfEdges.begin(), loop.halfEdges.end());
    if (loop.closed > 0) result_.faces.push_back({face, loop.closed});
  }

  void numberVertices() {
    number_.assign(at(level_.vertexCount()), 0);
    for (const std::int32_t h : result_.firstOf) number_[at(closing_.same(level_.vert(h)))] = 1;
    for (std::int32_t v = 0; v < level_.vertexCount(); ++v) {
      if (number_[at(v)] != 0) result_.vertexOf.push_back(v);
    }
    arrays_.vertexCount = static_cast<std::int32_t>(Parallel::exclusiveScan(number_));
  }

  std::int32_t vertex(std::int32_t v) const { return number_[at(closing_.same(v))]; }

  void link(const CreaseSides& sides) {
    arrays_.vert.resize(result_.firstOf.size());
    arrays_.twin.resize(result_.firstOf.size());
    Parallel::forEach(0, static_cast<std::int64_t>(result_.firstOf.size()), [&](std::int64_t h) {
      arrays_.vert[at(h)] = vertex(level_.vert(result_.firstOf[at(h)]));
      const std::int32_t last = result_.lastOf[at(h)];
      std::int32_t twin = level_.twin(last);
      if (twin < 0 && closing_.expires(last)) twin = sides.mate(last);
      arrays_.twin[at(h)] = twin < 0 ? -1 : id_[at(twin)];
    });
  }

  void tagBoundary() {
    for (std::size_t h = 0; h < arrays_.twin.size(); ++h) {
      if (arrays_.twin[h] >= 0) continue;
      arrays_.boundary.push_back(static_cast<std::int32_t>(h));
      const bool joined = result_.firstOf[h] != result_.lastOf[h];
      arrays_.boundaryTags.push_back(joined ? EdgeTag::cut : tagOf(result_.firstOf[h]));
    }
    if (arrays_.boundary.empty()) return;
    arrays_.vertexTags.assign(at(arrays_.vertexCount), VertexTag::interior);
    for (const std::int32_t h : arrays_.boundary) {
      arrays_.vertexTags[at(arrays_.vert[at(h)])] = level_.vertexTag(level_.vert(result_.firstOf[at(h)]));
    }
  }

  void keepCreases(const CreaseSides& sides) {
    for (const std::int32_t h : arrays_.boundary) {
      const std::int32_t mate = sides.mate(result_.lastOf[at(h)]);
      if (mate < 0) continue;
      const std::int32_t other = id_[at(mate)];
      if (h < other) arrays_.creases.push_back({h, other, sides.sharpness(result_.lastOf[at(h)])});
    }
    if (arrays_.creases.empty()) return;
    for (const std::int32_t v : level_.heldCorners()) {
      const std::int32_t kept = vertex(v);
      const bool there = kept < arrays_.vertexCount && result_.vertexOf[at(kept)] == closing_.same(v);
      if (there && arrays_.vertexTags[at(kept)] == VertexTag::fixedCorner) arrays_.heldCorners.push_back(kept);
    }
    std::sort(arrays_.heldCorners.begin(), arrays_.heldCorners.end());
    arrays_.heldCorners.erase(std::unique(arrays_.heldCorners.begin(), arrays_.heldCorners.end()),
                              arrays_.heldCorners.end());
  }

  void collectVertices() {
    result_.united.resize(at(level_.vertexCount()));
    Parallel::forEach(0, level_.vertexCount(),
                      [&](std::int64_t v) { result_.united[at(v)] = closing_.same(static_cast<std::int32_t>(v)); });
    std::vector<ClosedCrease> vertices = closing_.vertices();
    for (ClosedCrease& closed : vertices) closed.element = vertex(closed.element);
    result_.vertices = sharpestEach(std::move(vertices));
  }

  const Topology& level_;
  Closing closing_;
  std::int32_t wholeFaces_;
  std::int32_t wholeHalfEdges_;
  std::vector<double> closed_;        // per face behind the whole ones: sharpness of the creases closed there
  std::vector<std::int32_t> id_;      // per old half-edge that a new one begins with: its number
  std::vector<std::int32_t> number_;  // per old vertex that stands for its like: its number
  TopologyArrays arrays_;
  Reshaped result_;
};

}  // namespace

Reshaped weldCreases(const Topology& level, double sharpness) {
  return Weld(level, sharpness).make();
}

}  // namespace honeycomb::Far
