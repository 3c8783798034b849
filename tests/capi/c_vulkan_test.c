/* Refinement recorded into a caller's command buffer, from C: the CPU's bits. */
#include <vulkan/vulkan_core.h>
/* Behind vulkan.h, whose types it must agree with. */
#include "engine_c.h"
#include "shapes.h"

int failures = 0;

enum { kLevels = 3, kPoints = 216 };

/* Vulkan's own handles and functions go into the structs without a cast. */
static void types_are_vulkans_own(void) {
  const VkInstance instance = VK_NULL_HANDLE;
  const VkDevice device = VK_NULL_HANDLE;
  const VkBuffer buffer = VK_NULL_HANDLE;
  const PFN_vkGetInstanceProcAddr of_instance = NULL;
  const PFN_vkGetDeviceProcAddr of_device = NULL;
  const VkAllocationCallbacks* allocator = NULL;
  hc_vulkan_device given = {.struct_size = sizeof(given), .instance = instance, .device = device};
  given.allocator = allocator;
  given.get_instance_proc_addr = of_instance;
  given.get_device_proc_addr = of_device;
  const hc_vulkan_range range = {buffer, 0, 0};
  hc_vulkan* vulkan = NULL;
  FAILS(hc_vulkan_create(NULL, &given, &vulkan), HC_ERROR_INVALID_ARGUMENT, "");
  CHECK(vulkan == NULL && range.buffer == VK_NULL_HANDLE);
}

static hc_tables* tables_with(hc_normals normals) {
  const hc_polygons polygons = cube();
  hc_tables_options options = {.struct_size = sizeof(options), .levels = kLevels, .normals = normals};
  hc_tables* tables = NULL;
  OK(hc_tables_create(NULL, &polygons, &options, &tables));
  return tables;
}

/* The same from a table file, with tiles. */
static hc_tables* tables_of_file(hc_normals normals, const char* folder) {
  char path[4096];
  snprintf(path, sizeof(path), "%s/c_vulkan_test.hct", folder);
  const hc_polygons polygons = cube();
  hc_tables_options options = {.struct_size = sizeof(options), .levels = kLevels, .normals = normals, .tiles = 1};
  hc_tables *tables = NULL, *opened = NULL;
  OK(hc_tables_create(NULL, &polygons, &options, &tables));
  OK(hc_tables_save(tables, path));
  OK(hc_tables_open(NULL, path, NULL, &opened));
  hc_tables_destroy(tables);
  remove(path);
  return opened;
}

static void record(void* user, struct VkCommandBuffer_T* commands) {
  OK(hc_vulkan_record((const hc_vulkan_binding*)user, commands));
}

/* x y z, gap; normals packed. Ends the tables. */
static void a_frame_has_the_bits_of_the_cpu(test_engine* engine, hc_vulkan* vulkan, hc_tables* tables,
                                            hc_normals normals, int32_t tiled) {
  hc_vulkan_table_options options = {.struct_size = sizeof(options), .tiled = tiled, .refined = {0, 3, 4}};
  if (normals != HC_NORMALS_NONE) options.normals = (hc_layout){0, 3, 3};
  hc_vulkan_table* table = NULL;
  OK(hc_vulkan_table_create(vulkan, tables, &options, &table));
  hc_vulkan_sizes sizes = {.struct_size = sizeof(sizes)};
  OK(hc_vulkan_table_get_sizes(table, &sizes));
  CHECK(sizes.control == sizeof(kCubePoints) && sizes.refined == (4 * kPoints - 1) * sizeof(float) && sizes.table > 0);
  CHECK(sizes.normals == (normals == HC_NORMALS_NONE ? 0 : 3 * kPoints * sizeof(float)));

  const test_buffer control = test_engine_buffer(engine, sizes.control),
                    refined = test_engine_buffer(engine, sizes.refined);
  hc_vulkan_targets targets = {.struct_size = sizeof(targets), .control = {control.buffer, 0, control.bytes}};
  targets.refined = (hc_vulkan_range){refined.buffer, 0, refined.bytes};
  test_buffer directions = {0};
  if (sizes.normals > 0) {
    directions = test_engine_buffer(engine, sizes.normals);
    targets.normals = (hc_vulkan_range){directions.buffer, 0, directions.bytes};
  }
  hc_vulkan_binding* binding = NULL;
  OK(hc_vulkan_binding_create(table, &targets, &binding));
  memcpy(control.numbers, kCubePoints, sizeof(kCubePoints));
  test_engine_frame(engine, record, binding);

  float points[3 * kPoints], unit[3 * kPoints];
  hc_evaluator* evaluator = NULL;
  OK(hc_evaluator_create(NULL, NULL, &evaluator));
  const hc_points from = {kCubePoints, 24, 0, 3, 3};
  const hc_points_out to = {points, COUNT(points), 0, 3, 3}, to_unit = {unit, COUNT(unit), 0, 3, 3};
  OK(hc_evaluate(evaluator, tables, kLevels, &from, &to, sizes.normals > 0 ? &to_unit : NULL));
  int same = 1;
  for (size_t p = 0; p < kPoints; ++p) same &= memcmp(points + 3 * p, refined.numbers + 4 * p, 3 * sizeof(float)) == 0;
  CHECK(same);
  CHECK(sizes.normals == 0 || memcmp(unit, directions.numbers, sizeof(unit)) == 0);
  hc_evaluator_destroy(evaluator);
  hc_vulkan_binding_destroy(binding);
  hc_vulkan_table_destroy(table);
  hc_tables_destroy(tables);
}

