#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "far/topology/defects.h"
#include "far/topology/polygons.h"
#include "far/topology/topology.h"

namespace honeycomb::Far {

/// The edges that a caller's creases name, to be looked up by their ends.
class CreaseEdges {
 public:
  explicit CreaseEdges(const Polygons& polygons);

  bool empty() const { return edges_.empty(); }
  /// The place of the crease between v and w among the edges, ascending by ends; -1 if there is none.
  std::int64_t find(std::int32_t v, std::int32_t w) const;
  /// From kSharp on infinity.
  double sharpness(std::int64_t edge) const { return edges_[static_cast<std::size_t>(edge)].sharpness; }

  /// What is wrong with the creases themselves, and those without an edge among the faces that are sound.
  std::vector<Defect> defects(const Polygons& polygons, std::span<const std::int32_t> cornerFace,
                              std::span<const std::uint8_t> sound) const;

 private:
  std::vector<Crease> edges_;  // the lower vertex first; ascending, each edge once
  std::vector<Defect> defects_;
};

/// Per vertex: is it the end of a crease that is sharp?
std::vector<std::uint8_t> creaseVertices(const Polygons& polygons);

/// Puts the creases and the corner tags into the arrays of a level 0 that is otherwise complete. Creases on boundary
/// edges and those of sharpness 0 are left out.
void addCreases(const Polygons& polygons, TopologyArrays& arrays);

}  // namespace honeycomb::Far
