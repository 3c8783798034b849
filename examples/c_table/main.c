/* Plays back an animation with a table file, from C, without the mesh and without building anything:
 *     honeycomb table build creature.obj creature.hct --levels 3 --tiles
 *     c_table creature.hct creature.pc2
 * Prints what it drew: an engine would hand the index and vertex buffer to its device instead. */
#include <honeycomb.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void must(hc_status status) {
  if (status == HC_OK) return;
  fprintf(stderr, "%s: %s\n", hc_status_name(status), hc_last_message());
  exit(1);
}

static void* room(size_t count, size_t size) {
  void* memory = calloc(count, size);
  if (memory != NULL) return memory;
  fprintf(stderr, "out of memory\n");
  exit(1);
}

/* A PC2 point cache: 12 characters, version, points, first time, sampling, frames; then x y z of every point. */
typedef struct cache {
  FILE* file;
  int32_t points, frames;
} cache;

static cache open_cache(const char* path, int64_t points) {
  char header[32];
  cache opened = {fopen(path, "rb"), 0, 0};
  if (opened.file == NULL || fread(header, sizeof(header), 1, opened.file) != 1 ||
      memcmp(header, "POINTCACHE2", 12) != 0) {
    fprintf(stderr, "%s: is no PC2 point cache\n", path);
    exit(1);
  }
  memcpy(&opened.points, header + 16, 4);
  memcpy(&opened.frames, header + 28, 4);
  if (opened.points != points) {
    fprintf(stderr, "%s: has %d points, the table wants %lld\n", path, (int)opened.points, (long long)points);
    exit(1);
  }
  return opened;
}

static void print_box(const char* name, const float* numbers, int64_t points) {
  float low[3] = {numbers[0], numbers[1], numbers[2]}, high[3] = {numbers[0], numbers[1], numbers[2]};
  for (int64_t i = 0; i < points; ++i)
    for (int c = 0; c < 3; ++c) {
      const float x = numbers[3 * i + c];
      low[c] = x < low[c] ? x : low[c];
      high[c] = x > high[c] ? x : high[c];
    }
  printf("%s from (%.2f %.2f %.2f) to (%.2f %.2f %.2f)\n", name, low[0], low[1], low[2], high[0], high[1], high[2]);
}

int main(int argc, char** argv) {
  if (argc != 3) {
    fprintf(stderr, "usage: c_table TABLE.hct CACHE.pc2\n");
    return 2;
  }
  /* Once: the file is mapped and used where it lies. */
  hc_tables* tables = NULL;
  must(hc_tables_open(NULL, argv[1], NULL, &tables));
  hc_tables_info info = {.struct_size = sizeof(info)};
  must(hc_tables_get_info(tables, &info));
  hc_level_counts counts = {.struct_size = sizeof(counts)};
  must(hc_tables_get_counts(tables, info.level_count, &counts));
  int32_t* triangles = room((size_t)counts.triangle_indices, sizeof(int32_t));
  must(hc_tables_triangles(tables, info.level_count, triangles, counts.triangle_indices));
  hc_evaluator* evaluator = NULL;
  must(hc_evaluator_create(NULL, NULL, &evaluator));
  const cache animation = open_cache(argv[2], info.control_points);
  printf("%d frames of %lld vertices and %lld triangles\n", (int)animation.frames, (long long)counts.vertices,
         (long long)(counts.triangle_indices / 3));

  /* Every frame. */
  const size_t size = 3 * (size_t)counts.points, control_size = 3 * (size_t)info.control_points;
  float* vertices = room(size, sizeof(float));
  float* control = room(control_size, sizeof(float));
  const hc_points from = {control, control_size, 0, 3, 3};
  const hc_points_out positions = {vertices, size, 0, 3, 3};
  for (int32_t frame = 0; frame < animation.frames; ++frame) {
    if (fread(control, sizeof(float), control_size, animation.file) != control_size) {
      fprintf(stderr, "%s: ends in frame %d\n", argv[2], (int)frame);
      return 1;
    }
    must(hc_evaluate(evaluator, tables, info.level_count, &from, &positions, NULL));
    if (frame == 0) print_box("first frame:", vertices, counts.vertices);
  }
  print_box("last frame:", vertices, counts.vertices);

  fclose(animation.file);
  free(control);
  free(vertices);
  free(triangles);
  hc_evaluator_destroy(evaluator);
  hc_tables_destroy(tables);
  return 0;
}
