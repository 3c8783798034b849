#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "far/base/result.h"
#include "io/mesh.h"

namespace honeycomb::Io {

using ReadMesh = Result<Mesh> (*)(const std::filesystem::path&);

/// What reads a mesh of one pose, by its extension; a new format is one line of the table in mesh_formats.cpp. Errors:
/// invalidOption, listing them.
Result<ReadMesh> meshReader(const std::filesystem::path& path);

/// ".obj, .ply, .gltf, ..": everything that a mesh can be read from, scenes included.
std::string meshInputNames();

/// Reads a mesh of any of these formats; of a scene the first pose of all its nodes. What was joined or left out is
/// appended to `notes`, a sentence each. Errors: those of the reader, the file's name in front; invalidOption for
/// another extension.
Result<Mesh> readAnyMesh(const std::filesystem::path& path, std::vector<std::string>& notes);

}  // namespace honeycomb::Io
