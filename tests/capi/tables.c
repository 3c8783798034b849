/* Tables: from arrays, and what can be asked of them. */
#include <stdlib.h>

#include "parts.h"
#include "shapes.h"

static hc_tables* tables_of_cube(const hc_tables_options* options) {
  const hc_polygons polygons = cube();
  hc_tables* tables = NULL;
  OK(hc_tables_create(NULL, &polygons, options, &tables));
  return tables;
}

static void counts_of_a_cube(void) {
  hc_tables* tables = tables_of_cube(NULL); /* akleman, 2 levels */
  hc_tables_info info = {.struct_size = sizeof(info)};
  OK(hc_tables_get_info(tables, &info));
  CHECK(info.level_count == 2 && info.control_points == 8 && info.bytes > 0);
  CHECK(info.limits == 0 && info.tiles == 0 && info.normals == HC_NORMALS_NONE);
  static const int64_t kCorners[] = {24, 72, 216}, kFaces[] = {6, 14, 38}, kVertices[] = {8, 24, 72};
  for (int32_t level = 0; level <= 2; ++level) {
    hc_level_counts counts = {.struct_size = sizeof(counts)};
    OK(hc_tables_get_counts(tables, level, &counts));
    CHECK(counts.corners == kCorners[level] && counts.faces == kFaces[level]);
    CHECK(counts.vertices == kVertices[level] && counts.points == counts.vertices);
    CHECK(counts.edges == kCorners[level] / 2 && counts.boundary_edges == 0);
    CHECK(counts.line_indices == kCorners[level]);
    CHECK(counts.triangle_indices == 3 * (kCorners[level] - 2 * kFaces[level]));
  }
  hc_tables_destroy(tables);
  hc_tables_destroy(NULL);
}

static void index_buffers_of_a_cube(void) {
  hc_tables* tables = tables_of_cube(NULL);
  const int32_t *offsets = NULL, *vertices = NULL;
  OK(hc_tables_faces(tables, 0, &offsets, &vertices));
  CHECK(memcmp(vertices, kCubeVertices, sizeof(kCubeVertices)) == 0);
  CHECK(offsets[0] == 0 && offsets[6] == 24);
  OK(hc_tables_faces(tables, 0, NULL, NULL));

  int32_t triangles[36], lines[24];
  OK(hc_tables_triangles(tables, 0, triangles, COUNT(triangles)));
  static const int32_t kFirst[] = {0, 2, 3, 0, 3, 1};
  CHECK(memcmp(triangles, kFirst, sizeof(kFirst)) == 0);
  OK(hc_tables_lines(tables, 0, lines, COUNT(lines)));
  for (size_t i = 0; i < COUNT(lines); i += 2) CHECK(lines[i] != lines[i + 1] && lines[i] >= 0 && lines[i] < 8);
  FAILS(hc_tables_triangles(tables, 0, triangles, 35), HC_ERROR_INVALID_ARGUMENT, "room for 35, there are 36");
  FAILS(hc_tables_lines(tables, 0, NULL, 24), HC_ERROR_INVALID_ARGUMENT, "indices is NULL");
  FAILS(hc_tables_lines(tables, 0, lines, -1), HC_ERROR_INVALID_ARGUMENT, "room for -1");
  FAILS(hc_tables_triangles(tables, 3, triangles, 36), HC_ERROR_INVALID_ARGUMENT, "use 0 to 2");
  FAILS(hc_tables_lines(tables, -1, lines, 24), HC_ERROR_INVALID_ARGUMENT, "level -1");
  hc_tables_destroy(tables);
}

/* A quad and, behind it, two triangles on it: sorted, the triangles come first. */
static void origins_are_in_the_callers_numbers(void) {
  const int32_t sizes[] = {4, 3, 3}, vertices[] = {0, 1, 2, 3, 1, 0, 4, 3, 2, 5};
  hc_polygons mesh = {.struct_size = sizeof(mesh), .vertex_count = 6, .face_count = 3, .face_vertex_count = 10};
  mesh.face_sizes = sizes;
  mesh.face_vertices = vertices;
  hc_tables* tables = NULL;
  OK(hc_tables_create(NULL, &mesh, NULL, &tables));
  hc_origin faces[3], points[6];
  OK(hc_tables_face_origins(tables, 0, faces, 3));
  CHECK(faces[0].number == 1 && faces[1].number == 2 && faces[2].number == 0);
  CHECK(faces[2].kind == HC_ELEMENT_FACE && faces[2].level == 0);
  OK(hc_tables_vertex_origins(tables, 0, points, 6));
  CHECK(points[5].number == 5 && points[5].kind == HC_ELEMENT_VERTEX);
  FAILS(hc_tables_face_origins(tables, 0, faces, 2), HC_ERROR_INVALID_ARGUMENT, "room for 2, there are 3");
  FAILS(hc_tables_vertex_origins(tables, 1, NULL, 9), HC_ERROR_INVALID_ARGUMENT, "origins is NULL");
  hc_tables_destroy(tables);
}

