#include <algorithm>
#include <span>
#include <vector>

#include "capi/structs.h"
#include "capi/tables.h"
#include "far/base/index.h"

namespace honeycomb::Capi {

Result<void> checkLevel(const hc_tables* tables, std::int32_t level) {
  if (tables == nullptr) return refuse("tables is NULL; give those of hc_tables_create()");
  if (level >= 0 && level <= tables->levelCount()) return {};
  return refuse(fmt::format("level {} is out of range; use 0 to {}", level, tables->levelCount()));
}

namespace {

/// Files have the mesh of the last level alone. Errors: invalidOption.
Result<void> checkMesh(const hc_tables* tables, std::int32_t level) {
  if (auto there = checkLevel(tables, level); !there) return there;
  if (!tables->file || level == tables->levelCount()) return {};
  return refuse(
      fmt::format("tables of a file have the mesh of the last level alone, which is {}", tables->levelCount()));
}

hc_level_counts countsOfFile(const OpenedFile& file) {
  const auto corners = std::ssize(file.mesh.faceVertices);
  const auto lines = std::ssize(file.mesh.lines);
  hc_level_counts counts{};
  counts.points = file.levels.pointCount(file.levels.levelCount());
  counts.vertices = file.mesh.vertexCount;
  counts.edges = lines / 2;
  counts.faces = std::ssize(file.mesh.faceOffsets) - 1;
  counts.corners = corners;
  counts.boundary_edges = lines == 0 ? 0 : lines - corners;
  counts.triangle_indices = std::ssize(file.mesh.triangles);
  counts.line_indices = lines;
  return counts;
}

hc_level_counts countsOfLevel(const Far::Level& level) {
  const Far::Topology& mesh = level.topology;
  hc_level_counts counts{};
  counts.points = level.pointCount();
  counts.vertices = mesh.vertexCount();
  counts.edges = mesh.edgeCount();
  counts.faces = mesh.faceCount();
  counts.corners = mesh.halfEdgeCount();
  counts.boundary_edges = mesh.boundaryEdgeCount();
  counts.triangle_indices = 3 * (counts.corners - 2 * counts.faces);
  counts.line_indices = 2 * counts.edges;
  return counts;
}

/// Of a level that has a mesh.
hc_level_counts countsOf(const hc_tables& tables, std::int32_t level) {
  return tables.file ? countsOfFile(*tables.file) : countsOfLevel(tables.refinement->level(level));
}

/// Is there room for `count` things of the caller's array?
Result<void> checkRoom(const void* array, std::int64_t capacity, std::int64_t count, const char* what) {
  if (array == nullptr) return refuse(fmt::format("{} is NULL; give room for {}", what, count));
  if (capacity >= count) return {};
  return refuse(fmt::format("{} has room for {}, there are {}; hc_tables_get_counts() tells", what, capacity, count));
}

/// Copies what numbers() gives, once the level is known to be there and to have room for `count` of its counts.
template <class Item, class Numbers>
hc_status copyOut(const hc_tables* tables, std::int32_t level, Item* items, std::int64_t capacity, const char* what,
                  std::int64_t hc_level_counts::*count, const Numbers& numbers) {
  return guarded(contextIn(tables), [&]() -> Result<void> {
    if (auto there = checkMesh(tables, level); !there) return there;
    if (auto room = checkRoom(items, capacity, countsOf(*tables, level).*count, what); !room) return room;
    const auto found = numbers(*tables);
    std::copy(found.begin(), found.end(), items);
    return {};
  });
}

/// From the tables of a file or made of a refinement.
std::vector<std::int32_t> copyOf(std::span<const std::int32_t> numbers) {
  return {numbers.begin(), numbers.end()};
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

/// A file doesn't say at which level a face was born.
std::vector<hc_origin> originsOfFile(const OpenedFile& file) {
  std::vector<hc_origin> result;
  for (const std::int32_t origin : file.mesh.faceOrigins)
    result.push_back({origin < 0 ? -1 - origin : origin, -1, origin < 0 ? HC_ELEMENT_VERTEX : HC_ELEMENT_FACE});
  return result;
}

std::int64_t byteCount(const hc_tables& tables) {
  if (tables.file) return tables.file->file.byteCount();
  return tables.refinement->byteCount() + (tables.tiles ? tables.tiles->byteCount() : 0) +
         (tables.fastNormals ? tables.fastNormals->byteCount() : 0);
}

}  // namespace
}  // namespace honeycomb::Capi

using namespace honeycomb;

hc_status hc_tables_get_info(const hc_tables* tables, hc_tables_info* info) {
  return Capi::guarded(Capi::contextIn(tables), [&]() -> Result<void> {
    if (auto there = Capi::checkLevel(tables, 0); !there) return there;
    const hc_tables_info known{sizeof(hc_tables_info),  tables->levelCount(),           tables->hasLimits(),
                               tables->normals,         tables->tileTable() != nullptr, tables->levels().pointCount(0),
                               Capi::byteCount(*tables)};
    return Capi::writeStruct(known, info, "hc_tables_info");
  });
}

hc_status hc_tables_get_counts(const hc_tables* tables, int32_t level, hc_level_counts* counts) {
  return Capi::guarded(Capi::contextIn(tables), [&]() -> Result<void> {
    if (auto there = Capi::checkMesh(tables, level); !there) return there;
    return Capi::writeStruct(Capi::countsOf(*tables, level), counts, "hc_level_counts");
  });
}

hc_status hc_tables_faces(const hc_tables* tables, int32_t level, const int32_t** offsets, const int32_t** vertices) {
  return Capi::guarded(Capi::contextIn(tables), [&]() -> Result<void> {
    if (auto there = Capi::checkMesh(tables, level); !there) return there;
    const bool file = tables->file.has_value();
    if (offsets != nullptr)
      *offsets = (file ? tables->file->mesh.faceOffsets : tables->refinement->faceOffsets(level)).data();
    if (vertices != nullptr)
      *vertices = (file ? tables->file->mesh.faceVertices : tables->refinement->level(level).topology.vert()).data();
    return {};
  });
}

hc_status hc_tables_triangles(const hc_tables* tables, int32_t level, int32_t* indices, int64_t capacity) {
  return Capi::copyOut(tables, level, indices, capacity, "indices", &hc_level_counts::triangle_indices,
                       [&](const hc_tables& own) {
                         return own.file ? Capi::copyOf(own.file->mesh.triangles) : own.refinement->triangles(level);
                       });
}

hc_status hc_tables_lines(const hc_tables* tables, int32_t level, int32_t* indices, int64_t capacity) {
  return Capi::copyOut(tables, level, indices, capacity, "indices", &hc_level_counts::line_indices,
                       [&](const hc_tables& own) {
                         return own.file ? Capi::copyOf(own.file->mesh.lines) : own.refinement->lines(level);
                       });
}

hc_status hc_tables_face_origins(const hc_tables* tables, int32_t level, hc_origin* origins, int64_t capacity) {
  return Capi::copyOut(tables, level, origins, capacity, "origins", &hc_level_counts::faces, [&](const hc_tables& own) {
    return own.file ? Capi::originsOfFile(*own.file)
                    : Capi::inCallersNumbers(*own.refinement, own.refinement->faceOrigins(level));
  });
}

hc_status hc_tables_vertex_origins(const hc_tables* tables, int32_t level, hc_origin* origins, int64_t capacity) {
  if (tables != nullptr && tables->file)
    return Capi::report(Capi::contextIn(tables), HC_ERROR_UNSUPPORTED,
                        "tables of a file have origins of faces alone; use "
                        "those, or hc_tables_create()");
  return Capi::copyOut(tables, level, origins, capacity, "origins", &hc_level_counts::vertices,
                       [&](const hc_tables& own) {
                         return Capi::inCallersNumbers(*own.refinement, own.refinement->vertexOrigins(level));
                       });
}