static void lock(void* user) {
  ++*(int*)user;
}

static void a_queue_is_locked_by_both_functions_or_none(const test_engine* engine) {
  int turns = 0;
  hc_vulkan_device device = {.struct_size = sizeof(device), .lock_queue = lock, .queue_owner = &turns};
  test_engine_device(engine, &device);
  hc_vulkan* vulkan = NULL;
  FAILS(hc_vulkan_create(NULL, &device, &vulkan), HC_ERROR_INVALID_ARGUMENT, "give both");
  device.lock_queue = NULL;
  device.unlock_queue = lock;
  FAILS(hc_vulkan_create(NULL, &device, &vulkan), HC_ERROR_INVALID_ARGUMENT, "give both");
  device.lock_queue = lock;
  OK(hc_vulkan_create(NULL, &device, &vulkan));
  hc_vulkan_destroy(vulkan);
}

static void bad_calls(hc_vulkan* vulkan) {
  hc_tables* tables = tables_with(HC_NORMALS_NONE);
  hc_vulkan_table* table = NULL;
  hc_vulkan_binding* binding = NULL;
  hc_vulkan* none = NULL;
  hc_vulkan_table_options options = {.struct_size = sizeof(options), .normals = {0, 3, 3}};
  hc_vulkan_targets targets = {.struct_size = sizeof(targets)};
  hc_vulkan_sizes sizes = {.struct_size = 0};
  FAILS(hc_vulkan_create(NULL, NULL, &none), HC_ERROR_INVALID_ARGUMENT, "device is NULL");
  FAILS(hc_vulkan_create(NULL, NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "vulkan is NULL");
  FAILS(hc_vulkan_table_create(NULL, tables, NULL, &table), HC_ERROR_INVALID_ARGUMENT, "vulkan is NULL");
  FAILS(hc_vulkan_table_create(vulkan, NULL, NULL, &table), HC_ERROR_INVALID_ARGUMENT, "tables is NULL");
  FAILS(hc_vulkan_table_create(vulkan, tables, NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "table is NULL");
  FAILS(hc_vulkan_table_create(vulkan, tables, &options, &table), HC_ERROR_INVALID_ARGUMENT,
        "hc_tables_options.normals");
  options = (hc_vulkan_table_options){.struct_size = sizeof(options), .level = 4};
  FAILS(hc_vulkan_table_create(vulkan, tables, &options, &table), HC_ERROR_INVALID_ARGUMENT, "use 0 to 3");
  options = (hc_vulkan_table_options){.struct_size = sizeof(options), .refined = {0, 3, 2}};
  FAILS(hc_vulkan_table_create(vulkan, tables, &options, &table), HC_ERROR_INVALID_ARGUMENT, "stride");
  CHECK(table == NULL);
  OK(hc_vulkan_table_create(vulkan, tables, NULL, &table));
  FAILS(hc_vulkan_table_get_sizes(table, &sizes), HC_ERROR_INVALID_ARGUMENT, "sizeof(hc_vulkan_sizes)");
  FAILS(hc_vulkan_table_get_sizes(NULL, &sizes), HC_ERROR_INVALID_ARGUMENT, "table is NULL");
  FAILS(hc_vulkan_binding_create(table, &targets, &binding), HC_ERROR_INVALID_ARGUMENT, "");
  FAILS(hc_vulkan_binding_create(table, NULL, &binding), HC_ERROR_INVALID_ARGUMENT, "targets is NULL");
  FAILS(hc_vulkan_binding_create(table, &targets, NULL), HC_ERROR_INVALID_ARGUMENT, "binding is NULL");
  FAILS(hc_vulkan_binding_create(NULL, &targets, &binding), HC_ERROR_INVALID_ARGUMENT, "table is NULL");
  FAILS(hc_vulkan_record(NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "binding is NULL");
  CHECK(binding == NULL);
  hc_vulkan_table_destroy(table);
  hc_tables_destroy(tables);
  hc_vulkan_destroy(NULL);
  hc_vulkan_table_destroy(NULL);
  hc_vulkan_binding_destroy(NULL);
}

int main(int count, char** arguments) {
  if (count != 2) return fprintf(stderr, "usage: c_vulkan_test FOLDER\n"), 2;
  types_are_vulkans_own();
  test_engine* engine = test_engine_create();
  hc_vulkan_device device = {.struct_size = sizeof(device)};
  test_engine_device(engine, &device);
  hc_vulkan* vulkan = NULL;
  OK(hc_vulkan_create(NULL, &device, &vulkan));
  for (hc_normals normals = HC_NORMALS_NONE; normals <= HC_NORMALS_EXACT; ++normals)
    for (int32_t tiled = 0; tiled <= 1; ++tiled)
      a_frame_has_the_bits_of_the_cpu(engine, vulkan, tables_with(normals), normals, tiled);
  a_frame_has_the_bits_of_the_cpu(engine, vulkan, tables_of_file(HC_NORMALS_FAST, arguments[1]), HC_NORMALS_FAST, 1);
  a_frame_has_the_bits_of_the_cpu(engine, vulkan, tables_of_file(HC_NORMALS_EXACT, arguments[1]), HC_NORMALS_EXACT, 0);
  bad_calls(vulkan);
  a_queue_is_locked_by_both_functions_or_none(engine);
  hc_vulkan_destroy(vulkan);
  CHECK(test_engine_destroy(engine) == 0);
  return failures > 0;
}
