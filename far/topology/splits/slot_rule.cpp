#include "far/topology/splits/slot_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/edge_matching.h"

namespace honeycomb::Far {

namespace {

/// A face that may come to be: the parent's faces first, then its vertices, then its edges by half-edges.
struct Candidates {
  explicit Candidates(const SlotRule& slotRule)
      : rule(slotRule), faces(rule.parent().faceCount()), vertices(rule.parent().vertexCount()) {}

  const SlotRule& rule;
  std::int32_t faces;
  std::int32_t vertices;

  std::int64_t count() const {
    return std::int64_t{faces} + vertices + (rule.hasEdgeFaces() ? rule.parent().halfEdgeCount() : 0);
  }
  FaceParent parentKind(std::int64_t c) const {
    if (c < faces) return FaceParent::face;
    return c < std::int64_t{faces} + vertices ? FaceParent::vertex : FaceParent::edge;
  }
  std::int32_t parent(std::int64_t c) const {
    if (c < faces) return static_cast<std::int32_t>(c);
    return static_cast<std::int32_t>(c < std::int64_t{faces} + vertices ? c - faces : c - faces - vertices);
  }
  FaceKind kind(std::int64_t c) const {
    switch (parentKind(c)) {
      case FaceParent::face:
        return rule.faceKind(parent(c));
      case FaceParent::vertex:
        return rule.vertexKind(parent(c));
      default:
        return rule.edgeKind(parent(c));
    }
  }
  void loop(std::int64_t c, std::vector<std::int32_t>& out) const {
    out.clear();
    const std::int32_t element = parent(c);
    switch (parentKind(c)) {
      case FaceParent::face:
        return rule.faceLoop(element, out);
      case FaceParent::vertex:
        return rule.vertexLoop(element, out);
      default:
        if (rule.parent().leads(element)) rule.edgeLoop(element, out);
    }
  }
};

std::vector<std::int32_t> countSides(const Candidates& candidates) {
  std::vector<std::int32_t> sides(at(candidates.count()));
  Parallel::forRange(0, candidates.count(), 1024, [&](std::int64_t begin, std::int64_t end) {
    std::vector<std::int32_t> loop;
    for (std::int64_t c = begin; c < end; ++c) {
      candidates.loop(c, loop);
      sides[at(c)] = static_cast<std::int32_t>(loop.size());
    }
  });
  return sides;
}

/// The candidates of a group sorted stably by side count.
void appendBySides(const std::vector<std::int64_t>& group, const std::vector<std::int32_t>& sides,
                   std::vector<std::int64_t>& order) {
  if (group.empty()) return;
  std::vector<std::int32_t> keys(group.size());
  for (std::size_t i = 0; i < group.size(); ++i) keys[i] = sides[at(group[i])];
  const std::int32_t largest = *std::max_element(keys.begin(), keys.end());
  for (const std::int32_t i : Parallel::stableOrder(keys, largest + 1)) order.push_back(group[at(i)]);
}

/// The live candidates in the order in which their faces are stored; `corners` gets the side count of the first group.
std::vector<std::int64_t> faceOrder(const Candidates& candidates, const std::vector<std::int32_t>& sides,
                                    std::int32_t& corners) {
  // Groups: whole faces, whole vertex-faces, whole edge-faces, then the same three for each kind of cut face.
  std::array<std::vector<std::int64_t>, 3 * kFaceKinds> groups;
  for (std::int64_t c = 0; c < candidates.count(); ++c) {
    if (sides[at(c)] == 0) continue;
    groups[3 * at(static_cast<int>(candidates.kind(c))) + at(static_cast<int>(candidates.parentKind(c)))].push_back(c);
  }
  std::vector<std::int64_t> order = groups[0];
  corners = 0;
  for (const std::int64_t c : groups[0]) corners += sides[at(c)];
  for (std::size_t group = 1; group < groups.size(); ++group) appendBySides(groups[group], sides, order);
  return order;
}

void layOutFaces(const Candidates& candidates, const std::vector<std::int32_t>& sides,
                 const std::vector<std::int64_t>& order, TopologyArrays& child) {
  child.parents.resize(order.size());
  child.faceOffsets.resize(order.size() + 1, 0);
  for (std::size_t f = 0; f < order.size(); ++f) {
    const std::int64_t c = order[f];
    const FaceRun run{candidates.kind(c),           candidates.parentKind(c), sides[at(c)],
                      static_cast<std::int32_t>(f), child.faceOffsets[f],     0};
    const bool same = !child.runs.empty() && child.runs.back().kind == run.kind &&
                      child.runs.back().parent == run.parent && child.runs.back().sides == run.sides;
    if (!same) child.runs.push_back(run);
    ++child.runs.back().faceCount;
    child.parents[f] = candidates.parent(c);
    child.faceOffsets[f + 1] = child.faceOffsets[f] + run.sides;
  }
}

/// Which slot each new half-edge is, and back.
struct SlotMap {
  std::vector<std::int32_t> slotOf;  ///< per new half-edge
  std::vector<std::int32_t> idOf;    ///< per slot; only live ones are meaningful
};

SlotMap placeSlots(const Candidates& candidates, const std::vector<std::int64_t>& order, TopologyArrays& child) {
  const std::size_t halfEdges = at(child.faceOffsets.back());
  SlotMap map{std::vector<std::int32_t>(halfEdges), std::vector<std::int32_t>(at(candidates.rule.slotCount()), -1)};
  child.face.resize(halfEdges);
  Parallel::forRange(0, static_cast<std::int64_t>(order.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
    std::vector<std::int32_t> loop;
    for (std::int64_t f = begin; f < end; ++f) {
      candidates.loop(order[at(f)], loop);
      std::int32_t h = child.faceOffsets[at(f)];
      for (const std::int32_t slot : loop) {
        map.slotOf[at(h)] = slot;
        map.idOf[at(slot)] = h;
        child.face[at(h)] = static_cast<std::int32_t>(f);
        ++h;
      }
    }
  });
  return map;
}

/// Corner points take the number of their half-edge in a whole face-face, the other points follow.
std::vector<std::int32_t> numberVertices(const SlotRule& rule, const SlotMap& map, std::int32_t cornerPoints,
                                         const std::vector<SlotRule::OtherPoint>& others) {
  std::vector<std::int32_t> number(at(rule.vertexSlotCount()), -1);
  Parallel::forEach(0, cornerPoints,
                    [&](std::int64_t h) { number[at(rule.start(map.slotOf[at(h)]))] = static_cast<std::int32_t>(h); });
  for (std::size_t i = 0; i < others.size(); ++i) {
    number[at(others[i].slot)] = cornerPoints + static_cast<std::int32_t>(i);
  }
  return number;
}

void link(const SlotRule& rule, const SlotMap& map, const std::vector<std::int32_t>& number, TopologyArrays& child) {
  child.vert.resize(map.slotOf.size());
  child.twin.resize(map.slotOf.size());
  Parallel::forEach(0, static_cast<std::int64_t>(map.slotOf.size()), [&](std::int64_t h) {
    const std::int32_t slot = map.slotOf[at(h)];
    child.vert[at(h)] = number[at(rule.start(slot))];
    const std::int32_t twin = rule.twin(slot);
    child.twin[at(h)] = twin < 0 ? -1 : map.idOf[at(twin)];
  });
}

void tagBoundary(const SlotRule& rule, const SlotMap& map, TopologyArrays& child) {
  for (std::size_t h = 0; h < child.twin.size(); ++h) {
    if (child.twin[h] >= 0) continue;
    child.boundary.push_back(static_cast<std::int32_t>(h));
    child.boundaryTags.push_back(rule.edgeTag(map.slotOf[h]));
  }
  if (child.boundary.empty()) return;
  child.vertexTags.assign(at(child.vertexCount), VertexTag::interior);
  for (const std::int32_t h : child.boundary) {
    child.vertexTags[at(child.vert[at(h)])] = rule.vertexTag(rule.start(map.slotOf[at(h)]));
  }
}

}  // namespace

SplitResult assemble(const SlotRule& rule) {
  const Candidates candidates(rule);
  const std::vector<std::int32_t> sides = countSides(candidates);
  SplitResult result;
  const std::vector<std::int64_t> order = faceOrder(candidates, sides, result.cornerPoints);
  if (!rule.hasCornerPoints()) result.cornerPoints = 0;
  TopologyArrays child;
  child.threeValent = rule.makesThreeValent();
  layOutFaces(candidates, sides, order, child);
  const SlotMap map = placeSlots(candidates, order, child);
  const std::vector<SlotRule::OtherPoint> others = rule.otherPoints();
  for (const SlotRule::OtherPoint& other : others) result.otherPoints.push_back(other.point);
  child.vertexCount = result.cornerPoints + static_cast<std::int32_t>(others.size());
  link(rule, map, numberVertices(rule, map, result.cornerPoints, others), child);
  tagBoundary(rule, map, child);
  child.outgoing = outgoingCorners(child.vert, child.twin, child.vertexCount);
  result.topology = Topology(std::move(child));
  return result;
}

Result<void> checkSlots(std::int64_t slots, const Topology& parent) {
  if (slots <= std::numeric_limits<std::int32_t>::max()) return {};
  return fail(ErrorCode::tooLarge,
              fmt::format("refining {} half-edges would pass 2^31 - 1; use fewer levels", parent.halfEdgeCount()));
}

Result<void> checkVertexFaces(const Topology& parent) {
  if (parent.threeValent()) return {};
  const std::int64_t lowest = Parallel::firstWhere(0, parent.vertexCount(), [&](std::int64_t i) {
    const auto v = static_cast<std::int32_t>(i);
    if (parent.onBoundary(v)) return false;
    const std::int32_t first = parent.outgoing(v);
    const std::int32_t second = parent.nextOutgoing(first);
    return second == first || parent.nextOutgoing(second) == first;
  });
  if (lowest == parent.vertexCount()) return {};
  return fail(ErrorCode::invalidMesh,
              fmt::format("{} has {} faces round it, too few to become a face; dissolve it",
                          elementName(ElementKind::vertex, lowest), parent.facesAt(static_cast<std::int32_t>(lowest))),
              lowest, ElementKind::vertex);
}

}  // namespace honeycomb::Far
