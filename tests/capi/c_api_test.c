/* Calls every function of honeycomb.h from C99, as a program with a C compiler alone does. The numbers are compared
 * with the C++ API's in same_as_cpp_test.cpp. */
#include <stdlib.h>

#include "honeycomb.h"
#include "parts.h"
#include "shapes.h"

int failures = 0;

/* ---- What a program without C++ sees of errors ---------------------------------------------------------------------
 */

static void versions_and_names(void) {
  CHECK(hc_version() == HC_VERSION);
  CHECK(strcmp(hc_status_name(HC_OK), "HC_OK") == 0);
  CHECK(strcmp(hc_status_name(HC_ERROR_INTERNAL), "HC_ERROR_INTERNAL") == 0);
  CHECK(strcmp(hc_status_name(-1), "unknown hc_status") == 0);
  CHECK(strcmp(hc_status_name(13), "unknown hc_status") == 0);
  CHECK(strcmp(hc_last_message(), "") == 0);
  hc_element kind = HC_ELEMENT_OTHER;
  CHECK(hc_last_element(&kind) == -1 && kind == HC_ELEMENT_NONE);
}

/* ---- Context -------------------------------------------------------------------------------------------------------
 */

typedef struct {
  int blocks, errors, notes;
  int refuse; /* blocks to be refused from now on, -1: none */
  char last[1024];
} Listener;

static void* take(void* user, size_t size, size_t alignment) {
  Listener* listener = user;
  if (listener->refuse == 0) return NULL;
  ++listener->blocks;
  return alignment <= 16 ? malloc(size) : NULL;
}

static void give(void* user, void* block) {
  --((Listener*)user)->blocks;
  free(block);
}

static void hear(void* user, hc_severity severity, const char* message) {
  Listener* listener = user;
  ++*(severity == HC_LOG_ERROR ? &listener->errors : &listener->notes);
  strncpy(listener->last, message, sizeof(listener->last) - 1);
}

static hc_context* context_of(Listener* listener) {
  hc_context_options options = {.struct_size = sizeof(options), .allocator = {listener, take, give}};
  options.log = hear;
  options.log_user = listener;
  hc_context* context = NULL;
  OK(hc_context_create(&options, &context));
  return context;
}

static void objects_come_from_the_callers_allocator(void) {
  Listener listener = {.refuse = -1};
  hc_context* context = context_of(&listener);
  const int own = listener.blocks;
  const hc_polygons polygons = cube();
  hc_tables* tables = NULL;
  hc_evaluator* evaluator = NULL;
  OK(hc_tables_create(context, &polygons, NULL, &tables));
  OK(hc_evaluator_create(context, NULL, &evaluator));
  CHECK(own > 0 && listener.blocks == own + 2);

  hc_tables* more = NULL;
  listener.refuse = 0;
  FAILS(hc_tables_create(context, &polygons, NULL, &more), HC_ERROR_OUT_OF_MEMORY, "out of memory");
  CHECK(more == NULL);
  hc_context_destroy(context); /* the objects keep what they need of it */
  hc_tables_destroy(tables);
  hc_evaluator_destroy(evaluator);
  CHECK(listener.blocks == 0);
}

static void the_log_hears_failures_and_notes(void) {
  Listener listener = {.refuse = -1};
  hc_context* context = context_of(&listener);
  const hc_polygons polygons = cube();
  hc_tables_options options = {.struct_size = sizeof(options), .scheme = "hexagons"};
  hc_tables* tables = NULL;
  FAILS(hc_tables_create(context, &polygons, &options, &tables), HC_ERROR_INVALID_ARGUMENT, "there is no 'hexagons'");
  CHECK(listener.errors == 1 && strcmp(listener.last, hc_last_message()) == 0);

  FAILS(hc_tables_triangles(NULL, 0, NULL, 0), HC_ERROR_INVALID_ARGUMENT, "tables is NULL"); /* of no context */
  CHECK(listener.errors == 1);

  /* A pyramid's top has four edges, half-box wants three. */
  const int32_t pyramid_sizes[] = {4, 3, 3, 3, 3}, pyramid[] = {0, 3, 2, 1, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  hc_polygons of_pyramid = {.struct_size = sizeof(of_pyramid), .vertex_count = 5, .face_count = 5};
  of_pyramid.face_sizes = pyramid_sizes;
  of_pyramid.face_vertices = pyramid;
  of_pyramid.face_vertex_count = COUNT(pyramid);
  options.scheme = "half-box";
  options.levels = 1;
  OK(hc_tables_create(context, &of_pyramid, &options, &tables));
  CHECK(listener.notes == 1 && strstr(listener.last, "convert") != NULL);
  hc_tables_info info = {.struct_size = sizeof(info)};
  OK(hc_tables_get_info(tables, &info));
  CHECK(info.level_count == 2);
  hc_tables_destroy(tables);
  hc_context_destroy(context);
  hc_context_destroy(NULL);
}

static void bad_contexts(void) {
  hc_context* context = NULL;
  hc_context_options options = {.struct_size = sizeof(options)};
  FAILS(hc_context_create(NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "context is NULL");
  options.allocator.allocate = take;
  FAILS(hc_context_create(&options, &context), HC_ERROR_INVALID_ARGUMENT, "give both or neither");
  options.struct_size = 3;
  FAILS(hc_context_create(&options, &context), HC_ERROR_INVALID_ARGUMENT, "set it to sizeof(hc_context_options)");
  CHECK(context == NULL);
  OK(hc_context_create(NULL, &context));
  hc_context_destroy(context);
}

/* A program built with a newer header than the library's. */
static void newer_structs(void) {
  struct {
    hc_evaluator_options known;
    int64_t more;
  } newer = {{.struct_size = sizeof(newer)}, 0};
  hc_evaluator* evaluator = NULL;
  OK(hc_evaluator_create(NULL, &newer.known, &evaluator));
  hc_evaluator_destroy(evaluator);
  newer.more = 1;
  FAILS(hc_evaluator_create(NULL, &newer.known, &evaluator), HC_ERROR_UNSUPPORTED, "install a newer one");
}

int main(int count, char** arguments) {
  if (count != 2) return fprintf(stderr, "usage: c_api_test FOLDER\n"), 2;
  versions_and_names(); /* first: nothing has failed yet */
  objects_come_from_the_callers_allocator();
  the_log_hears_failures_and_notes();
  bad_contexts();
  newer_structs();
  test_meshes(arguments[1]);
  test_tables();
  test_evaluation();
  test_files(arguments[1]);
#ifdef HONEYCOMB_WITHOUT_VULKAN
  test_vulkan_absent();
#endif
  if (failures > 0) fprintf(stderr, "%d checks failed\n", failures);
  return failures > 0;
}
