#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/scene/gltf_document.h"

namespace honeycomb::Io {

/// Bytes of one component of an accessor by its componentType; 0: not known.
std::int64_t gltfComponentBytes(std::int64_t componentType);
/// Components of one element of an accessor by its type ("VEC3", ..); 0: not known.
std::int64_t gltfComponents(const nlohmann::json& type);

/// The numbers in a document's buffers, each buffer read once.
class GltfArrays {
 public:
  /// `document` has passed checkGltf and outlives this.
  explicit GltfArrays(const GltfDocument& document) : document_(document) {}

  /// All components of an accessor, element by element, normalized integers as the fractions they mean. Nothing where
  /// it is sparse, has no bufferView (all zero) or its buffer can't be read.
  std::optional<std::vector<double>> numbers(std::size_t accessor);

 private:
  const std::optional<std::string>& bytesOf(std::size_t buffer);

  const GltfDocument& document_;
  std::map<std::size_t, std::optional<std::string>> buffers_;
};

}  // namespace honeycomb::Io
