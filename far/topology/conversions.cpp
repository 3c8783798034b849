#include "far/topology/conversions.h"

#include <fmt/format.h>

#include <limits>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {
namespace {

/// The face of the topology that has each of the caller's numbers.
std::vector<std::int32_t> sortedFaces(const Topology& topology) {
  std::vector<std::int32_t> sorted(at(topology.faceCount()));
  for (std::int32_t f = 0; f < topology.faceCount(); ++f) sorted[at(topology.inputFace(f))] = f;
  return sorted;
}

std::span<const std::int32_t> loop(const Topology& topology, std::int32_t f) {
  return topology.vert().subspan(at(topology.faceOffsets()[at(f)]), at(topology.sides(f)));
}

void addMean(Conversion& conversion, std::span<const std::int32_t> vertices) {
  conversion.meanOf.insert(conversion.meanOf.end(), vertices.begin(), vertices.end());
  conversion.meanOffsets.push_back(static_cast<std::int64_t>(conversion.meanOf.size()));
}

/// Adds a dual vertex for each face with a vertex inside; returns the dual vertex of each face, or -1.
std::vector<std::int32_t> addDualVertices(const Topology& topology, Conversion& dual) {
  std::vector<std::int32_t> dualVertex(at(topology.faceCount()), -1);
  for (const std::int32_t f : sortedFaces(topology)) {
    bool inside = false;
    for (const std::int32_t v : loop(topology, f)) inside = inside || !topology.onBoundary(v);
    if (!inside) continue;
    dualVertex[at(f)] = dual.polygons.vertexCount++;
    addMean(dual, loop(topology, f));
  }
  return dualVertex;
}

std::vector<std::int32_t> facesRound(const Topology& topology, std::int32_t v) {
  std::vector<std::int32_t> faces;
  const std::int32_t first = topology.outgoing(v);
  std::int32_t h = first;
  do {
    faces.push_back(topology.face(h));
    h = topology.nextOutgoing(h);
  } while (h != first);
  return faces;
}

}  // namespace

Result<Conversion> dual(const Topology& topology) {
  Conversion result;
  const std::vector<std::int32_t> dualVertex = addDualVertices(topology, result);
  for (std::int32_t v = 0; v < topology.vertexCount(); ++v) {
    if (topology.onBoundary(v)) continue;
    std::vector<std::int32_t> face = facesRound(topology, v);
    if (face.size() < 3)
      return fail(ErrorCode::invalidMesh,
                  fmt::format("vertex {} (counted from 0) has {} faces round it, so its face in the dual would have {} "
                              "sides; dissolve it",
                              v, face.size(), face.size()),
                  v);
    for (std::int32_t& f : face) f = dualVertex[at(f)];
    result.polygons.addFace(face);
  }
  if (result.polygons.faceCount() == 0)
    return fail(ErrorCode::invalidMesh, "every vertex is on a boundary, so the dual has no faces; give a larger mesh");
  return result;
}

Result<Conversion> triangulate(const Topology& topology) {
  const std::int32_t corners = topology.vertexCount();
  if (std::int64_t{corners} + topology.faceCount() > std::numeric_limits<std::int32_t>::max())
    return fail(ErrorCode::tooLarge, "the triangles would have more than 2^31 - 1 vertices; use a smaller mesh");
  Conversion result;
  result.polygons.vertexCount = corners + topology.faceCount();
  for (std::int32_t v = 0; v < corners; ++v) addMean(result, std::span(&v, 1));
  for (const std::int32_t f : sortedFaces(topology)) {
    const std::span<const std::int32_t> face = loop(topology, f);
    addMean(result, face);
    for (std::size_t k = 0; k < face.size(); ++k)
      result.polygons.addFace({face[k], face[(k + 1) % face.size()], corners + topology.inputFace(f)});
  }
  return result;
}

std::vector<double> means(const Conversion& conversion, std::span<const double> values, std::int32_t length) {
  std::vector<double> result(at(length) * at(conversion.polygons.vertexCount));
  Parallel::forEach(0, conversion.polygons.vertexCount, [&](std::int64_t v) {
    const std::int64_t begin = conversion.meanOffsets[at(v)], end = conversion.meanOffsets[at(v) + 1];
    for (std::int32_t k = 0; k < length; ++k) {
      double sum = 0;
      for (std::int64_t i = begin; i < end; ++i) sum += values[at(length) * at(conversion.meanOf[at(i)]) + at(k)];
      result[at(length) * at(v) + at(k)] = sum / static_cast<double>(end - begin);
    }
  });
  return result;
}

}  // namespace honeycomb::Far
