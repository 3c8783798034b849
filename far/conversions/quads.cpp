#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/conversions/conversion_parts.h"
#include "far/conversions/conversions.h"

namespace honeycomb::Far {
namespace {

/// The number of the first polygon that each face is cut into.
std::vector<std::int32_t> firstPolygons(const CallerFaces& faces) {
  std::vector<std::int32_t> first(at(faces.count()) + 1, 0);
  for (std::int32_t f = 0; f < faces.count(); ++f) first[at(f)] = (faces.sides(f) + 1) / 2;
  Parallel::exclusiveScan(first);
  return first;
}

/// Quads, and a triangle behind those of every face of odd sides.
std::vector<std::int32_t> polygonSides(const CallerFaces& faces, std::span<const std::int32_t> first) {
  std::vector<std::int32_t> sides(at(first.back()), 4);
  for (std::int32_t f = 0; f < faces.count(); ++f)
    if (faces.sides(f) % 2 == 1) sides[at(first[at(f) + 1] - 1)] = 3;
  return sides;
}

}  // namespace

Result<Conversion> quads(const Topology& topology) {
  const CallerFaces faces(topology);
  const std::int64_t corners = 2 * std::int64_t{topology.halfEdgeCount()} + faces.count();
  Result<Conversion> result = verticesAndCentres("the quads", topology, faces, corners);
  if (!result) return result;
  const std::vector<std::int32_t> first = firstPolygons(faces);
  layOutFaces(result->polygons, polygonSides(faces, first));
  result->faceSources.resize(at(first.back()));
  Parallel::forEach(0, faces.count(), [&](std::int64_t i) {
    const auto f = static_cast<std::int32_t>(i);
    const std::span<const std::int32_t> loop = faces.loop(f);
    for (std::size_t k = 0; k < loop.size(); k += 2) {
      const std::int64_t polygon = first[at(f)] + static_cast<std::int64_t>(k / 2);
      const std::span<std::int32_t> corner = faceLoop(result->polygons, polygon);
      corner[0] = topology.vertexCount() + f;
      for (std::size_t j = 1; j < corner.size(); ++j) corner[j] = loop[(k + j - 1) % loop.size()];
      result->faceSources[at(polygon)] = {FaceParent::face, f};
    }
  });
  return result;
}

}  // namespace honeycomb::Far
