#include "far/topology/topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "far/base/bytes.h"
#include "far/base/index.h"
#include "far/base/parallel.h"
#include "far/topology/crease_edges.h"
#include "far/topology/edge_matching.h"
#include "far/topology/spatial_order.h"

namespace honeycomb::Far {

namespace {

Result<void> checkShape(const Polygons& polygons) {
  if (polygons.vertexCount < 0 || polygons.faceOffsets.empty() || polygons.faceOffsets.front() != 0 ||
      polygons.faceOffsets.back() != static_cast<std::int64_t>(polygons.indices.size()) ||
      !std::is_sorted(polygons.faceOffsets.begin(), polygons.faceOffsets.end())) {
    return fail(ErrorCode::invalidMesh, "face offsets must ascend from 0 to the number of corners");
  }
  if (polygons.indices.size() > at(std::numeric_limits<std::int32_t>::max())) {
    return fail(ErrorCode::tooLarge, "the mesh has more than 2^31 - 1 half-edges; split it");
  }
  if (polygons.faceCount() == 0) return fail(ErrorCode::invalidMesh, "the mesh has no faces");
  return {};
}

Error defectError(const std::vector<Defect>& defects) {
  const Defect& first = defects.front();
  std::string message = describe(first);
  if (defects.size() > 1) message += fmt::format(" ({} defects in all)", defects.size());
  message += fmt::format("; {}", remedy(first.kind));
  if (first.face >= 0) return {ErrorCode::invalidMesh, std::move(message), first.face, ElementKind::face};
  return {ErrorCode::invalidMesh, std::move(message), first.vertex, ElementKind::vertex};
}

/// The caller's faces in the order asked for.
std::vector<std::int32_t> orderedFaces(const Polygons& polygons, const Inspection& inspection, FaceOrder order) {
  if (order == FaceOrder::spatial) return spatialFaceOrder(polygons, inspection);
  std::vector<std::int32_t> faces(at(polygons.faceCount()));
  std::iota(faces.begin(), faces.end(), 0);
  return faces;
}

/// Faces sorted stably by side count; half-edges are then the corners in that order.
TopologyArrays sortedFaces(const Polygons& polygons, const std::vector<std::int32_t>& faces) {
  std::vector<std::int32_t> sides(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::size_t f = at(faces[i]);
    sides[i] = static_cast<std::int32_t>(polygons.faceOffsets[f + 1] - polygons.faceOffsets[f]);
  }
  TopologyArrays arrays;
  arrays.vertexCount = polygons.vertexCount;
  arrays.parents = Parallel::stableOrder(sides, *std::max_element(sides.begin(), sides.end()) + 1);
  arrays.faceOffsets.resize(faces.size() + 1, 0);
  for (std::size_t f = 0; f < sides.size(); ++f) {
    const std::int32_t n = sides[at(arrays.parents[f])];
    arrays.parents[f] = faces[at(arrays.parents[f])];
    const std::int32_t first = arrays.faceOffsets[f];
    if (arrays.runs.empty() || arrays.runs.back().sides != n) {
      arrays.runs.push_back({FaceKind::full, FaceParent::face, n, static_cast<std::int32_t>(f), first, 0});
    }
    ++arrays.runs.back().faceCount;
    arrays.faceOffsets[f + 1] = first + n;
  }
  return arrays;
}

void copyLoops(const Polygons& polygons, const EdgeMatching& edges, TopologyArrays& arrays) {
  const std::size_t corners = polygons.indices.size();
  arrays.vert.resize(corners);
  arrays.twin.resize(corners);
  arrays.face.resize(corners);
  std::vector<std::int32_t> place(corners);  // half-edge of each corner
  const auto faceCount = static_cast<std::int64_t>(arrays.parents.size());
  Parallel::forEach(
      0, faceCount,
      [&](std::int64_t f) {
        std::int64_t corner = polygons.faceOffsets[at(arrays.parents[at(f)])];
        for (std::int32_t h = arrays.faceOffsets[at(f)]; h < arrays.faceOffsets[at(f) + 1]; ++h, ++corner) {
          arrays.vert[at(h)] = polygons.indices[at(corner)];
          arrays.face[at(h)] = static_cast<std::int32_t>(f);
          place[at(corner)] = h;
        }
      },
      1024);
  Parallel::forEach(0, static_cast<std::int64_t>(corners), [&](std::int64_t c) {
    const std::int32_t twin = edges.twin[at(c)];
    arrays.twin[at(place[at(c)])] = twin < 0 ? -1 : place[at(twin)];
  });
}

void tagBoundary(const Polygons& polygons, TopologyArrays& arrays) {
  for (std::size_t h = 0; h < arrays.twin.size(); ++h) {
    if (arrays.twin[h] < 0) arrays.boundary.push_back(static_cast<std::int32_t>(h));
  }
  if (arrays.boundary.empty()) return;
  arrays.boundaryTags.assign(arrays.boundary.size(), EdgeTag::onLine);
  arrays.vertexTags.assign(at(arrays.vertexCount), VertexTag::interior);
  for (const std::int32_t h : arrays.boundary) arrays.vertexTags[at(arrays.vert[at(h)])] = VertexTag::real;
  for (const std::int32_t v : polygons.corners) {
    if (arrays.vertexTags[at(v)] == VertexTag::real) arrays.vertexTags[at(v)] = VertexTag::corner;
  }
}

}  // namespace

Result<Topology> Topology::create(const Polygons& polygons, FaceOrder order) {
  if (auto shape = checkShape(polygons); !shape) return tl::unexpected(shape.error());
  const Inspection inspection = inspect(polygons);
  if (!inspection.defects.empty()) return tl::unexpected(defectError(inspection.defects));
  TopologyArrays arrays = sortedFaces(polygons, orderedFaces(polygons, inspection, order));
  copyLoops(polygons, inspection.edges, arrays);
  arrays.outgoing = outgoingCorners(arrays.vert, arrays.twin, arrays.vertexCount);
  tagBoundary(polygons, arrays);
  addCreases(polygons, arrays);
  return Topology(std::move(arrays));
}

std::int32_t Topology::facesAt(std::int32_t v) const {
  std::int32_t count = 0;
  for ([[maybe_unused]] const std::int32_t h : halfEdgesFrom(v)) ++count;
  return count;
}

std::int32_t Topology::valence(std::int32_t v) const {
  return facesAt(v) + (onBoundary(v) ? 1 : 0);
}

std::int32_t Topology::enteringBoundary(std::int32_t v) const {
  std::int32_t p = prev(outgoing(v));
  while (twin(p) >= 0) p = prev(twin(p));
  return p;
}

const FaceRun& Topology::run(std::int32_t f) const {
  const auto after = std::upper_bound(runs().begin(), runs().end(), f,
                                      [](std::int32_t face, const FaceRun& run) { return face < run.firstFace; });
  return *std::prev(after);
}

std::int64_t Topology::byteCount() const {
  const TopologyArrays& a = loops();
  return state_->linkBytes() + bytes(a.runs) + bytes(a.vert) + bytes(a.faceOffsets) + bytes(a.parents) +
         bytes(a.boundary) + bytes(a.boundaryTags) + bytes(a.vertexTags) + bytes(a.creases) + bytes(a.heldCorners);
}

TopologyArrays Topology::arrays() const& {
  return state_->copy();
}

TopologyArrays Topology::arrays() && {
  const std::shared_ptr<TopologyState> state = std::move(state_);
  return state.use_count() == 1 ? state->take() : state->copy();
}

std::vector<std::int32_t> boundaryRanks(const Topology& topology) {
  if (topology.closed()) return {};
  std::vector<std::int32_t> ranks(at(topology.halfEdgeCount()), -1);
  const auto boundary = topology.boundary();
  Parallel::forEach(0, static_cast<std::int64_t>(boundary.size()),
                    [&](std::int64_t r) { ranks[at(boundary[at(r)])] = static_cast<std::int32_t>(r); });
  return ranks;
}

}  // namespace honeycomb::Far
