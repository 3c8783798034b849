#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/conversions/conversion_parts.h"
#include "far/conversions/conversions.h"

namespace honeycomb::Far {

Result<Conversion> triangulate(const Topology& topology) {
  const CallerFaces faces(topology);
  Result<Conversion> result =
      verticesAndCentres("the triangles", topology, faces, 3 * std::int64_t{topology.halfEdgeCount()});
  if (!result) return result;
  layOutFaces(result->polygons, std::vector<std::int32_t>(at(topology.halfEdgeCount()), 3));
  result->faceSources.resize(at(topology.halfEdgeCount()));
  Parallel::forEach(0, faces.count(), [&](std::int64_t i) {
    const auto f = static_cast<std::int32_t>(i);
    const std::span<const std::int32_t> loop = faces.loop(f);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::size_t t = at(faces.firstCorner(f)) + k;
      const std::span<std::int32_t> triangle = faceLoop(result->polygons, static_cast<std::int64_t>(t));
      triangle[0] = loop[k];
      triangle[1] = loop[k + 1 == loop.size() ? 0 : k + 1];
      triangle[2] = topology.vertexCount() + f;
      result->faceSources[t] = {FaceParent::face, f};
    }
  });
  return result;
}

}  // namespace honeycomb::Far
