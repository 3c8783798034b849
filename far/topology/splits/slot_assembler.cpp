#include "far/topology/splits/slot_assembler.h"

#include <algorithm>
#include <array>

#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/edge_matching.h"

namespace honeycomb::Far {

namespace {

/// A face that may come to be: the parent's faces first, then its vertices.
struct Candidates {
  const ZipSlots& slots;
  std::int32_t faces;

  std::int32_t count() const { return faces + slots.parent().vertexCount(); }
  FaceParent parentKind(std::int32_t c) const { return c < faces ? FaceParent::face : FaceParent::vertex; }
  std::int32_t parent(std::int32_t c) const { return c < faces ? c : c - faces; }
  FaceKind kind(std::int32_t c) const { return c < faces ? slots.faceKind(c) : slots.vertexKind(c - faces); }
  void loop(std::int32_t c, std::vector<std::int32_t>& out) const {
    out.clear();
    c < faces ? slots.faceLoop(c, out) : slots.vertexLoop(c - faces, out);
  }
};

std::vector<std::int32_t> countSides(const Candidates& candidates) {
  std::vector<std::int32_t> sides(at(candidates.count()));
  Parallel::forRange(0, candidates.count(), 1024, [&](std::int64_t begin, std::int64_t end) {
    std::vector<std::int32_t> loop;
    for (std::int64_t c = begin; c < end; ++c) {
      candidates.loop(static_cast<std::int32_t>(c), loop);
      sides[at(c)] = static_cast<std::int32_t>(loop.size());
    }
  });
  return sides;
}

/// The candidates of a group sorted stably by side count.
void appendBySides(const std::vector<std::int32_t>& group, const std::vector<std::int32_t>& sides,
                   std::vector<std::int32_t>& order) {
  if (group.empty()) return;
  std::vector<std::int32_t> keys(group.size());
  for (std::size_t i = 0; i < group.size(); ++i) keys[i] = sides[at(group[i])];
  const std::int32_t largest = *std::max_element(keys.begin(), keys.end());
  for (const std::int32_t i : Parallel::stableOrder(keys, largest + 1)) order.push_back(group[at(i)]);
}

/// The live candidates in the order in which their faces are stored; `corners` gets the side count of the first group.
std::vector<std::int32_t> faceOrder(const Candidates& candidates, const std::vector<std::int32_t>& sides,
                                    std::int32_t& corners) {
  // Groups: whole faces, whole vertex-faces, half faces, half vertex-faces, corner faces, corner vertex-faces.
  std::array<std::vector<std::int32_t>, 6> groups;
  for (std::int32_t c = 0; c < candidates.count(); ++c) {
    if (sides[at(c)] == 0) continue;
    const std::size_t group = 2 * at(static_cast<int>(candidates.kind(c))) + (c < candidates.faces ? 0 : 1);
    groups[group].push_back(c);
  }
  std::vector<std::int32_t> order = groups[0];
  corners = 0;
  for (const std::int32_t c : groups[0]) corners += sides[at(c)];
  for (std::size_t group = 1; group < groups.size(); ++group) appendBySides(groups[group], sides, order);
  return order;
}

void layOutFaces(const Candidates& candidates, const std::vector<std::int32_t>& sides,
                 const std::vector<std::int32_t>& order, TopologyArrays& child) {
  child.parents.resize(order.size());
  child.faceOffsets.resize(order.size() + 1);
  for (std::size_t f = 0; f < order.size(); ++f) {
    const std::int32_t c = order[f];
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

SlotMap placeSlots(const Candidates& candidates, const std::vector<std::int32_t>& order, TopologyArrays& child) {
  const std::size_t halfEdges = at(child.faceOffsets.back());
  SlotMap map{std::vector<std::int32_t>(halfEdges), std::vector<std::int32_t>(at(candidates.slots.slotCount()), -1)};
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
std::vector<std::int32_t> numberVertices(const ZipSlots& slots, const SlotMap& map, std::int32_t cornerPoints,
                                         const std::vector<ZipSlots::OtherPoint>& others) {
  std::vector<std::int32_t> number(at(slots.vertexSlotCount()), -1);
  Parallel::forEach(0, cornerPoints,
                    [&](std::int64_t h) { number[at(slots.start(map.slotOf[at(h)]))] = static_cast<std::int32_t>(h); });
  for (std::size_t i = 0; i < others.size(); ++i) {
    number[at(others[i].slot)] = cornerPoints + static_cast<std::int32_t>(i);
  }
  return number;
}

void link(const ZipSlots& slots, const SlotMap& map, const std::vector<std::int32_t>& number, TopologyArrays& child) {
  child.vert.resize(map.slotOf.size());
  child.twin.resize(map.slotOf.size());
  Parallel::forEach(0, static_cast<std::int64_t>(map.slotOf.size()), [&](std::int64_t h) {
    const std::int32_t slot = map.slotOf[at(h)];
    child.vert[at(h)] = number[at(slots.start(slot))];
    const std::int32_t twin = slots.twin(slot);
    child.twin[at(h)] = twin < 0 ? -1 : map.idOf[at(twin)];
  });
}

void tagBoundary(const ZipSlots& slots, const SlotMap& map, TopologyArrays& child) {
  for (std::size_t h = 0; h < child.twin.size(); ++h) {
    if (child.twin[h] >= 0) continue;
    child.boundary.push_back(static_cast<std::int32_t>(h));
    child.boundaryTags.push_back(slots.edgeTag(map.slotOf[h]));
  }
  if (child.boundary.empty()) return;
  child.vertexTags.assign(at(child.vertexCount), VertexTag::interior);
  for (const std::int32_t h : child.boundary) {
    child.vertexTags[at(child.vert[at(h)])] = slots.vertexTag(slots.start(map.slotOf[at(h)]));
  }
}

}  // namespace

SplitResult assemble(const ZipSlots& slots) {
  const Candidates candidates{slots, slots.parent().faceCount()};
  const std::vector<std::int32_t> sides = countSides(candidates);
  SplitResult result;
  const std::vector<std::int32_t> order = faceOrder(candidates, sides, result.cornerPoints);
  TopologyArrays child;
  layOutFaces(candidates, sides, order, child);
  const SlotMap map = placeSlots(candidates, order, child);
  const std::vector<ZipSlots::OtherPoint> others = slots.otherPoints();
  for (const ZipSlots::OtherPoint& other : others) result.otherPoints.push_back(other.point);
  child.vertexCount = result.cornerPoints + static_cast<std::int32_t>(others.size());
  link(slots, map, numberVertices(slots, map, result.cornerPoints, others), child);
  tagBoundary(slots, map, child);
  child.outgoing = outgoingCorners(child.vert, child.twin, child.vertexCount);
  result.topology = Topology(std::move(child));
  return result;
}

}  // namespace honeycomb::Far
