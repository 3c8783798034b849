#include "apps/viewer/cell_mesh.h"

#include <algorithm>
#include <vector>

namespace honeycomb::Viewer {
namespace {

std::vector<std::uint32_t> cellIndices(const CellMeshContent& content) {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * content.corners.size());
  const std::size_t faces = content.faceColours.size();
  for (std::size_t f = 0; f < faces; ++f) {
    const auto begin = static_cast<std::size_t>(content.faceOffsets[f]);
    const auto end = static_cast<std::size_t>(content.faceOffsets[f + 1]);
    for (std::size_t h = begin; h < end; ++h) {
      indices.push_back(static_cast<std::uint32_t>(static_cast<std::size_t>(content.vertexCount) + f));
      indices.push_back(static_cast<std::uint32_t>(content.corners[h]));
      indices.push_back(static_cast<std::uint32_t>(content.corners[h + 1 == end ? begin : h + 1]));
    }
  }
  return indices;
}

std::vector<std::uint32_t> solidIndices(const CellMeshContent& content) {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * content.corners.size());
  for (std::size_t f = 0; f < content.faceColours.size(); ++f) {
    const auto begin = static_cast<std::size_t>(content.faceOffsets[f]);
    const auto end = static_cast<std::size_t>(content.faceOffsets[f + 1]);
    for (std::size_t h = begin + 1; h + 1 < end; ++h) {
      indices.push_back(static_cast<std::uint32_t>(content.corners[begin]));
      indices.push_back(static_cast<std::uint32_t>(content.corners[h]));
      indices.push_back(static_cast<std::uint32_t>(content.corners[h + 1]));
    }
  }
  return indices;
}

bool fitsTogether(const CellMeshContent& content) {
  const auto& offsets = content.faceOffsets;
  const bool sized = offsets.size() == content.faceColours.size() + 1 && !offsets.empty() && offsets.front() == 0 &&
                     static_cast<std::size_t>(offsets.back()) == content.corners.size();
  return sized && std::is_sorted(offsets.begin(), offsets.end()) &&
         std::all_of(content.corners.begin(), content.corners.end(),
                     [&](std::int32_t v) { return v >= 0 && v < content.vertexCount; });
}

}  // namespace

Result<CellMesh> uploadCells(const Gpu& gpu, const CellMeshContent& content) {
  if (!fitsTogether(content)) {
    return fail(
        ErrorCode::invalidMesh,
        "the faces to draw do not fit together: offsets must ascend from 0 to the number of corners, there must "
        "be a colour for each face, and corners must name vertices of the mesh");
  }
  if (content.corners.size_bytes() > gpu.limits.maxStorageBufferRange) {
    return fail(ErrorCode::tooLarge, "the mesh has more corners than the device binds at once; draw a lower level");
  }
  const std::vector<std::uint32_t> cells = cellIndices(content);
  const std::vector<std::uint32_t> solid = solidIndices(content);
  Maker make(gpu);
  CellMesh mesh;
  mesh.vertexCount = content.vertexCount;
  mesh.cellIndexCount = static_cast<std::uint32_t>(cells.size());
  mesh.solidIndexCount = static_cast<std::uint32_t>(solid.size());
  mesh.cellIndices = make.buffer(std::as_bytes(std::span(cells)), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  mesh.solidIndices = make.buffer(std::as_bytes(std::span(solid)), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  mesh.faceOffsets = make.buffer(std::as_bytes(content.faceOffsets), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  mesh.corners = make.buffer(std::as_bytes(content.corners), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  mesh.faceColours = make.buffer(std::as_bytes(content.faceColours), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  if (!make.ok()) return tl::unexpected(*make.error());
  return mesh;
}

}  // namespace honeycomb::Viewer
