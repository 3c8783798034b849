#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/conversions/conversion_parts.h"
#include "far/conversions/conversions.h"

namespace honeycomb::Far {
namespace {

/// The vertex of the dual that each face of the caller becomes, or -1 where all its vertices are on a boundary.
std::vector<std::int32_t> dualVertices(const Topology& topology, const CallerFaces& faces, std::int32_t& count) {
  std::vector<std::int32_t> vertex(at(faces.count()) + 1, 0);
  Parallel::forEach(0, faces.count(), [&](std::int64_t f) {
    for (const std::int32_t v : faces.loop(static_cast<std::int32_t>(f)))
      if (!topology.onBoundary(v)) vertex[at(f)] = 1;
  });
  count = static_cast<std::int32_t>(Parallel::exclusiveScan(vertex));
  for (std::int32_t f = 0; f < faces.count(); ++f)
    if (vertex[at(f)] == vertex[at(f) + 1]) vertex[at(f)] = -1;
  return vertex;
}

void setRows(const CallerFaces& faces, std::span<const std::int32_t> dualVertex, Conversion& dual) {
  std::vector<std::int32_t> lengths(at(dual.polygons.vertexCount));
  for (std::int32_t f = 0; f < faces.count(); ++f)
    if (dualVertex[at(f)] >= 0) lengths[at(dualVertex[at(f)])] = faces.sides(f);
  layOutRows(dual.rows, lengths);
  Parallel::forEach(0, faces.count(), [&](std::int64_t f) {
    if (dualVertex[at(f)] >= 0) setMean(dual.rows, dualVertex[at(f)], faces.loop(static_cast<std::int32_t>(f)));
  });
}

void setFaces(const Topology& topology, std::span<const std::int32_t> facesAt, std::span<const std::int32_t> dualVertex,
              Conversion& dual) {
  std::vector<std::int32_t> sides;
  for (std::int32_t v = 0; v < topology.vertexCount(); ++v) {
    if (topology.onBoundary(v)) continue;
    sides.push_back(facesAt[at(v)]);
    dual.faceSources.push_back({FaceParent::vertex, v});
  }
  layOutFaces(dual.polygons, sides);
  Parallel::forEach(0, dual.polygons.faceCount(), [&](std::int64_t f) {
    std::int32_t h = topology.outgoing(dual.faceSources[at(f)].element);
    for (std::int32_t& corner : faceLoop(dual.polygons, f)) {
      corner = dualVertex[at(topology.inputFace(topology.face(h)))];
      h = topology.nextOutgoing(h);
    }
  });
}

}  // namespace

Result<Conversion> dual(const Topology& topology) {
  const std::vector<std::int32_t> facesAt = countFacesAt(topology);
  if (const auto sound = checkInsideVertices("the dual", topology, facesAt); !sound)
    return tl::unexpected(sound.error());
  const CallerFaces faces(topology);
  Conversion result;
  result.sourceCount = topology.vertexCount();
  const std::vector<std::int32_t> dualVertex = dualVertices(topology, faces, result.polygons.vertexCount);
  setRows(faces, dualVertex, result);
  setFaces(topology, facesAt, dualVertex, result);
  if (result.polygons.faceCount() == 0)
    return fail(ErrorCode::invalidMesh, "every vertex is on a boundary, so the dual has no faces; give a larger mesh");
  return result;
}

}  // namespace honeycomb::Far
