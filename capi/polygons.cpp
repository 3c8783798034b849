#include "capi/polygons.h"

#include <limits>

#include "capi/structs.h"
#include "far/base/index.h"

namespace honeycomb::Capi {
namespace {

constexpr std::int64_t kMostCorners = std::numeric_limits<std::int32_t>::max();

/// An array of the caller's. Errors: invalidOption.
template <class Item>
Result<void> checkArray(const Item* array, std::int64_t count, const char* name) {
  if (count < 0) return refuse(fmt::format("{}: a count of {}; give 0 or more", name, count));
  if (count > 0 && array == nullptr) return refuse(fmt::format("{} is NULL; give its {} entries", name, count));
  return {};
}

Result<void> checkCounts(const hc_polygons& polygons) {
  if (polygons.vertex_count < 0)
    return refuse(fmt::format("vertex_count is {}; give the number of vertices", polygons.vertex_count));
  if (polygons.face_count < 1)
    return refuse(fmt::format("face_count is {}; give at least one face", polygons.face_count));
  if ((polygons.face_sizes == nullptr) == (polygons.face_offsets == nullptr))
    return refuse("face_sizes and face_offsets say the same; give one of them, and NULL for the other");
  if (polygons.face_vertex_count > kMostCorners || polygons.face_count > kMostCorners)
    return fail(ErrorCode::tooLarge, "the mesh has more than 2^31 - 1 corners; split it");
  if (auto sound = checkArray(polygons.face_vertices, polygons.face_vertex_count, "face_vertices"); !sound)
    return sound;
  if (auto sound = checkArray(polygons.creases, polygons.crease_count, "creases"); !sound) return sound;
  if (auto sound = checkArray(polygons.corners, polygons.corner_count, "corners"); !sound) return sound;
  // Before memory is taken for vertices that nothing names.
  if (polygons.vertex_count > polygons.face_vertex_count)
    return fail(ErrorCode::invalidMesh,
                fmt::format("there are {} vertices and {} corners of faces, so that some vertex is in no face; leave "
                            "such vertices out",
                            polygons.vertex_count, polygons.face_vertex_count));
  return {};
}

/// face_count + 1 offsets.
Result<std::vector<std::int64_t>> readOffsets(const hc_polygons& polygons) {
  const std::size_t faces = at(polygons.face_count);
  if (polygons.face_offsets != nullptr)
    return std::vector<std::int64_t>(polygons.face_offsets, polygons.face_offsets + faces + 1);
  std::vector<std::int64_t> offsets(faces + 1, 0);
  for (std::size_t f = 0; f < faces; ++f) {
    if (polygons.face_sizes[f] < 0)
      return fail(ErrorCode::invalidMesh,
                  fmt::format("face {} has {} sides; give 3 or more", f, polygons.face_sizes[f]),
                  static_cast<std::int64_t>(f), ElementKind::face);
    offsets[f + 1] = offsets[f] + polygons.face_sizes[f];
  }
  return offsets;
}

Result<void> checkOffsets(const std::vector<std::int64_t>& offsets, std::int64_t corners) {
  for (std::size_t f = 0; f + 1 < offsets.size(); ++f)
    if (offsets[f + 1] < offsets[f])
      return fail(ErrorCode::invalidMesh, fmt::format("face_offsets descend at face {}; they must ascend", f),
                  static_cast<std::int64_t>(f), ElementKind::face);
  if (offsets.front() == 0 && offsets.back() == corners) return {};
  return fail(ErrorCode::invalidMesh,
              fmt::format("faces take entries {} to {} of face_vertices, which has {}; they must take all of them",
                          offsets.front(), offsets.back(), corners));
}

}  // namespace

Result<Far::Polygons> readPolygons(const hc_polygons* polygons) {
  if (polygons == nullptr) return refuse("polygons is NULL; give a mesh");
  const Result<hc_polygons> given = readStruct(polygons, "hc_polygons");
  if (!given) return tl::unexpected(given.error());
  if (const auto counted = checkCounts(*given); !counted) return tl::unexpected(counted.error());
  Result<std::vector<std::int64_t>> offsets = readOffsets(*given);
  if (!offsets) return tl::unexpected(offsets.error());
  if (const auto sound = checkOffsets(*offsets, given->face_vertex_count); !sound) return tl::unexpected(sound.error());
  Far::Polygons result;
  result.vertexCount = given->vertex_count;
  result.faceOffsets = std::move(*offsets);
  result.indices.assign(given->face_vertices, given->face_vertices + given->face_vertex_count);
  if (given->corner_count > 0) result.corners.assign(given->corners, given->corners + given->corner_count);
  for (std::int64_t i = 0; i < given->crease_count; ++i) {
    const hc_crease& crease = given->creases[i];
    result.creases.push_back({crease.vertex0, crease.vertex1, crease.sharpness});
  }
  return result;
}

}  // namespace honeycomb::Capi
