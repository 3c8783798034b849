#include "apps/viewer/line_mesh.h"

#include <algorithm>

namespace honeycomb::Viewer {

std::vector<std::int32_t> edgePairs(const Far::Topology& topology) {
  std::vector<std::int32_t> pairs;
  pairs.reserve(2 * static_cast<std::size_t>(topology.edgeCount()));
  for (std::int32_t h = 0; h < topology.halfEdgeCount(); ++h)
    if (topology.leads(h)) {
      pairs.push_back(topology.vert(h));
      pairs.push_back(topology.dest(h));
    }
  return pairs;
}

Result<LineMesh> uploadLines(const Gpu& gpu, std::int32_t vertexCount, std::span<const std::int32_t> pairs) {
  const bool known = std::all_of(pairs.begin(), pairs.end(), [&](std::int32_t v) { return v >= 0 && v < vertexCount; });
  if (!known || pairs.size() % 2 != 0)
    return fail(ErrorCode::invalidMesh, "the lines to draw must join vertices of the mesh, two each");
  Maker make(gpu);
  LineMesh lines;
  lines.vertexCount = vertexCount;
  lines.lineCount = static_cast<std::uint32_t>(pairs.size() / 2);
  lines.pairs = make.buffer(std::as_bytes(pairs), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  if (!make.ok()) return tl::unexpected(*make.error());
  return lines;
}

}  // namespace honeycomb::Viewer
