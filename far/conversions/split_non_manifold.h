#pragma once

#include <cstdint>
#include <vector>

#include "far/topology/polygons.h"

namespace honeycomb::Far {

/// Polygons made an oriented manifold by cutting them open.
struct ManifoldSplit {
  Polygons polygons;
  std::vector<std::int32_t> sourceVertices;  ///< per vertex: the one it was or is a duplicate of
  std::vector<std::int64_t> sourceFaces;     ///< per face: its number before
  std::int64_t edgesCut = 0;                 ///< with more than two faces, or with two that run the same way
  std::int64_t bowTies = 0;                  ///< vertices in more than one fan without such an edge
  std::int64_t facesLeftOut = 0;             ///< with fewer than three corners, a vertex twice, or one that isn't there

  /// How many vertices there are more than before.
  std::int64_t duplicates(std::int32_t verticesBefore) const { return polygons.vertexCount - verticesBefore; }
};

/// Cuts along every edge with more than two faces or with two that run the same way, and duplicates vertices so that
/// each fan of faces has its own: no face is lost but those that are none. The first fan, by the lowest corner, keeps
/// the vertex; duplicates are numbered behind all others. Tags follow: a crease lies on every copy of its edge, a
/// corner on every copy of its vertex. Isolated vertices stay. A manifold comes back as it is. Linear but for the
/// sorting that Topology::create does too; repeated while cutting at one place leaves another, at most once a corner.
ManifoldSplit splitNonManifold(const Polygons& polygons);

}  // namespace honeycomb::Far
