#include "far/conversions/conversion_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "far/base/index.h"
#include "far/base/parallel.h"

namespace honeycomb::Far {
namespace {

/// Offsets of consecutive pieces of the given lengths.
std::vector<std::int64_t> offsetsOf(std::span<const std::int32_t> lengths) {
  std::vector<std::int64_t> offsets(lengths.size() + 1, 0);
  for (std::size_t i = 0; i < lengths.size(); ++i) offsets[i + 1] = offsets[i] + lengths[i];
  return offsets;
}

}  // namespace

CallerFaces::CallerFaces(const Topology& topology)
    : topology_(&topology), sorted_(at(topology.faceCount())), firstCorner_(at(topology.faceCount()) + 1, 0) {
  Parallel::forEach(0, topology.faceCount(), [&](std::int64_t f) {
    const std::size_t caller = at(topology.inputFace(static_cast<std::int32_t>(f)));
    sorted_[caller] = static_cast<std::int32_t>(f);
    firstCorner_[caller] = topology.sides(static_cast<std::int32_t>(f));
  });
  Parallel::exclusiveScan(firstCorner_);
}

void layOutFaces(Polygons& polygons, std::span<const std::int32_t> sides) {
  polygons.faceOffsets = offsetsOf(sides);
  polygons.indices.resize(at(polygons.faceOffsets.back()));
}

std::span<std::int32_t> faceLoop(Polygons& polygons, std::int64_t f) {
  const std::int64_t first = polygons.faceOffsets[at(f)];
  return std::span(polygons.indices).subspan(at(first), at(polygons.faceOffsets[at(f) + 1] - first));
}

void layOutRows(WeightedRows& rows, std::span<const std::int32_t> lengths) {
  rows.offsets = offsetsOf(lengths);
  rows.indices.resize(at(rows.offsets.back()));
  rows.weights.resize(at(rows.offsets.back()));
}

void setMean(WeightedRows& rows, std::int64_t r, std::span<const std::int32_t> vertices) {
  const std::int64_t first = rows.offsets[at(r)];
  std::copy(vertices.begin(), vertices.end(), rows.indices.begin() + first);
  std::fill_n(rows.weights.begin() + first, vertices.size(), 1.0 / static_cast<double>(vertices.size()));
}

Result<void> checkSize(std::string_view what, std::int64_t vertices, std::int64_t corners) {
  if (std::max(vertices, corners) <= std::numeric_limits<std::int32_t>::max()) return {};
  return fail(ErrorCode::tooLarge, fmt::format("{} would have {} vertices and {} corners, past 2^31 - 1; use a smaller "
                                               "mesh",
                                               what, vertices, corners));
}

std::vector<std::int32_t> countFacesAt(const Topology& topology) {
  std::vector<std::int32_t> counts(at(topology.vertexCount()));
  Parallel::forEach(0, topology.vertexCount(),
                    [&](std::int64_t v) { counts[at(v)] = topology.facesAt(static_cast<std::int32_t>(v)); });
  return counts;
}

Result<void> checkInsideVertices(std::string_view what, const Topology& topology,
                                 std::span<const std::int32_t> facesAt) {
  for (std::int32_t v = 0; v < topology.vertexCount(); ++v) {
    if (topology.onBoundary(v) || facesAt[at(v)] >= 3) continue;
    return fail(ErrorCode::invalidMesh,
                fmt::format("{} has {} faces round it, so its face in {} would have {} sides; dissolve it",
                            elementName(ElementKind::vertex, v), facesAt[at(v)], what, facesAt[at(v)]),
                v, ElementKind::vertex);
  }
  return {};
}

std::vector<std::int32_t> taggedCorners(const Topology& topology) {
  std::vector<std::int32_t> corners;
  for (const std::int32_t h : topology.boundary()) {
    const VertexTag tag = topology.vertexTag(topology.vert(h));
    if (tag == VertexTag::corner || tag == VertexTag::fixedCorner) corners.push_back(topology.vert(h));
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

Result<Conversion> verticesAndCentres(std::string_view what, const Topology& topology, const CallerFaces& faces,
                                      std::int64_t corners) {
  const std::int32_t vertices = topology.vertexCount();
  if (const auto fits = checkSize(what, std::int64_t{vertices} + faces.count(), corners); !fits)
    return tl::unexpected(fits.error());
  Conversion result;
  result.sourceCount = vertices;
  result.polygons.vertexCount = vertices + faces.count();
  result.polygons.corners = taggedCorners(topology);
  std::vector<std::int32_t> lengths(at(result.polygons.vertexCount), 1);
  Parallel::forEach(0, faces.count(),
                    [&](std::int64_t f) { lengths[at(vertices + f)] = faces.sides(static_cast<std::int32_t>(f)); });
  layOutRows(result.rows, lengths);
  Parallel::forEach(0, vertices, [&](std::int64_t i) {
    const auto v = static_cast<std::int32_t>(i);
    setMean(result.rows, i, std::span(&v, 1));
  });
  Parallel::forEach(0, faces.count(), [&](std::int64_t f) {
    setMean(result.rows, vertices + f, faces.loop(static_cast<std::int32_t>(f)));
  });
  return result;
}

}  // namespace honeycomb::Far
