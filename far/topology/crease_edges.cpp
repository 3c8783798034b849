#include "far/topology/crease_edges.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

auto ends(const Crease& crease) {
  return std::pair(crease.vertex0, crease.vertex1);
}

Defect defectOf(DefectKind kind, const Crease& crease) {
  return {kind, -1, crease.vertex0, crease.vertex1, -1};
}

}  // namespace

CreaseEdges::CreaseEdges(const Polygons& polygons) {
  edges_ = polygons.creases;
  for (Crease& edge : edges_) {
    if (edge.vertex0 > edge.vertex1) std::swap(edge.vertex0, edge.vertex1);
    if (edge.sharpness >= kSharp && std::isfinite(edge.sharpness))
      edge.sharpness = std::numeric_limits<double>::infinity();
    else if (!(edge.sharpness >= 0 && edge.sharpness < kSharp))
      defects_.push_back(defectOf(DefectKind::creaseSharpness, edge));
  }
  std::stable_sort(edges_.begin(), edges_.end(), [](const Crease& a, const Crease& b) { return ends(a) < ends(b); });
  std::size_t kept = 0;
  for (const Crease& edge : edges_) {
    if (kept == 0 || ends(edges_[kept - 1]) != ends(edge)) {
      edges_[kept++] = edge;
    } else if (edges_[kept - 1].sharpness != edge.sharpness) {
      defects_.push_back(defectOf(DefectKind::creaseConflict, edge));
    }
  }
  edges_.resize(kept);
}

std::int64_t CreaseEdges::find(std::int32_t v, std::int32_t w) const {
  const std::pair key(std::min(v, w), std::max(v, w));
  const auto place =
      std::lower_bound(edges_.begin(), edges_.end(), key, [](const Crease& a, const auto& b) { return ends(a) < b; });
  return place == edges_.end() || ends(*place) != key ? -1 : place - edges_.begin();
}

std::vector<Defect> CreaseEdges::defects(const Polygons& polygons, std::span<const std::int32_t> cornerFace,
                                         std::span<const std::uint8_t> sound) const {
  if (edges_.empty()) return {};
  std::vector<std::atomic<bool>> found(edges_.size());
  Parallel::forEach(0, static_cast<std::int64_t>(cornerFace.size()), [&](std::int64_t c) {
    const std::size_t f = at(cornerFace[at(c)]);
    if (sound[f] == 0) return;
    const std::int64_t next = c + 1 == polygons.faceOffsets[f + 1] ? polygons.faceOffsets[f] : c + 1;
    const std::int64_t edge = find(polygons.indices[at(c)], polygons.indices[at(next)]);
    if (edge >= 0) found[at(edge)].store(true, std::memory_order_relaxed);
  });
  std::vector<Defect> defects = defects_;
  for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
    if (!found[edge]) defects.push_back(defectOf(DefectKind::creaseWithoutEdge, edges_[edge]));
  }
  return defects;
}

std::vector<std::uint8_t> creaseVertices(const Polygons& polygons) {
  std::vector<std::uint8_t> ends(at(polygons.vertexCount), 0);
  for (const Crease& crease : polygons.creases) {
    for (const std::int32_t v : {crease.vertex0, crease.vertex1}) {
      if (v >= 0 && v < polygons.vertexCount && crease.sharpness > 0) ends[at(v)] = 1;
    }
  }
  return ends;
}

void addCreases(const Polygons& polygons, TopologyArrays& arrays) {
  const CreaseEdges creases(polygons);
  if (creases.empty()) return;
  for (std::size_t f = 0; f + 1 < arrays.faceOffsets.size(); ++f) {
    for (std::int32_t h = arrays.faceOffsets[f]; h < arrays.faceOffsets[f + 1]; ++h) {
      const std::int32_t next = h + 1 == arrays.faceOffsets[f + 1] ? arrays.faceOffsets[f] : h + 1;
      const std::int32_t twin = arrays.twin[at(h)];
      if (twin < h) continue;
      const std::int64_t edge = creases.find(arrays.vert[at(h)], arrays.vert[at(next)]);
      if (edge >= 0 && creases.sharpness(edge) > 0) arrays.creases.push_back({h, twin, creases.sharpness(edge)});
    }
  }
  if (arrays.creases.empty()) return;
  arrays.heldCorners = polygons.corners;
  std::sort(arrays.heldCorners.begin(), arrays.heldCorners.end());
  arrays.heldCorners.erase(std::unique(arrays.heldCorners.begin(), arrays.heldCorners.end()), arrays.heldCorners.end());
}

}  // namespace honeycomb::Far
