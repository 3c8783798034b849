#pragma once

#include <string_view>

#include "far/base/result.h"

namespace honeycomb::Io {

/// Is a glTF 2 file (its JSON, or a GLB) one that Assimp 5.2 reads without reading past its arrays: do all numbers of
/// nodes, meshes, accessors, views and buffers name what is there, and have skins as many matrices as joints? `name`
/// stands for the file in messages. Errors: invalidFile.
Result<void> checkGltf(std::string_view name, std::string_view bytes);

}  // namespace honeycomb::Io
