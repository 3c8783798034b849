#include "io/glb_document.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "far/base/index.h"
#include "io/mesh_content.h"
#include "io/triangulate.h"

namespace honeycomb::Io {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they stand in memory");

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr std::uint32_t kGlbMagic = 0x46546C67, kGlbVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

/// Its text is as long as that of any float.
constexpr float kLongestFloat = -1.17549435e-38F;

void appendWords(std::initializer_list<std::uint32_t> words, std::vector<std::byte>& bytes) {
  for (const std::uint32_t word : words) {
    const auto four = std::as_bytes(std::span(&word, 1));
    bytes.insert(bytes.end(), four.begin(), four.end());
  }
}

Json positionAccessor(std::size_t view, std::int64_t offset, std::int64_t count, const GlbBounds& bounds) {
  return {{"bufferView", view}, {"byteOffset", offset}, {"componentType", kFloat}, {"count", count},
          {"type", "VEC3"},     {"min", bounds.least},  {"max", bounds.most}};
}

/// Gathers `width` numbers for each entry of `sources`; zeros for those below 0.
std::vector<float> gathered(std::span<const float> values, std::span<const std::int32_t> sources, std::size_t width) {
  std::vector<float> result(width * sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i)
    for (std::size_t k = 0; k < width && sources[i] >= 0; ++k)
      result[width * i + k] = values[width * at(sources[i]) + k];
  return result;
}

}  // namespace

GlbBounds boundsOf(std::span<const float> points) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  GlbBounds bounds{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (std::size_t i = 0; i < points.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      bounds.least[k] = std::min(bounds.least[k], points[i + k]);
      bounds.most[k] = std::max(bounds.most[k], points[i + k]);
    }
  return bounds;
}

GlbDocument::GlbDocument(const ObjContent<float>& content, const FrameInfo& info) : info_(info) {
  splitVertices(content);
  addIndices(content);
  addAttributes(content);
  if (info.frameCount > 1) addAnimation();
  const GlbBounds longest{{kLongestFloat, kLongestFloat, kLongestFloat}, {kLongestFloat, kLongestFloat, kLongestFloat}};
  const std::vector<GlbBounds> all(at(info.frameCount), longest);
  jsonBytes_ = (compose(all).size() + 3) / 4 * 4;
}

/// A vertex of the file for each texture coordinate a vertex has.
void GlbDocument::splitVertices(const ObjContent<float>& content) {
  const std::size_t count = content.positions.size() / 3;
  cornerIndices_.assign(content.faceVertices.begin(), content.faceVertices.end());
  vertices_.resize(count);
  for (std::size_t v = 0; v < count; ++v) vertices_[v] = static_cast<std::int32_t>(v);
  auto whole = texcoordsOfVertices(content.faceVertices, content.cornerTexcoords, count);
  if (whole) {
    texcoords_ = std::move(*whole);
    return;
  }
  constexpr std::int32_t kUnset = -2;
  texcoords_.assign(count, kUnset);
  std::vector<std::int32_t> next(count, -1);  // another of the same vertex
  for (std::size_t c = 0; c < cornerIndices_.size(); ++c) {
    const std::int32_t texcoord = content.cornerTexcoords[c];
    auto i = static_cast<std::int32_t>(cornerIndices_[c]);
    while (texcoords_[at(i)] != texcoord && texcoords_[at(i)] != kUnset && next[at(i)] >= 0) i = next[at(i)];
    if (texcoords_[at(i)] != texcoord && texcoords_[at(i)] != kUnset) {
      next[at(i)] = static_cast<std::int32_t>(vertices_.size());
      i = next[at(i)];
      vertices_.push_back(content.faceVertices[c]);
      texcoords_.push_back(texcoord);
      next.push_back(-1);
    }
    texcoords_[at(i)] = texcoord;
    cornerIndices_[c] = static_cast<std::uint32_t>(i);
  }
}

template <class Number>
void GlbDocument::add(Section section, const std::vector<Number>& numbers, std::int64_t width) {
  const auto bytes = std::as_bytes(std::span(numbers));
  section.count = std::ssize(numbers) / width;
  section.begin = std::ssize(binary_);
  binary_.insert(binary_.end(), bytes.begin(), bytes.end());
  section.end = std::ssize(binary_);
  sections_.push_back(std::move(section));
}

void GlbDocument::addIndices(const ObjContent<float>& content) {
  std::vector<std::uint32_t> indices;
  for (const std::int32_t corner : triangulate(content.faceOffsets, content.faceVertices, content.positions))
    indices.push_back(cornerIndices_[at(corner)]);
  add({"", "SCALAR", kUnsignedInt, kElementArrayBuffer}, indices, 1);
}

