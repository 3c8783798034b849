#pragma once

#include "far/base/result.h"
#include "io/scene/gltf_document.h"

namespace honeycomb::Io {

/// Is it a file that Assimp 5.2 reads without reading past its arrays: do all numbers of nodes, meshes, accessors,
/// views and buffers name what is there, and have skins as many matrices as joints? Errors: invalidFile.
Result<void> checkGltf(const GltfDocument& document);

}  // namespace honeycomb::Io
