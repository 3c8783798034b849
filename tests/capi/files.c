/* Table files: tables that were saved give what they gave. */
#include <stdlib.h>

#include "parts.h"
#include "shapes.h"

enum { kLast = 2, kLastPoints = 72, kLastCorners = 216, kLastFaces = 38 };

static hc_tables* made(hc_normals normals, int32_t tiles) {
  const hc_polygons polygons = cube();
  hc_tables_options options = {.struct_size = sizeof(options), .levels = kLast, .normals = normals, .tiles = tiles};
  hc_tables* tables = NULL;
  OK(hc_tables_create(NULL, &polygons, &options, &tables));
  return tables;
}

static hc_tables* saved_and_opened(const hc_tables* tables, const char* path, int32_t trusted) {
  const hc_open_options options = {.struct_size = sizeof(options), .trusted = trusted};
  hc_tables* opened = NULL;
  OK(hc_tables_save(tables, path));
  OK(hc_tables_open(NULL, path, &options, &opened));
  return opened;
}

static void same_points(const hc_tables* a, const hc_tables* b, int32_t level, size_t points, int with_normals) {
  float values[2][6 * kLastPoints];
  hc_evaluator* evaluator = NULL;
  OK(hc_evaluator_create(NULL, NULL, &evaluator));
  const hc_points control = {kCubePoints, 24, 0, 3, 3};
  for (int i = 0; i < 2; ++i) {
    const hc_points_out positions = {values[i], COUNT(values[i]), 0, 3, 6},
                        normals = {values[i], COUNT(values[i]), 3, 3, 6};
    memset(values[i], 0, sizeof(values[i]));
    OK(hc_evaluate(evaluator, i == 0 ? a : b, level, &control, &positions, with_normals ? &normals : NULL));
  }
  CHECK(values[0][6 * points - 6] != 0 && memcmp(values[0], values[1], sizeof(values[0])) == 0);
  hc_evaluator_destroy(evaluator);
}

static void points_and_normals_are_the_same(const char* path) {
  for (hc_normals normals = HC_NORMALS_FAST; normals <= HC_NORMALS_EXACT; ++normals) {
    hc_tables* tables = made(normals, 1);
    hc_tables* opened = saved_and_opened(tables, path, normals == HC_NORMALS_EXACT);
    hc_tables_info info = {.struct_size = sizeof(info)};
    OK(hc_tables_get_info(opened, &info));
    CHECK(info.level_count == kLast && info.control_points == 8 && info.tiles == 1 && info.normals == normals);
    CHECK(info.limits == (normals == HC_NORMALS_EXACT) && info.bytes > 0);
    same_points(tables, opened, 1, 24, 0);
    same_points(tables, opened, kLast, kLastPoints, 1);
    hc_tables_destroy(tables);
    hc_tables_destroy(opened);
  }
}

static void the_last_level_has_its_mesh(const char* path) {
  hc_tables* tables = made(HC_NORMALS_NONE, 0);
  hc_tables* opened = saved_and_opened(tables, path, 0);
  hc_level_counts a = {.struct_size = sizeof(a)}, b = {.struct_size = sizeof(b)};
  OK(hc_tables_get_counts(tables, kLast, &a));
  OK(hc_tables_get_counts(opened, kLast, &b));
  CHECK(memcmp(&a, &b, sizeof(a)) == 0);
  int32_t numbers[2][3 * (kLastCorners - 2 * kLastFaces)];
  OK(hc_tables_triangles(tables, kLast, numbers[0], a.triangle_indices));
  OK(hc_tables_triangles(opened, kLast, numbers[1], a.triangle_indices));
  CHECK(memcmp(numbers[0], numbers[1], sizeof(numbers[0])) == 0);
  OK(hc_tables_lines(tables, kLast, numbers[0], a.line_indices));
  OK(hc_tables_lines(opened, kLast, numbers[1], a.line_indices));
  CHECK(memcmp(numbers[0], numbers[1], sizeof(int32_t) * kLastCorners) == 0);
  const int32_t *offsets[2], *vertices[2];
  OK(hc_tables_faces(tables, kLast, &offsets[0], &vertices[0]));
  OK(hc_tables_faces(opened, kLast, &offsets[1], &vertices[1]));
  CHECK(memcmp(offsets[0], offsets[1], sizeof(int32_t) * (kLastFaces + 1)) == 0);
  CHECK(memcmp(vertices[0], vertices[1], sizeof(int32_t) * kLastCorners) == 0);
  hc_origin origins[2][kLastFaces];
  OK(hc_tables_face_origins(tables, kLast, origins[0], kLastFaces));
  OK(hc_tables_face_origins(opened, kLast, origins[1], kLastFaces));
  for (size_t f = 0; f < kLastFaces; ++f) {
    CHECK(origins[0][f].number == origins[1][f].number && origins[0][f].kind == origins[1][f].kind);
    CHECK(origins[1][f].level == -1);
  }
  FAILS(hc_tables_vertex_origins(opened, kLast, origins[1], kLastPoints), HC_ERROR_UNSUPPORTED, "of faces alone");
  FAILS(hc_tables_get_counts(opened, 1, &b), HC_ERROR_INVALID_ARGUMENT, "the last level alone");
  FAILS(hc_tables_save(opened, path), HC_ERROR_INVALID_ARGUMENT, "in a file already");
  hc_tables_destroy(tables);
  hc_tables_destroy(opened);
}

static void bad_files_and_places(const char* path) {
  hc_tables* tables = made(HC_NORMALS_NONE, 0);
  hc_tables* none = NULL;
  FAILS(hc_tables_save(tables, "/nowhere/tables.hct"), HC_ERROR_UNWRITABLE, "/nowhere/tables.hct");
  FAILS(hc_tables_save(tables, NULL), HC_ERROR_INVALID_ARGUMENT, "path is NULL");
  FAILS(hc_tables_save(NULL, path), HC_ERROR_INVALID_ARGUMENT, "tables is NULL");
  FAILS(hc_tables_open(NULL, "/nowhere/tables.hct", NULL, &none), HC_ERROR_UNREADABLE, "/nowhere/tables.hct");
  FAILS(hc_tables_open(NULL, NULL, NULL, &none), HC_ERROR_INVALID_ARGUMENT, "path is NULL");
  FAILS(hc_tables_open(NULL, path, NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "tables is NULL");
  FILE* file = fopen(path, "w");
  CHECK(file != NULL && fputs("no tables at all", file) >= 0 && fclose(file) == 0);
  FAILS(hc_tables_open(NULL, path, NULL, &none), HC_ERROR_INVALID_FILE, path);
  CHECK(none == NULL);
  hc_tables_destroy(tables);
}

void test_files(const char* folder) {
  char path[4096];
  snprintf(path, sizeof(path), "%s/c_api_test.hct", folder);
  points_and_normals_are_the_same(path);
  the_last_level_has_its_mesh(path);
  bad_files_and_places(path);
  remove(path);
}