void GlbDocument::addAttributes(const ObjContent<float>& content) {
  if (!content.cornerTexcoords.empty()) {
    std::vector<float> uv = gathered(content.texcoords, texcoords_, 2);
    for (std::size_t i = 1; i < uv.size(); i += 2) uv[i] = 1 - uv[i];
    add({"TEXCOORD_0", "VEC2", kFloat, kArrayBuffer}, uv, 2);
  }
  if (!content.colours.empty())
    add({"COLOR_0", "VEC3", kFloat, kArrayBuffer}, gathered(content.colours, vertices_, 3), 3);
  if (!content.normals.empty() && info_.frameCount == 1)
    add({"NORMAL", "VEC3", kFloat, kArrayBuffer}, gathered(content.normals, vertices_, 3), 3);
}

/// Frame f is all of target f - 1, and frame 0 none of any.
void GlbDocument::addAnimation() {
  const std::size_t frames = at(info_.frameCount), targets = frames - 1;
  std::vector<float> weights(frames * targets);
  for (std::size_t f = 0; f < frames; ++f) {
    times_.push_back(static_cast<float>(info_.start + static_cast<double>(f) * info_.rate));
    if (f > 0) weights[f * targets + f - 1] = 1;
  }
  add({"", "SCALAR", kFloat, 0}, times_, 1);
  add({"", "SCALAR", kFloat, 0}, weights, 1);
}

std::int64_t GlbDocument::frameBytes() const {
  return std::ssize(vertices_) * 3 * std::int64_t{sizeof(float)};
}

std::int64_t GlbDocument::fileBytes() const {
  const std::int64_t chunks = static_cast<std::int64_t>(jsonBytes_) + 8 + std::ssize(binary_);
  return kJsonOffset + chunks + info_.frameCount * frameBytes();
}

std::string GlbDocument::compose(std::span<const GlbBounds> bounds) const {
  Json views = Json::array(), accessors = Json::array(), targets = Json::array();
  Json attributes{{"POSITION", sections_.size()}};
  for (const Section& section : sections_) {
    Json view{{"buffer", 0}, {"byteOffset", section.begin}, {"byteLength", section.end - section.begin}};
    if (section.target != 0) view["target"] = section.target;
    if (!section.attribute.empty()) attributes[section.attribute] = accessors.size();
    accessors.push_back({{"bufferView", views.size()},
                         {"componentType", section.componentType},
                         {"count", section.count},
                         {"type", section.type}});
    views.push_back(std::move(view));
  }
  const std::int64_t positionBytes = info_.frameCount * frameBytes();
  for (std::size_t f = 0; f < at(info_.frameCount); ++f) {
    if (f > 0) targets.push_back({{"POSITION", accessors.size()}});
    accessors.push_back(
        positionAccessor(views.size(), static_cast<std::int64_t>(f) * frameBytes(), std::ssize(vertices_), bounds[f]));
  }
  views.push_back({{"buffer", 0},
                   {"byteOffset", std::ssize(binary_)},
                   {"byteLength", positionBytes},
                   {"byteStride", 12},
                   {"target", kArrayBuffer}});

  Json primitive{{"attributes", attributes}, {"indices", 0}, {"material", 0}, {"mode", 4}};
  if (!targets.empty()) primitive["targets"] = targets;
  Json document{{"asset", {{"version", "2.0"}, {"generator", "honeycomb"}}},
                {"scene", 0},
                {"scenes", Json::array({{{"nodes", {0}}}})},
                {"nodes", Json::array({{{"mesh", 0}}})},
                {"meshes", Json::array({{{"primitives", Json::array({primitive})}}})},
                {"materials", Json::array({{{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.5}}},
                                            {"doubleSided", true}}})}};
  if (!targets.empty()) {
    const std::size_t times = sections_.size() - 2, weights = sections_.size() - 1;
    accessors[times]["min"] = {times_.front()};
    accessors[times]["max"] = {times_.back()};
    document["animations"] = Json::array(
        {{{"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}})},
          {"samplers", Json::array({{{"input", times}, {"interpolation", "LINEAR"}, {"output", weights}}})}}});
  }
  document["buffers"] = Json::array({{{"byteLength", std::ssize(binary_) + positionBytes}}});
  document["bufferViews"] = std::move(views);
  document["accessors"] = std::move(accessors);
  return document.dump();
}

std::string GlbDocument::json(std::span<const GlbBounds> bounds) const {
  std::string text = compose(bounds);
  text.resize(jsonBytes_, ' ');
  return text;
}

std::vector<std::byte> GlbDocument::header(std::span<const GlbBounds> bounds) const {
  const auto word = [](std::int64_t value) { return static_cast<std::uint32_t>(value); };
  const std::string text = json(bounds);
  const auto textBytes = std::as_bytes(std::span(text));
  std::vector<std::byte> bytes;
  appendWords({kGlbMagic, kGlbVersion, word(fileBytes()), word(std::ssize(text)), kJsonChunk}, bytes);
  bytes.insert(bytes.end(), textBytes.begin(), textBytes.end());
  appendWords({word(std::ssize(binary_) + info_.frameCount * frameBytes()), kBinaryChunk}, bytes);
  bytes.insert(bytes.end(), binary_.begin(), binary_.end());
  return bytes;
}

}  // namespace honeycomb::Io
