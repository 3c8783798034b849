#include "far/topology/crease_cut.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "far/base/index.h"

namespace honeycomb::Far {

namespace {

/// Cuts a level 0 open: first the twins, then vertex by vertex into the sectors between the cuts.
class Cut {
 public:
  Cut(const Topology& control, double sharpness) : control_(control), arrays_(control.arrays()) {
    std::erase_if(arrays_.creases, [&](const CreaseEdge& crease) { return !(crease.sharpness > sharpness); });
  }

  Reshaped make() {
    std::vector<std::int32_t> ends;
    for (const CreaseEdge& crease : arrays_.creases) {
      for (const std::int32_t h : {crease.halfEdge, crease.mate}) {
        arrays_.twin[at(h)] = -1;
        ends.push_back(control_.vert(h));
      }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    setBoundary();
    std::vector<std::int32_t> vertexOf(at(control_.vertexCount()));
    std::iota(vertexOf.begin(), vertexOf.end(), 0);
    for (const std::int32_t v : ends) openVertex(v, vertexOf);
    arrays_.vertexCount = static_cast<std::int32_t>(vertexOf.size());
    Reshaped result;
    result.topology = Topology(std::move(arrays_));
    result.vertexOf = std::move(vertexOf);
    result.faceOf.resize(at(control_.faceCount()));
    std::iota(result.faceOf.begin(), result.faceOf.end(), 0);
    result.firstOf.resize(at(control_.halfEdgeCount()));
    std::iota(result.firstOf.begin(), result.firstOf.end(), 0);
    result.lastOf = result.firstOf;
    result.vertices = sharpestEach(closedAt(result.topology));
    return result;
  }

 private:
  void setBoundary() {
    if (arrays_.creases.empty()) return;
    arrays_.threeValent = false;
    arrays_.boundary.clear();
    for (std::size_t h = 0; h < arrays_.twin.size(); ++h) {
      if (arrays_.twin[h] < 0) arrays_.boundary.push_back(static_cast<std::int32_t>(h));
    }
    arrays_.boundaryTags.assign(arrays_.boundary.size(), EdgeTag::onLine);
    arrays_.vertexTags.resize(at(control_.vertexCount()), VertexTag::interior);
  }

  /// The half-edges leaving v after which the mesh is open, in their order round v.
  std::vector<std::int32_t> sectorStarts(std::int32_t v) const {
    std::vector<std::int32_t> starts;
    for (const std::int32_t h : control_.halfEdgesFrom(v)) {
      if (arrays_.twin[at(h)] < 0) starts.push_back(h);
    }
    return starts;
  }

  void openVertex(std::int32_t v, std::vector<std::int32_t>& vertexOf) {
    const std::vector<std::int32_t> starts = sectorStarts(v);
    const VertexTag tag = tagOf(v, starts);
    for (std::size_t sector = 0; sector < starts.size(); ++sector) {
      std::int32_t part = v;
      if (sector > 0) {
        part = static_cast<std::int32_t>(vertexOf.size());
        vertexOf.push_back(v);
        arrays_.outgoing.push_back(0);
        arrays_.vertexTags.push_back(tag);
        if (held(v)) arrays_.heldCorners.push_back(part);
      }
      arrays_.vertexTags[at(part)] = tag;
      arrays_.outgoing[at(part)] = starts[sector];
      for (std::int32_t h = starts[sector]; h >= 0; h = arrays_.twin[at(control_.prev(h))]) {
        arrays_.vert[at(h)] = part;
      }
    }
  }

  bool held(std::int32_t v) const {
    return std::binary_search(control_.heldCorners().begin(), control_.heldCorners().end(), v);
  }

  VertexTag tagOf(std::int32_t v, const std::vector<std::int32_t>& starts) const {
    if (control_.onBoundary(v) || held(v) || starts.size() != 2) return VertexTag::corner;
    return sharpnessOf(starts[0]) == sharpnessOf(starts[1]) ? VertexTag::real : VertexTag::corner;
  }

  double sharpnessOf(std::int32_t h) const {
    const std::int32_t lower = std::min(h, control_.twin(h));
    return std::lower_bound(arrays_.creases.begin(), arrays_.creases.end(), lower,
                            [](const CreaseEdge& crease, std::int32_t key) { return crease.halfEdge < key; })
        ->sharpness;
  }

  /// The creases that stay closed, at their ends.
  std::vector<ClosedCrease> closedAt(const Topology& cut) const {
    std::vector<ClosedCrease> closed;
    for (const CreaseEdge& crease : control_.creases()) {
      if (cut.twin(crease.halfEdge) < 0) continue;
      for (const std::int32_t h : {crease.halfEdge, crease.mate}) closed.push_back({cut.vert(h), crease.sharpness});
    }
    return closed;
  }

  const Topology& control_;
  TopologyArrays arrays_;
};

}  // namespace

Reshaped cutCreases(const Topology& control, double sharpness) {
  return Cut(control, sharpness).make();
}

std::vector<ClosedCrease> sharpestEach(std::vector<ClosedCrease> closed) {
  std::sort(closed.begin(), closed.end(), [](const ClosedCrease& a, const ClosedCrease& b) {
    return a.element != b.element ? a.element < b.element : a.sharpness > b.sharpness;
  });
  const auto sameElement = [](const ClosedCrease& a, const ClosedCrease& b) { return a.element == b.element; };
  closed.erase(std::unique(closed.begin(), closed.end(), sameElement), closed.end());
  return closed;
}

CreaseSides::CreaseSides(const Topology& topology) {
  for (const CreaseEdge& crease : topology.creases()) {
    sides_.push_back(crease);
    sides_.push_back({crease.mate, crease.halfEdge, crease.sharpness});
  }
  std::sort(sides_.begin(), sides_.end(),
            [](const CreaseEdge& a, const CreaseEdge& b) { return a.halfEdge < b.halfEdge; });
}

const CreaseEdge* CreaseSides::find(std::int32_t b) const {
  const auto place = std::lower_bound(sides_.begin(), sides_.end(), b,
                                      [](const CreaseEdge& side, std::int32_t key) { return side.halfEdge < key; });
  return place == sides_.end() || place->halfEdge != b ? nullptr : &*place;
}

}  // namespace honeycomb::Far
