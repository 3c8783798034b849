#include "io/mesh_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "far/base/index.h"

namespace honeycomb::Io {
namespace {

template <class Real>
Result<void> checkSizes(const ObjContent<Real>& content) {
  const auto& offsets = content.faceOffsets;
  const auto onePerVertex = [&](std::span<const Real> values) {
    return values.empty() || values.size() == content.positions.size();
  };
  const auto& cornerTexcoords = content.cornerTexcoords;
  const bool fit = content.positions.size() % 3 == 0 && onePerVertex(content.normals) &&
                   onePerVertex(content.colours) && content.texcoords.size() % 2 == 0 &&
                   (cornerTexcoords.empty() || cornerTexcoords.size() == content.faceVertices.size()) &&
                   !offsets.empty() && offsets.front() == 0 && std::is_sorted(offsets.begin(), offsets.end()) &&
                   static_cast<std::size_t>(offsets.back()) == content.faceVertices.size();
  if (fit) return {};
  return fail(ErrorCode::invalidOption,
              "the arrays of a mesh do not fit together; give 3 numbers a vertex, 2 a texture coordinate, one texture "
              "coordinate a corner and faces + 1 ascending offsets");
}

/// Are all numbers of corners at least `least` and less than `count`?
Result<void> checkIndices(std::string_view what, std::span<const std::int32_t> corners, std::int32_t least,
                          std::size_t count, std::span<const std::int32_t> offsets) {
  const auto wrong = std::find_if(corners.begin(), corners.end(),
                                  [=](std::int32_t i) { return i < least || i >= static_cast<std::int64_t>(count); });
  if (wrong == corners.end()) return {};
  const auto face = std::upper_bound(offsets.begin(), offsets.end(), wrong - corners.begin()) - offsets.begin() - 1;
  return fail(ErrorCode::invalidMesh,
              fmt::format("face {} names {} {} of {}; correct the index", face, what, *wrong, count), face);
}

template <class Real>
Result<void> checkNumbers(const std::filesystem::path& path, std::string_view what, std::span<const Real> values,
                          std::ptrdiff_t width) {
  const auto wrong = std::find_if(values.begin(), values.end(), [](Real value) { return !std::isfinite(value); });
  if (wrong == values.end()) return {};
  const auto element = (wrong - values.begin()) / width;
  return fail(ErrorCode::invalidPositions,
              fmt::format("{}: not written: the {} {} (counted from 0) has the coordinate {}; scale the mesh down or "
                          "compute in double precision",
                          path.string(), what, element, *wrong),
              element);
}

}  // namespace

template <class Real>
Result<void> checkContent(const std::filesystem::path& path, const ObjContent<Real>& c) {
  return checkSizes(c)
      .and_then([&] { return checkIndices("vertex", c.faceVertices, 0, c.positions.size() / 3, c.faceOffsets); })
      .and_then([&] {
        return checkIndices("texture coordinate", c.cornerTexcoords, -1, c.texcoords.size() / 2, c.faceOffsets);
      })
      .and_then([&] { return checkNumbers(path, "position of vertex", c.positions, 3); })
      .and_then([&] { return checkNumbers(path, "normal of vertex", c.normals, 3); })
      .and_then([&] { return checkNumbers(path, "colour of vertex", c.colours, 3); })
      .and_then([&] { return checkNumbers(path, "texture coordinate", c.texcoords, 2); });
}
template Result<void> checkContent(const std::filesystem::path&, const ObjContent<float>&);
template Result<void> checkContent(const std::filesystem::path&, const ObjContent<double>&);

std::optional<std::vector<std::int32_t>> texcoordsOfVertices(std::span<const std::int32_t> corners,
                                                             std::span<const std::int32_t> cornerTexcoords,
                                                             std::size_t vertexCount) {
  constexpr std::int32_t kUnset = -2;
  std::vector<std::int32_t> texcoords(vertexCount, cornerTexcoords.empty() ? -1 : kUnset);
  for (std::size_t c = 0; c < cornerTexcoords.size(); ++c) {
    std::int32_t& texcoord = texcoords[at(corners[c])];
    if (texcoord != kUnset && texcoord != cornerTexcoords[c]) return std::nullopt;
    texcoord = cornerTexcoords[c];
  }
  std::replace(texcoords.begin(), texcoords.end(), kUnset, -1);
  return texcoords;
}

}  // namespace honeycomb::Io
