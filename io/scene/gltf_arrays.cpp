#include "io/scene/gltf_arrays.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include "far/base/index.h"
#include "io/mapped_file.h"

namespace honeycomb::Io {
namespace {

using Json = nlohmann::json;

std::optional<std::string> base64Decoded(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
  }
  return bytes;
}

template <class T>
double componentAt(const char* bytes, bool normalized) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  if constexpr (std::is_floating_point_v<T>) return static_cast<double>(value);
  const double number = static_cast<double>(value);
  return normalized ? std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0) : number;
}

double component(std::int64_t type, const char* bytes, bool normalized) {
  switch (type) {
    case 5120:
      return componentAt<std::int8_t>(bytes, normalized);
    case 5121:
      return componentAt<std::uint8_t>(bytes, normalized);
    case 5122:
      return componentAt<std::int16_t>(bytes, normalized);
    case 5123:
      return componentAt<std::uint16_t>(bytes, normalized);
    case 5125:
      return componentAt<std::uint32_t>(bytes, normalized);
    default:
      return componentAt<float>(bytes, normalized);
  }
}

std::int64_t whole(const Json& object, const char* key) {
  const Json& value = GltfDocument::member(object, key);
  return value.is_number_integer() ? value.get<std::int64_t>() : 0;
}

}  // namespace

std::int64_t gltfComponentBytes(std::int64_t componentType) {
  const std::int64_t type = componentType;
  return type == 5120 || type == 5121 ? 1 : type == 5122 || type == 5123 ? 2 : type == 5125 || type == 5126 ? 4 : 0;
}

std::int64_t gltfComponents(const Json& type) {
  constexpr std::array<std::pair<std::string_view, std::int64_t>, 7> kTypes{
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
  for (const auto& [name, components] : kTypes)
    if (type.is_string() && type.get_ref<const std::string&>() == name) return components;
  return 0;
}

const std::optional<std::string>& GltfArrays::bytesOf(std::size_t index) {
  const auto [entry, fresh] = buffers_.try_emplace(index);
  if (!fresh) return entry->second;
  const GltfBuffer buffer = document_.buffer(index);
  if (buffer.isEmbedded()) {
    constexpr std::string_view kBase64 = ";base64,";
    const std::size_t start = buffer.uri.find(kBase64);
    if (start != std::string::npos)
      entry->second = base64Decoded(std::string_view(buffer.uri).substr(start + kBase64.size()));
  } else if (buffer.file.empty()) {
    entry->second = buffer.binary;
  } else if (const Result<MappedFile> file = MappedFile::open(buffer.file)) {
    entry->second = file->text();
  }
  return entry->second;
}

std::optional<std::vector<double>> GltfArrays::numbers(std::size_t accessor) {
  const Json& of = document_.list("accessors")[accessor];
  const std::int64_t count = whole(of, "count"), components = gltfComponents(GltfDocument::member(of, "type"));
  const std::int64_t type = whole(of, "componentType"), size = gltfComponentBytes(type);
  const bool plain = GltfDocument::member(of, "sparse").is_null() && !GltfDocument::member(of, "bufferView").is_null();
  if (!plain) return std::nullopt;
  const Json& view = document_.list("bufferViews")[at(whole(of, "bufferView"))];
  const std::optional<std::string>& bytes = bytesOf(at(whole(view, "buffer")));
  const std::int64_t stride = whole(view, "byteStride") > 0 ? whole(view, "byteStride") : size * components;
  const std::int64_t begin = whole(view, "byteOffset") + whole(of, "byteOffset");
  if (!bytes || std::ssize(*bytes) < begin + (count - 1) * stride + size * components) return std::nullopt;
  const bool normalized = GltfDocument::member(of, "normalized") == true;
  std::vector<double> result;
  for (std::int64_t e = 0; e < count; ++e)
    for (std::int64_t c = 0; c < components; ++c)
      result.push_back(component(type, bytes->data() + begin + e * stride + c * size, normalized));
  return result;
}

}  // namespace honeycomb::Io
