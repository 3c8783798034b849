#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "far/base/result.h"
#include "io/obj.h"

namespace honeycomb::Io {

/// What every writer of meshes checks before anything is written. Errors: those of writeObj but unwritable.
template <class Real>
Result<void> checkContent(const std::filesystem::path& path, const ObjContent<Real>& content);

/// The texture coordinate of each vertex, -1 for none, where all its corners have the same; nothing where there are
/// seams. Linear.
std::optional<std::vector<std::int32_t>> texcoordsOfVertices(std::span<const std::int32_t> corners,
                                                             std::span<const std::int32_t> cornerTexcoords,
                                                             std::size_t vertexCount);

}  // namespace honeycomb::Io
