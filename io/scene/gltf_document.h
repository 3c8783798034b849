#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "far/base/result.h"

namespace honeycomb::Io {

/// Where the bytes of a buffer are: in its URI, in a file beside the document, or in the GLB itself.
struct GltfBuffer {
  std::string uri;
  std::filesystem::path file;
  std::string_view binary;

  bool isEmbedded() const;
};

/// A glTF 2 file, its JSON or a GLB: what Assimp does not tell of it.
class GltfDocument {
 public:
  /// `bytes` are those of the file `path` and outlive this. Errors: invalidFile, where its JSON can't be understood.
  static Result<GltfDocument> parse(const std::filesystem::path& path, std::string_view bytes);

  const std::filesystem::path& path() const { return path_; }
  const nlohmann::json& json() const { return json_; }
  /// The member of an object; null where it isn't there.
  static const nlohmann::json& member(const nlohmann::json& object, const char* key);
  /// A list of the document ("nodes", ..); empty where it isn't there.
  const nlohmann::json& list(const char* key) const;

  GltfBuffer buffer(std::size_t index) const;
  /// The files beside it that its buffers are in, there or not.
  std::vector<std::filesystem::path> bufferFiles() const;

 private:
  GltfDocument() = default;

  std::filesystem::path path_;
  nlohmann::json json_;
  std::string_view binary_;  // the GLB's second chunk
};

}  // namespace honeycomb::Io
