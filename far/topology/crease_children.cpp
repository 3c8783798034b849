#include "far/topology/crease_children.h"

#include <algorithm>

#include "far/base/index.h"
#include "far/topology/crease_cut.h"

namespace honeycomb::Far {

namespace {

class Pairing {
 public:
  Pairing(const Topology& parent, const SplitResult& child)
      : parent_(parent),
        child_(child),
        sides_(parent),
        start_(parent.boundary().size(), -1),
        end_(parent.boundary().size(), -1),
        entering_(child.otherPoints.size(), -1) {
    for (std::size_t i = 0; i < child.otherPoints.size(); ++i)
      place(child.otherPoints[i], static_cast<std::int32_t>(i));
    for (const std::int32_t b : child.topology.boundary()) entering_[other(child.topology.dest(b))] = b;
  }

  std::vector<CreaseEdge> creases() const {
    std::vector<CreaseEdge> creases;
    const Topology& topology = child_.topology;
    for (const std::int32_t b : topology.boundary()) {
      const std::int32_t from = topology.vert(b);
      const std::int32_t to = topology.dest(b);
      // Corners that are held have no single partner; an edge has at most one.
      const std::int32_t known = partner(to) >= 0 ? to : from;
      if (partner(known) < 0) continue;
      const std::int32_t mate = known == to ? topology.outgoing(partner(to)) : entering_[other(partner(from))];
      if (b < mate) creases.push_back({b, mate, sides_.sharpness(label(known).halfEdge) - 1});
    }
    return creases;
  }

  std::vector<std::int32_t> heldCorners() const {
    std::vector<std::int32_t> held;
    for (std::size_t i = 0; i < child_.otherPoints.size(); ++i) {
      const NewPoint& point = child_.otherPoints[i];
      if (point.kind != PointKind::fixedCorner) continue;
      const auto corners = parent_.heldCorners();
      if (std::binary_search(corners.begin(), corners.end(), parent_.vert(point.halfEdge))) {
        held.push_back(child_.cornerPoints + static_cast<std::int32_t>(i));
      }
    }
    return held;
  }

 private:
  std::size_t rank(std::int32_t b) const {
    const auto boundary = parent_.boundary();
    return at(std::lower_bound(boundary.begin(), boundary.end(), b) - boundary.begin());
  }
  std::size_t other(std::int32_t v) const { return at(v - child_.cornerPoints); }
  const NewPoint& label(std::int32_t v) const { return child_.otherPoints[other(v)]; }

  void place(const NewPoint& point, std::int32_t i) {
    switch (point.kind) {
      case PointKind::edgeMiddle:
        start_[rank(point.halfEdge)] = end_[rank(point.halfEdge)] = child_.cornerPoints + i;
        return;
      case PointKind::cutStart:
        start_[rank(point.halfEdge)] = child_.cornerPoints + i;
        return;
      case PointKind::cutEnd:
        end_[rank(point.halfEdge)] = child_.cornerPoints + i;
        return;
      default:
        return;
    }
  }

  /// The copy of boundary vertex v on the other side of its crease; -1 if there is none, or not one.
  std::int32_t partner(std::int32_t v) const {
    const NewPoint& point = label(v);
    const std::int32_t mate = sides_.mate(point.halfEdge);
    if (mate < 0 || point.kind == PointKind::fixedCorner) return -1;
    return point.kind == PointKind::cutEnd ? start_[rank(mate)] : end_[rank(mate)];
  }

  const Topology& parent_;
  const SplitResult& child_;
  CreaseSides sides_;
  std::vector<std::int32_t> start_, end_;  // per boundary edge of the parent: its points near its ends
  std::vector<std::int32_t> entering_;     // per other point on the boundary: the boundary half-edge that enters it
};

}  // namespace

CreaseChildren creaseChildren(const Topology& parent, const SplitResult& child) {
  if (parent.creases().empty()) return {};
  const Pairing pairing(parent, child);
  return {pairing.creases(), pairing.heldCorners()};
}

}  // namespace honeycomb::Far
