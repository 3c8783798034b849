/* Plays back a deforming mesh from C: tables once, points and normals every frame. Prints a checksum a frame. */
#include <honeycomb.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kAround = 16, kAcross = 8, kVertices = kAround * kAcross, kCorners = 4 * kVertices, kFrames = 3 };

/* A torus of quads. */
static int32_t sizes[kVertices], corners[kCorners];

static void make_torus(void) {
  for (int i = 0; i < kVertices; ++i) {
    const int u = i / kAcross, v = i % kAcross, next_u = (u + 1) % kAround, next_v = (v + 1) % kAcross;
    const int32_t quad[4] = {i, next_u * kAcross + v, next_u * kAcross + next_v, u * kAcross + next_v};
    for (int k = 0; k < 4; ++k) corners[4 * i + k] = quad[k];
    sizes[i] = 4;
  }
}

/* Its points in a frame: it breathes and sways. */
static void pose(int frame, float* points) {
  for (int i = 0; i < kVertices; ++i) {
    const double u = 6.283185307179586 * (i / kAcross) / kAround, v = 6.283185307179586 * (i % kAcross) / kAcross;
    const double thick = 0.4 + 0.1 * sin(3 * u + 0.5 * frame);
    points[3 * i] = (float)((1 + thick * cos(v)) * cos(u));
    points[3 * i + 1] = (float)((1 + thick * cos(v)) * sin(u));
    points[3 * i + 2] = (float)(thick * sin(v) + 0.2 * sin(u + 0.3 * frame));
  }
}

static void must(hc_status status) {
  if (status == HC_OK) return;
  fprintf(stderr, "%s: %s\n", hc_status_name(status), hc_last_message());
  exit(1);
}

static uint32_t checksum(const float* numbers, size_t count) {
  const unsigned char* bytes = (const unsigned char*)numbers;
  uint32_t sum = 2166136261u; /* FNV-1a */
  for (size_t i = 0; i < count * sizeof(float); ++i) sum = (sum ^ bytes[i]) * 16777619u;
  return sum;
}

int main(void) {
  /* Once: the tables, an evaluator, the index buffer. */
  make_torus();
  const hc_polygons mesh = {.struct_size = sizeof(mesh),
                            .vertex_count = kVertices,
                            .face_count = kVertices,
                            .face_sizes = sizes,
                            .face_vertices = corners,
                            .face_vertex_count = kCorners};
  const hc_tables_options options = {
      .struct_size = sizeof(options), .scheme = "akleman", .levels = 3, .normals = HC_NORMALS_FAST, .tiles = 1};
  hc_tables* tables = NULL;
  must(hc_tables_create(NULL, &mesh, &options, &tables));
  hc_evaluator* evaluator = NULL;
  must(hc_evaluator_create(NULL, NULL, &evaluator));
  hc_level_counts counts = {.struct_size = sizeof(counts)};
  must(hc_tables_get_counts(tables, options.levels, &counts));
  int32_t* triangles = malloc(sizeof(int32_t) * (size_t)counts.triangle_indices);
  float* vertices = malloc(sizeof(float) * 6 * (size_t)counts.points);
  if (triangles == NULL || vertices == NULL) return 1;
  must(hc_tables_triangles(tables, options.levels, triangles, counts.triangle_indices));
  printf("%lld vertices, %lld triangles\n", (long long)counts.vertices, (long long)(counts.triangle_indices / 3));

  /* Every frame: x y z of the position, x y z of the normal, as a vertex buffer has them. */
  float control[3 * kVertices];
  const size_t size = 6 * (size_t)counts.points;
  const hc_points from = {control, 3 * kVertices, 0, 3, 3};
  const hc_points_out positions = {vertices, size, 0, 3, 6}, normals = {vertices, size, 3, 3, 6};
  for (int frame = 0; frame < kFrames; ++frame) {
    pose(frame, control);
    must(hc_evaluate(evaluator, tables, options.levels, &from, &positions, &normals));
    printf("frame %d: checksum %08x\n", frame, checksum(vertices, size));
  }

  free(vertices);
  free(triangles);
  hc_evaluator_destroy(evaluator);
  hc_tables_destroy(tables);
  return 0;
}
