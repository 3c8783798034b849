#pragma once

#include <cstdint>
#include <span>

#include "apps/viewer/gpu.h"

namespace honeycomb::Viewer {

/// The connectivity of a mesh to draw: face f is the loop corners[faceOffsets[f]] .. corners[faceOffsets[f+1]-1].
struct CellMeshContent {
  std::int32_t vertexCount = 0;
  std::span<const std::int32_t> faceOffsets;   ///< faces + 1, from 0
  std::span<const std::int32_t> corners;       ///< vertex of each corner
  std::span<const std::uint32_t> faceColours;  ///< one a face: 0xAABBGGRR, sRGB
};

/// A mesh's connectivity on the device, uploaded once; points come anew with every picture, from whatever buffer an
/// evaluator left them in.
///
/// Faces are drawn as fans round their centres, so that the outer side of every triangle is an edge of the face and the
/// fragment shader knows how far from it a pixel is. Index i < vertexCount is a vertex, vertexCount + f the centre of
/// f.
///     cells:    f's centre, corner i, corner i+1       3 x corners indices; the first vertex brings the face's colour
///     solid:    corner 0, corner i, corner i+1         3 x (corners - 2 faces) indices, for the shadows
struct CellMesh {
  std::int32_t vertexCount = 0;
  std::uint32_t cellIndexCount = 0;
  std::uint32_t solidIndexCount = 0;
  Buffer cellIndices;
  Buffer solidIndices;
  Buffer faceOffsets;
  Buffer corners;
  Buffer faceColours;
};

/// Errors: invalidMesh when the content does not fit together; tooLarge; outOfMemory.
Result<CellMesh> uploadCells(const Gpu& gpu, const CellMeshContent& content);

}  // namespace honeycomb::Viewer
