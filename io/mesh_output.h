#pragma once

#include <filesystem>
#include <string_view>

#include "far/base/result.h"
#include "io/obj.h"

namespace honeycomb::Io {

/// A file format that meshes are written in. A new one is one line of the table in mesh_output.cpp.
struct MeshOutput {
  std::string_view name;  ///< the extension with its dot, in lower case
  Result<void> (*writeSingle)(const std::filesystem::path&, const ObjContent<float>&);
  Result<void> (*writeDouble)(const std::filesystem::path&, const ObjContent<double>&);

  /// Writes the file, whole or not at all. Errors: unwritable, and those of the format.
  Result<void> write(const std::filesystem::path& path, const ObjContent<float>& content) const {
    return writeSingle(path, content);
  }
  /// The same in double precision, or the closest the format has.
  Result<void> write(const std::filesystem::path& path, const ObjContent<double>& content) const {
    return writeDouble(path, content);
  }
};

/// The format of a mesh to be written, by its path's extension, in upper or lower case. Errors: invalidOption, listing
/// the formats.
Result<const MeshOutput*> meshOutput(const std::filesystem::path& path);

}  // namespace honeycomb::Io
