#include <algorithm>
#include <vector>

#include "capi/structs.h"
#include "capi/tables.h"
#include "far/base/index.h"

namespace honeycomb::Capi {

Result<void> checkLevel(const hc_tables* tables, std::int32_t level) {
  if (tables == nullptr) return refuse("tables is NULL; give those of hc_tables_create()");
  if (level >= 0 && level <= tables->refinement.levelCount()) return {};
  return refuse(fmt::format("level {} is out of range; use 0 to {}", level, tables->refinement.levelCount()));
}

namespace {

std::int64_t triangleIndices(const Far::Topology& mesh) {
  return 3 * (std::int64_t{mesh.halfEdgeCount()} - 2 * std::int64_t{mesh.faceCount()});
}

std::int64_t lineIndices(const Far::Topology& mesh) {
  return 2 * std::int64_t{mesh.edgeCount()};
}

/// Is there room for `count` things of the caller's array?
Result<void> checkRoom(const void* array, std::int64_t capacity, std::int64_t count, const char* what) {
  if (array == nullptr) return refuse(fmt::format("{} is NULL; give room for {}", what, count));
  if (capacity >= count) return {};
  return refuse(fmt::format("{} has room for {}, there are {}; hc_tables_get_counts() tells", what, capacity, count));
}

/// Calls numbers() and copies them out, once the level and the room are known to be there.
template <class Item, class Count, class Numbers>
hc_status copyOut(const hc_tables* tables, std::int32_t level, Item* items, std::int64_t capacity, const char* what,
                  const Count& count, const Numbers& numbers) {
  return guarded(contextIn(tables), [&]() -> Result<void> {
    if (const auto there = checkLevel(tables, level); !there) return there;
    const auto room = checkRoom(items, capacity, count(tables->refinement.level(level).topology), what);
    if (!room) return room;
    const auto found = numbers(tables->refinement);
    std::copy(found.begin(), found.end(), items);
    return {};
  });
}

/// Origins in the caller's numbers.
std::vector<hc_origin> inCallersNumbers(const Far::Refinement& refinement, const std::vector<Far::Origin>& origins) {
  const Far::Topology& control = refinement.level(0).topology;
  std::vector<hc_origin> result;
  result.reserve(origins.size());
  for (const Far::Origin& origin : origins)
    result.push_back({origin.vertex ? origin.element : control.inputFace(origin.element), origin.level,
                      origin.vertex ? HC_ELEMENT_VERTEX : HC_ELEMENT_FACE});
  return result;
}

std::int64_t byteCount(const hc_tables& tables) {
  return tables.refinement.byteCount() + (tables.tiles ? tables.tiles->byteCount() : 0) +
         (tables.fastNormals ? tables.fastNormals->byteCount() : 0);
}

}  // namespace
}  // namespace honeycomb::Capi

using namespace honeycomb;

hc_status hc_tables_get_info(const hc_tables* tables, hc_tables_info* info) {
  return Capi::guarded(Capi::contextIn(tables), [&]() -> Result<void> {
    if (const auto there = Capi::checkLevel(tables, 0); !there) return there;
    const Far::Refinement& refinement = tables->refinement;
    const hc_tables_info known{sizeof(hc_tables_info),  refinement.levelCount(),   tables->limits,
                               tables->normals,         tables->tiles.has_value(), refinement.level(0).pointCount(),
                               Capi::byteCount(*tables)};
    return Capi::writeStruct(known, info, "hc_tables_info");
  });
}

hc_status hc_tables_get_counts(const hc_tables* tables, int32_t level, hc_level_counts* counts) {
  return Capi::guarded(Capi::contextIn(tables), [&]() -> Result<void> {
    if (const auto there = Capi::checkLevel(tables, level); !there) return there;
    const Far::Level& found = tables->refinement.level(level);
    const Far::Topology& mesh = found.topology;
    const hc_level_counts known{
        sizeof(hc_level_counts), found.pointCount(),   mesh.vertexCount(),       mesh.edgeCount(),
        mesh.faceCount(),        mesh.halfEdgeCount(), mesh.boundaryEdgeCount(), Capi::triangleIndices(mesh),
        Capi::lineIndices(mesh)};
    return Capi::writeStruct(known, counts, "hc_level_counts");
  });
}

hc_status hc_tables_faces(const hc_tables* tables, int32_t level, const int32_t** offsets, const int32_t** vertices) {
  return Capi::guarded(Capi::contextIn(tables), [&]() -> Result<void> {
    if (const auto there = Capi::checkLevel(tables, level); !there) return there;
    const Far::Topology& mesh = tables->refinement.level(level).topology;
    if (offsets != nullptr) *offsets = mesh.faceOffsets().data();
    if (vertices != nullptr) *vertices = mesh.vert().data();
    return {};
  });
}

hc_status hc_tables_triangles(const hc_tables* tables, int32_t level, int32_t* indices, int64_t capacity) {
  return Capi::copyOut(tables, level, indices, capacity, "indices", Capi::triangleIndices,
                       [&](const Far::Refinement& refinement) { return refinement.triangles(level); });
}

hc_status hc_tables_lines(const hc_tables* tables, int32_t level, int32_t* indices, int64_t capacity) {
  return Capi::copyOut(tables, level, indices, capacity, "indices", Capi::lineIndices,
                       [&](const Far::Refinement& refinement) { return refinement.lines(level); });
}

hc_status hc_tables_face_origins(const hc_tables* tables, int32_t level, hc_origin* origins, int64_t capacity) {
  return Capi::copyOut(
      tables, level, origins, capacity, "origins", [](const Far::Topology& mesh) { return mesh.faceCount(); },
      [&](const Far::Refinement& refinement) {
        return Capi::inCallersNumbers(refinement, refinement.faceOrigins(level));
      });
}

hc_status hc_tables_vertex_origins(const hc_tables* tables, int32_t level, hc_origin* origins, int64_t capacity) {
  return Capi::copyOut(
      tables, level, origins, capacity, "origins", [](const Far::Topology& mesh) { return mesh.vertexCount(); },
      [&](const Far::Refinement& refinement) {
        return Capi::inCallersNumbers(refinement, refinement.vertexOrigins(level));
      });
}
