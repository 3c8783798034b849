/* Meshes from files. */
#include "parts.h"
#include "shapes.h"

static void write_text(const char* path, const char* text) {
  FILE* file = fopen(path, "w");
  CHECK(file != NULL);
  if (file == NULL) return;
  fputs(text, file);
  fclose(file);
}

/* A tetrahedron with a sharp edge. */
static const char kTetrahedron[] =
    "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1.5\n"
    "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\nt crease 2/1/0 0 1 2.5\n";

static void a_mesh_of_a_file(const char* path) {
  write_text(path, kTetrahedron);
  hc_mesh* mesh = NULL;
  OK(hc_mesh_read(NULL, path, &mesh));
  const float* positions = NULL;
  size_t count = 0;
  OK(hc_mesh_positions(mesh, &positions, &count));
  OK(hc_mesh_positions(mesh, &positions, NULL));
  CHECK(count == 12 && positions[11] == 1.5F);
  hc_polygons polygons = {.struct_size = sizeof(polygons)};
  OK(hc_mesh_polygons(mesh, &polygons));
  CHECK(polygons.vertex_count == 4 && polygons.face_count == 4 && polygons.face_vertex_count == 12);
  CHECK(polygons.face_sizes == NULL && polygons.face_offsets[4] == 12 && polygons.face_vertices[4] == 3);
  CHECK(polygons.crease_count == 1 && polygons.creases[0].vertex1 == 1 && polygons.creases[0].sharpness == 2.5);
  CHECK(polygons.corner_count == 0 && polygons.corners == NULL);

  hc_tables* tables = NULL;
  OK(hc_tables_create(NULL, &polygons, NULL, &tables)); /* as it came */
  hc_tables_destroy(tables);
  FAILS(hc_mesh_polygons(mesh, NULL), HC_ERROR_INVALID_ARGUMENT, "hc_polygons is NULL");
  FAILS(hc_mesh_positions(mesh, NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "positions is NULL");
  hc_mesh_destroy(mesh);
}

static void bad_files(const char* path) {
  hc_mesh* mesh = NULL;
  write_text(path, "v 0 0 0\nf 1 2 3\n");
  FAILS(hc_mesh_read(NULL, path, &mesh), HC_ERROR_INVALID_FILE, ".obj:2: ");
  hc_element kind = HC_ELEMENT_NONE;
  CHECK(hc_last_element(&kind) == 2 && kind == HC_ELEMENT_OTHER);
  write_text(path, "v 0 0 0\nv 1 0 0\nv 0 1e39 0\nf 1 2 3\n");
  FAILS(hc_mesh_read(NULL, path, &mesh), HC_ERROR_INVALID_POSITIONS, "vertex 2 (counted from 0) overflows");
  CHECK(hc_last_element(&kind) == 2 && kind == HC_ELEMENT_VERTEX);
  FAILS(hc_mesh_read(NULL, "/nowhere/mesh.obj", &mesh), HC_ERROR_UNREADABLE, "/nowhere/mesh.obj");
  FAILS(hc_mesh_read(NULL, "mesh.docx", &mesh), HC_ERROR_INVALID_ARGUMENT, "mesh files end in .obj, .ply");
  FAILS(hc_mesh_read(NULL, NULL, &mesh), HC_ERROR_INVALID_ARGUMENT, "path is NULL");
  FAILS(hc_mesh_read(NULL, path, NULL), HC_ERROR_INVALID_ARGUMENT, "mesh is NULL");
  FAILS(hc_mesh_polygons(NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "mesh is NULL");
  FAILS(hc_mesh_positions(NULL, NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "mesh is NULL");
  CHECK(mesh == NULL);
  hc_mesh_destroy(NULL);
}

void test_meshes(const char* folder) {
  char path[4096];
  snprintf(path, sizeof(path), "%s/c_api_test.obj", folder);
  a_mesh_of_a_file(path);
  bad_files(path);
  remove(path);
}
