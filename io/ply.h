#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string_view>

#include "far/base/result.h"
#include "io/mesh.h"

namespace honeycomb::Io {

/// Reads a PLY file, ascii or binary of either byte order. Of the element `vertex` come x y z, red green blue (whole
/// numbers in parts of their type's largest, others as they are), and s t, u v or texture_u texture_v as texture
/// coordinates; of `face` the list vertex_indices (or vertex_index) and the list texcoord (u v a corner), which goes
/// before those of vertices. Other elements and properties are passed over. Linear in the file's size. Errors:
/// unreadable; invalidFile, naming the line in the header and in ascii files (element: it), else the vertex or face
/// counted from 0 and the byte, for what can't be read, a face of fewer than three sides, an index out of range, a file
/// that is cut off, no vertices or no faces; invalidPositions (element: the vertex, counted from 0) for NaN or infinity
/// in a position; tooLarge past 2^31 - 1 vertices or corners; outOfMemory.
Result<Mesh> readPly(const std::filesystem::path& path);

/// The same from bytes in memory; `name` stands for the file in messages. `maxElements` limits vertices and corners.
Result<Mesh> parsePly(std::string_view bytes, std::string_view name,
                      std::int64_t maxElements = std::numeric_limits<std::int32_t>::max());

}  // namespace honeycomb::Io
