#include "far/topology/edge_matching.h"

#include <algorithm>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {

namespace {

/// Both ends of each corner's edge, and the tie-breaking order of corners.
struct EdgeKeys {
  std::vector<std::int32_t> low, high;
};

EdgeKeys edgeKeys(const Polygons& polygons, std::span<const std::int32_t> cornerFace,
                  std::span<const std::uint8_t> sound) {
  const std::size_t corners = polygons.indices.size();
  EdgeKeys keys{std::vector<std::int32_t>(corners), std::vector<std::int32_t>(corners)};
  Parallel::forEach(0, static_cast<std::int64_t>(corners), [&](std::int64_t c) {
    const std::size_t f = at(cornerFace[at(c)]);
    if (!sound[f]) {
      keys.low[at(c)] = polygons.vertexCount;
      keys.high[at(c)] = -1;
      return;
    }
    const std::int64_t next = c + 1 == polygons.faceOffsets[f + 1] ? polygons.faceOffsets[f] : c + 1;
    const std::int32_t v = polygons.indices[at(c)];
    const std::int32_t w = polygons.indices[at(next)];
    keys.low[at(c)] = std::min(v, w);
    keys.high[at(c)] = std::max(v, w);
  });
  return keys;
}

/// Links the corners of one edge, or reports what is wrong with it.
void linkEdge(const Polygons& polygons, std::span<const std::int32_t> cornerFace, std::span<const std::int32_t> edge,
              std::int32_t low, std::int32_t high, std::vector<std::int32_t>& twin, std::vector<Defect>& defects) {
  if (edge.size() == 1) {
    twin[at(edge[0])] = EdgeMatching::kBoundary;
    return;
  }
  const bool overused = edge.size() > 2;
  if (overused || polygons.indices[at(edge[0])] == polygons.indices[at(edge[1])]) {
    const DefectKind kind = overused ? DefectKind::edgeOverused : DefectKind::opposedFaces;
    defects.push_back({kind, cornerFace[at(edge[overused ? 2 : 1])], low, high, cornerFace[at(edge[0])]});
    for (const std::int32_t c : edge) twin[at(c)] = EdgeMatching::kBroken;
    return;
  }
  twin[at(edge[0])] = edge[1];
  twin[at(edge[1])] = edge[0];
}

}  // namespace

std::vector<std::int32_t> cornerFaces(const Polygons& polygons) {
  std::vector<std::int32_t> faces(polygons.indices.size());
  Parallel::forEach(0, polygons.faceCount(), [&](std::int64_t f) {
    std::fill(faces.begin() + polygons.faceOffsets[at(f)], faces.begin() + polygons.faceOffsets[at(f) + 1],
              static_cast<std::int32_t>(f));
  });
  return faces;
}

EdgeMatching matchEdges(const Polygons& polygons, std::span<const std::int32_t> cornerFace,
                        std::span<const std::uint8_t> sound) {
  const EdgeKeys keys = edgeKeys(polygons, cornerFace, sound);
  Array<std::int32_t> order = Parallel::stableOrder(keys.low, polygons.vertexCount + 1);
  std::vector<std::int32_t> firstOf(at(polygons.vertexCount) + 2, 0);
  for (const std::int32_t low : keys.low) ++firstOf[at(low)];
  Parallel::exclusiveScan(firstOf);

  EdgeMatching matching;
  matching.twin.assign(polygons.indices.size(), EdgeMatching::kBroken);
  std::vector<std::vector<Defect>> found(at(polygons.vertexCount));
  Parallel::forEach(
      0, polygons.vertexCount,
      [&](std::int64_t v) {
        const auto begin = order.begin() + firstOf[at(v)];
        const auto end = order.begin() + firstOf[at(v) + 1];
        std::sort(begin, end, [&](std::int32_t a, std::int32_t b) {
          return keys.high[at(a)] != keys.high[at(b)] ? keys.high[at(a)] < keys.high[at(b)] : a < b;
        });
        for (auto first = begin; first != end;) {
          const std::int32_t high = keys.high[at(*first)];
          const auto last = std::find_if(first, end, [&](std::int32_t c) { return keys.high[at(c)] != high; });
          linkEdge(polygons, cornerFace, {first, last}, static_cast<std::int32_t>(v), high, matching.twin,
                   found[at(v)]);
          first = last;
        }
      },
      512);
  for (const std::vector<Defect>& some : found) {
    matching.defects.insert(matching.defects.end(), some.begin(), some.end());
  }
  return matching;
}

Array<std::int32_t> outgoingCorners(std::span<const std::int32_t> vert, std::span<const std::int32_t> twin,
                                    std::int32_t vertexCount) {
  Array<std::int32_t> outgoing(at(vertexCount), -1);
  for (std::size_t c = vert.size(); c-- > 0;) {
    std::int32_t& h = outgoing[at(vert[c])];
    if (twin[c] < 0 || h < 0 || twin[at(h)] >= 0) h = static_cast<std::int32_t>(c);
  }
  return outgoing;
}

}  // namespace honeycomb::Far
