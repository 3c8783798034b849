#pragma once

#include <filesystem>

#include "far/base/result.h"
#include "io/obj.h"

namespace honeycomb::Io {

/// Writes a binary little-endian PLY with polygons of any side count. Of each vertex: x y z, nx ny nz (float or double,
/// as `Real`: the same bits), red green blue (uchar, 255 for 1: what all readers take), s t; of each face
/// vertex_indices, and where a vertex has several texture coordinates (seams) texcoord, u v a corner, instead of s t;
/// corners without one have 0 0. Counts of lists are uchar, or uint where a face has too many sides. The file appears
/// under `path` only when whole. Errors: those of writeObj.
template <class Real>
Result<void> writePly(const std::filesystem::path& path, const ObjContent<Real>& content);

}  // namespace honeycomb::Io