static void bad_polygons(void) {
  hc_tables* tables = NULL;
  hc_element kind = HC_ELEMENT_NONE;
  hc_polygons mesh = cube();
  FAILS(hc_tables_create(NULL, NULL, NULL, &tables), HC_ERROR_INVALID_ARGUMENT, "polygons is NULL");
  FAILS(hc_tables_create(NULL, &mesh, NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "tables is NULL");
#define REFUSES(change, status, words) \
  (mesh = cube(), change, FAILS(hc_tables_create(NULL, &mesh, NULL, &tables), status, words))
  REFUSES(mesh.struct_size = 0, HC_ERROR_INVALID_ARGUMENT, "sizeof(hc_polygons)");
  REFUSES(mesh.vertex_count = -1, HC_ERROR_INVALID_ARGUMENT, "vertex_count is -1");
  REFUSES(mesh.face_count = 0, HC_ERROR_INVALID_ARGUMENT, "at least one face");
  REFUSES(mesh.face_sizes = NULL, HC_ERROR_INVALID_ARGUMENT, "face_sizes and face_offsets");
  REFUSES(mesh.face_offsets = kCubeOffsets, HC_ERROR_INVALID_ARGUMENT, "face_sizes and face_offsets");
  REFUSES(mesh.face_vertices = NULL, HC_ERROR_INVALID_ARGUMENT, "face_vertices is NULL");
  REFUSES(mesh.face_vertex_count = -1, HC_ERROR_INVALID_ARGUMENT, "a count of -1");
  REFUSES(mesh.face_vertex_count = 23, HC_ERROR_INVALID_MESH, "entries 0 to 24 of face_vertices, which has 23");
  REFUSES(mesh.face_vertex_count = INT64_MAX, HC_ERROR_TOO_LARGE, "split it");
  REFUSES(mesh.vertex_count = INT32_MAX, HC_ERROR_INVALID_MESH, "some vertex is in no face");
  REFUSES(mesh.crease_count = 1, HC_ERROR_INVALID_ARGUMENT, "creases is NULL");
  REFUSES(mesh.corner_count = 1, HC_ERROR_INVALID_ARGUMENT, "corners is NULL");

  int64_t offsets[] = {0, 4, 8, 7, 16, 20, 24};
  REFUSES((mesh.face_sizes = NULL, mesh.face_offsets = offsets), HC_ERROR_INVALID_MESH, "descend at face 2");
  CHECK(hc_last_element(&kind) == 2 && kind == HC_ELEMENT_FACE);
  offsets[0] = -4;
  offsets[3] = 12;
  REFUSES((mesh.face_sizes = NULL, mesh.face_offsets = offsets), HC_ERROR_INVALID_MESH, "entries -4 to 24");
  const int32_t negative[] = {4, 4, -4, 4, 4, 4};
  REFUSES(mesh.face_sizes = negative, HC_ERROR_INVALID_MESH, "face 2 has -4 sides");

  int32_t vertices[24];
  memcpy(vertices, kCubeVertices, sizeof(vertices));
  vertices[5] = -1;
  REFUSES(mesh.face_vertices = vertices, HC_ERROR_INVALID_MESH, "face 1 names vertex -1");
  vertices[5] = 8;
  REFUSES(mesh.face_vertices = vertices, HC_ERROR_INVALID_MESH, "face 1 names vertex 8");
  const int32_t corner = 9;
  REFUSES((mesh.corners = &corner, mesh.corner_count = 1), HC_ERROR_INVALID_MESH, "9");
  const hc_crease crease = {0, 7, 1};
  REFUSES((mesh.creases = &crease, mesh.crease_count = 1), HC_ERROR_INVALID_MESH, "crease");
#undef REFUSES
  CHECK(tables == NULL);
}

static void bad_options(void) {
  const hc_polygons mesh = cube();
  hc_tables* tables = NULL;
  hc_tables_options options;
  hc_option option = {"tension", "0.6"};
#define REFUSES(change, status, words)                                                        \
  (options = (hc_tables_options){.struct_size = sizeof(options), .options = &option}, change, \
   FAILS(hc_tables_create(NULL, &mesh, &options, &tables), status, words))
  REFUSES(options.struct_size = 4096, HC_ERROR_INVALID_ARGUMENT, "struct_size is 4096");
  REFUSES(options.scheme = "akleman:1,", HC_ERROR_INVALID_ARGUMENT, "a name is missing");
  REFUSES(options.levels = -1, HC_ERROR_INVALID_ARGUMENT, "levels is -1");
  REFUSES(options.levels = 21, HC_ERROR_INVALID_ARGUMENT, "--levels 21: give a number from 1 to 20");
  REFUSES(options.levels = 20, HC_ERROR_TOO_LARGE, "half-edges");
  REFUSES(options.memory_limit = 100, HC_ERROR_TOO_LARGE, "use fewer levels");
  REFUSES((options.memory_limit = 100, options.scheme = "akleman:1,zhang-wang:1"), HC_ERROR_TOO_LARGE,
          "memory_limit is 100");
  REFUSES(options.memory_limit = -1, HC_ERROR_INVALID_ARGUMENT, "memory_limit is -1");
  REFUSES(options.normals = 3, HC_ERROR_INVALID_ARGUMENT, "hc_normals");
  REFUSES(options.order = -1, HC_ERROR_INVALID_ARGUMENT, "hc_order");
  REFUSES((options.options = NULL, options.option_count = 1), HC_ERROR_INVALID_ARGUMENT, "options is NULL");
  options.option_count = 1;
  REFUSES((option.value = "1.5", options.option_count = 1), HC_ERROR_INVALID_ARGUMENT, "tension");
  REFUSES((option.name = "ratio", option.value = "half", options.option_count = 1), HC_ERROR_INVALID_ARGUMENT,
          "--ratio: 'half' is no number");
  REFUSES((option.value = "0.25", options.option_count = 1), HC_ERROR_INVALID_ARGUMENT, "only trisect");
  REFUSES((option.name = "colour", options.option_count = 1), HC_ERROR_INVALID_ARGUMENT,
          "no scheme has such an option");
  REFUSES((option.name = NULL, options.option_count = 1), HC_ERROR_INVALID_ARGUMENT, "name of option 0 is NULL");
  REFUSES((option.name = "ccv-offset", options.scheme = "zhang-wang", options.option_count = 1),
          HC_ERROR_INVALID_ARGUMENT, "set central_points");
  REFUSES(options.central_points = 1, HC_ERROR_INVALID_ARGUMENT, "akleman has no central control vertices");
#undef REFUSES
  CHECK(tables == NULL);
}

static void bad_queries(void) {
  hc_tables* tables = tables_of_cube(NULL);
  hc_tables_info info = {.struct_size = 1};
  hc_level_counts counts = {.struct_size = 1};
  FAILS(hc_tables_get_info(tables, &info), HC_ERROR_INVALID_ARGUMENT, "sizeof(hc_tables_info)");
  FAILS(hc_tables_get_info(tables, NULL), HC_ERROR_INVALID_ARGUMENT, "hc_tables_info is NULL");
  FAILS(hc_tables_get_info(NULL, &info), HC_ERROR_INVALID_ARGUMENT, "tables is NULL");
  FAILS(hc_tables_get_counts(tables, 0, &counts), HC_ERROR_INVALID_ARGUMENT, "sizeof(hc_level_counts)");
  FAILS(hc_tables_get_counts(tables, 3, &counts), HC_ERROR_INVALID_ARGUMENT, "use 0 to 2");
  FAILS(hc_tables_faces(NULL, 0, NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "tables is NULL");
  hc_tables_destroy(tables);
}

void test_tables(void) {
  counts_of_a_cube();
  index_buffers_of_a_cube();
  origins_are_in_the_callers_numbers();
  bad_polygons();
  bad_options();
  bad_queries();
}
