#include "io/scene/gltf_document.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

namespace honeycomb::Io {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kGlbHeader = 12;  // magic, version, length
constexpr std::size_t kChunkHead = 8;   // length, kind

/// The GLB's chunk of that kind at `place`, which moves behind it.
std::optional<std::string_view> chunk(std::string_view bytes, std::size_t& place, std::string_view kind) {
  std::uint32_t length = 0;
  if (place > bytes.size() || bytes.size() - place < kChunkHead || bytes.substr(place + 4, 4) != kind)
    return std::nullopt;
  std::memcpy(&length, bytes.data() + place, sizeof length);
  place += kChunkHead;
  if (length > bytes.size() - place) return std::nullopt;
  place += length;
  return bytes.substr(place - length, length);
}

std::string percentDecoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned code = 0;
    const bool escape = uri[i] == '%' && i + 2 < uri.size() &&
                        std::from_chars(uri.data() + i + 1, uri.data() + i + 3, code, 16).ptr == uri.data() + i + 3;
    text += escape ? static_cast<char>(code) : uri[i];
    i += escape ? 2 : 0;
  }
  return text;
}

}  // namespace

bool GltfBuffer::isEmbedded() const {
  return uri.substr(0, 5) == "data:";
}

Result<GltfDocument> GltfDocument::parse(const std::filesystem::path& path, std::string_view bytes) {
  GltfDocument document;
  document.path_ = path;
  std::optional<std::string_view> text = bytes;
  if (bytes.substr(0, 4) == "glTF") {
    std::size_t place = kGlbHeader;
    text = chunk(bytes, place, "JSON");
    document.binary_ = chunk(bytes, place, std::string_view("BIN\0", 4)).value_or("");
  }
  if (text) document.json_ = Json::parse(*text, nullptr, false);
  if (document.json_.is_discarded() || !document.json_.is_object())
    return fail(ErrorCode::invalidFile, fmt::format("{}: its JSON can't be understood; export it anew", path.string()));
  return document;
}

const Json& GltfDocument::member(const Json& object, const char* key) {
  static const Json none;
  return object.is_object() && object.contains(key) ? object[key] : none;
}

const Json& GltfDocument::list(const char* key) const {
  static const Json none = Json::array();
  const Json& found = member(json_, key);
  return found.is_array() ? found : none;
}

GltfBuffer GltfDocument::buffer(std::size_t index) const {
  const Json& uri = member(list("buffers")[index], "uri");
  GltfBuffer buffer;
  if (uri.is_string()) buffer.uri = uri.get<std::string>();
  if (buffer.uri.empty() && index == 0) buffer.binary = binary_;
  if (!buffer.uri.empty() && !buffer.isEmbedded()) buffer.file = path_.parent_path() / percentDecoded(buffer.uri);
  return buffer;
}

std::vector<std::filesystem::path> GltfDocument::bufferFiles() const {
  std::vector<std::filesystem::path> files;
  for (std::size_t i = 0; i < list("buffers").size(); ++i)
    if (GltfBuffer found = buffer(i); !found.file.empty()) files.push_back(std::move(found.file));
  return files;
}

}  // namespace honeycomb::Io
