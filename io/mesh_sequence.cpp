#include "io/mesh_sequence.h"

#include <fmt/format.h>

#include <algorithm>

#include "far/base/index.h"
#include "io/frame_checks.h"

namespace honeycomb::Io {

MeshSequence::MeshSequence(std::vector<std::filesystem::path> files, const Mesh& first, Read read)
    : files_(std::move(files)), polygons_(first.polygons), read_(read) {
  info_.pointCount = polygons_.vertexCount;
  info_.frameCount = static_cast<std::int32_t>(files_.size());
}

Result<void> MeshSequence::checkSame(std::size_t f, const Far::Polygons& polygons) const {
  const auto differs = [&](const std::string& what) {
    return fail(ErrorCode::invalidFile,
                fmt::format("{}: frame {} (counted from 0) {} {}; all frames of a sequence need the same faces",
                            files_[f].string(), f, what, files_[0].string()),
                static_cast<std::int64_t>(f));
  };
  if (polygons.vertexCount != polygons_.vertexCount)
    return differs(fmt::format("has {} vertices, not {} as", polygons.vertexCount, polygons_.vertexCount));
  if (polygons.faceCount() != polygons_.faceCount())
    return differs(fmt::format("has {} faces, not {} as", polygons.faceCount(), polygons_.faceCount()));
  if (polygons.indices == polygons_.indices && polygons.faceOffsets == polygons_.faceOffsets) return {};
  for (std::int64_t face = 0; face < polygons.faceCount(); ++face) {
    const auto loop = [face](const Far::Polygons& of) {
      const std::size_t begin = at(of.faceOffsets[at(face)]);
      return std::span(of.indices).subspan(begin, at(of.faceOffsets[at(face) + 1]) - begin);
    };
    const auto here = loop(polygons), there = loop(polygons_);
    if (!std::equal(here.begin(), here.end(), there.begin(), there.end()))
      return differs(fmt::format("has another face {} (counted from 1) than", face + 1));
  }
  return {};
}

Result<std::span<const float>> MeshSequence::frame(std::int32_t f, std::vector<float>& storage) const {
  if (const auto there = checkFrame(files_[0].string(), f, info_); !there) return tl::unexpected(there.error());
  const std::filesystem::path& file = files_[at(f)];
  const Result<Mesh> mesh = read_(file);
  if (!mesh) return tl::unexpected(mesh.error());
  if (const auto same = checkSame(at(f), mesh->polygons); !same) return tl::unexpected(same.error());
  storage.assign(mesh->positions.begin(), mesh->positions.end());
  if (const auto finite = checkFinite(file.string(), f, storage); !finite) return tl::unexpected(finite.error());
  return storage;
}

}  // namespace honeycomb::Io
