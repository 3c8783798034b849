/* Evaluation on the CPU: what is refused, and that what was asked for is written. */
#include <math.h>

#include "parts.h"
#include "shapes.h"

enum { kLevelPoints = 24 };

static hc_tables* tables_with(int32_t tiles, hc_normals normals, int32_t limits) {
  const hc_polygons polygons = cube();
  hc_tables_options options = {.struct_size = sizeof(options), .levels = 1, .tiles = tiles, .normals = normals};
  options.limits = limits;
  hc_tables* tables = NULL;
  OK(hc_tables_create(NULL, &polygons, &options, &tables));
  return tables;
}

static hc_evaluator* evaluator_of(hc_backend backend) {
  hc_evaluator_options options = {.struct_size = sizeof(options), .backend = backend};
  hc_evaluator* evaluator = NULL;
  OK(hc_evaluator_create(NULL, &options, &evaluator));
  return evaluator;
}

static void points_of_a_cube(void) {
  hc_tables* tables = tables_with(0, HC_NORMALS_NONE, 0);
  hc_evaluator* evaluator = evaluator_of(HC_BACKEND_SERIAL);
  float refined[3 * kLevelPoints];
  const hc_points control = {kCubePoints, 24, 0, 3, 3};
  const hc_points_out out = {refined, COUNT(refined), 0, 3, 3};
  OK(hc_evaluate(evaluator, tables, 1, &control, &out, NULL));
  for (size_t p = 0; p < kLevelPoints; ++p) { /* all lie alike, nearer than the corners and not in the middle */
    const float* x = refined + 3 * p;
    const float distance = sqrtf(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    CHECK(distance > 1 && distance < 1.74F);
  }
  hc_evaluator_destroy(evaluator);
  hc_evaluator_destroy(NULL);
  hc_tables_destroy(tables);
}

static void limits_of_a_cube(void) {
  hc_tables* tables = tables_with(0, HC_NORMALS_NONE, 1);
  hc_evaluator* evaluator = evaluator_of(HC_BACKEND_AUTO);
  float refined[3 * kLevelPoints], positions[3 * kLevelPoints], normals[3 * kLevelPoints];
  const hc_points control = {kCubePoints, 24, 0, 3, 3}, points = {refined, COUNT(refined), 0, 3, 3};
  const hc_points_out out = {refined, COUNT(refined), 0, 3, 3};
  const hc_points_out at = {positions, COUNT(positions), 0, 3, 3}, directions = {normals, COUNT(normals), 0, 3, 3};
  OK(hc_evaluate(evaluator, tables, 1, &control, &out, NULL));
  OK(hc_evaluate_limits(evaluator, tables, HC_ELEMENT_VERTEX, &points, &at, &directions));
  for (size_t p = 0; p < kLevelPoints; ++p) {
    const float *x = positions + 3 * p, *n = normals + 3 * p;
    CHECK(fabsf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1) < 1e-5F);
    CHECK(n[0] * x[0] + n[1] * x[1] + n[2] * x[2] > 0); /* outwards */
  }
  OK(hc_evaluate_limits(evaluator, tables, HC_ELEMENT_FACE, &points, &at, NULL));

  FAILS(hc_evaluate_limits(evaluator, tables, HC_ELEMENT_OTHER, &points, &at, NULL), HC_ERROR_INVALID_ARGUMENT,
        "HC_ELEMENT_FACE");
  FAILS(hc_evaluate_limits(evaluator, tables, HC_ELEMENT_FACE, &points, NULL, NULL), HC_ERROR_INVALID_ARGUMENT,
        "at least one");
  FAILS(hc_evaluate_limits(evaluator, tables, HC_ELEMENT_FACE, NULL, &at, NULL), HC_ERROR_INVALID_ARGUMENT,
        "points is NULL");
  FAILS(hc_evaluate_limits(evaluator, tables, HC_ELEMENT_FACE, &points, &out, NULL), HC_ERROR_INVALID_ARGUMENT,
        "overlap");
  FAILS(hc_evaluate_limits(NULL, tables, HC_ELEMENT_FACE, &points, &at, NULL), HC_ERROR_INVALID_ARGUMENT,
        "evaluator is NULL");
  FAILS(hc_evaluate_limits(evaluator, NULL, HC_ELEMENT_FACE, &points, &at, NULL), HC_ERROR_INVALID_ARGUMENT,
        "tables is NULL");
  const hc_points_out flat = {positions, COUNT(positions), 0, 2, 3};
  FAILS(hc_evaluate_limits(evaluator, tables, HC_ELEMENT_FACE, &points, &flat, NULL), HC_ERROR_INVALID_ARGUMENT,
        "length 2");
  hc_tables_destroy(tables);
  tables = tables_with(0, HC_NORMALS_NONE, 0);
  FAILS(hc_evaluate_limits(evaluator, tables, HC_ELEMENT_VERTEX, &points, &at, NULL), HC_ERROR_INVALID_ARGUMENT,
        "hc_tables_options.limits");
  hc_tables_destroy(tables);
  hc_evaluator_destroy(evaluator);
}

static void bad_buffers(void) {
  hc_tables* tables = tables_with(0, HC_NORMALS_FAST, 0);
  hc_evaluator* evaluator = evaluator_of(HC_BACKEND_SIMD);
  float room[6 * kLevelPoints + 24] = {0};
  float* refined = room + 24;
  hc_points control = {kCubePoints, 24, 0, 3, 3};
  hc_points_out out = {refined, 3 * kLevelPoints, 0, 3, 3},
                normals = {refined + 3 * kLevelPoints, 3 * kLevelPoints, 0, 3, 3};
#define REFUSES(words) \
  FAILS(hc_evaluate(evaluator, tables, 1, &control, &out, &normals), HC_ERROR_INVALID_ARGUMENT, words)
  OK(hc_evaluate(evaluator, tables, 1, &control, &out, &normals));
  FAILS(hc_evaluate(NULL, tables, 1, &control, &out, NULL), HC_ERROR_INVALID_ARGUMENT, "evaluator is NULL");
  FAILS(hc_evaluate(evaluator, NULL, 1, &control, &out, NULL), HC_ERROR_INVALID_ARGUMENT, "tables is NULL");
  FAILS(hc_evaluate(evaluator, tables, 0, &control, &out, NULL), HC_ERROR_INVALID_ARGUMENT,
        "level 0 is the control mesh");
  FAILS(hc_evaluate(evaluator, tables, 2, &control, &out, NULL), HC_ERROR_INVALID_ARGUMENT, "use 0 to 1");
  FAILS(hc_evaluate(evaluator, tables, 1, NULL, &out, NULL), HC_ERROR_INVALID_ARGUMENT, "control is NULL");
  FAILS(hc_evaluate(evaluator, tables, 1, &control, NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "refined is NULL");
  control.size = 23, REFUSES("the buffer holds 23"), control.size = 24;
  out.size -= 1, REFUSES("the buffer holds 71"), out.size += 1;
  normals.size -= 1, REFUSES("the buffer holds 71"), normals.size += 1;
  control.stride = 2, REFUSES("stride at least the length"), control.stride = 3;
  out.offset = -1, REFUSES("offset must be at least 0"), out.offset = 0;
  out.length = 2, REFUSES("must be the same"), out.length = 3;
  normals.length = 2, REFUSES("normals have length 3"), normals.length = 3;
  control.data = refined, REFUSES("overlap those that are read"), control.data = kCubePoints;
  normals.data -= 1, REFUSES("interleave them"), normals.data += 1;
  control.length = out.length = 2, REFUSES("points of length 3 or 4"), control.length = out.length = 3;
#undef REFUSES
  hc_tables_destroy(tables);
  hc_evaluator_destroy(evaluator);
}

static void what_tables_do_not_have(void) {
  hc_tables* tables = tables_with(0, HC_NORMALS_NONE, 0);
  hc_evaluator* tiled = evaluator_of(HC_BACKEND_TBB_TILED);
  hc_evaluator* serial = evaluator_of(HC_BACKEND_SERIAL);
  float refined[3 * kLevelPoints], directions[3 * kLevelPoints];
  const hc_points control = {kCubePoints, 24, 0, 3, 3};
  const hc_points_out out = {refined, COUNT(refined), 0, 3, 3}, normals = {directions, COUNT(directions), 0, 3, 3};
  FAILS(hc_evaluate(tiled, tables, 1, &control, &out, NULL), HC_ERROR_INVALID_ARGUMENT, "hc_tables_options.tiles");
  FAILS(hc_evaluate(serial, tables, 1, &control, &out, &normals), HC_ERROR_INVALID_ARGUMENT,
        "hc_tables_options.normals");
  hc_evaluator_options options = {.struct_size = sizeof(options), .backend = 6};
  hc_evaluator* none = NULL;
  FAILS(hc_evaluator_create(NULL, &options, &none), HC_ERROR_INVALID_ARGUMENT, "backend is 6");
  FAILS(hc_evaluator_create(NULL, NULL, NULL), HC_ERROR_INVALID_ARGUMENT, "evaluator is NULL");
  hc_evaluator_destroy(tiled);
  hc_evaluator_destroy(serial);
  hc_tables_destroy(tables);
}

static void points_that_are_no_numbers(void) {
  hc_tables* tables = tables_with(1, HC_NORMALS_NONE, 0);
  hc_evaluator* evaluator = evaluator_of(HC_BACKEND_AUTO);
  float points[24], refined[3 * kLevelPoints];
  const hc_points control = {points, 24, 0, 3, 3};
  const hc_points_out out = {refined, COUNT(refined), 0, 3, 3};
  memcpy(points, kCubePoints, sizeof(points));
  points[16] = NAN;
  FAILS(hc_evaluate(evaluator, tables, 1, &control, &out, NULL), HC_ERROR_INVALID_POSITIONS, "point 5");
  hc_element kind = HC_ELEMENT_NONE;
  CHECK(hc_last_element(&kind) == 5 && kind == HC_ELEMENT_VERTEX);
  points[16] = -INFINITY;
  FAILS(hc_evaluate(evaluator, tables, 1, &control, &out, NULL), HC_ERROR_INVALID_POSITIONS, "point 5");
  hc_evaluator_destroy(evaluator);
  hc_evaluator_options unchecked = {.struct_size = sizeof(unchecked), .unchecked = 1};
  OK(hc_evaluator_create(NULL, &unchecked, &evaluator));
  OK(hc_evaluate(evaluator, tables, 1, &control, &out, NULL));
  hc_evaluator_destroy(evaluator);
  hc_tables_destroy(tables);
}

void test_evaluation(void) {
  points_of_a_cube();
  limits_of_a_cube();
  bad_buffers();
  what_tables_do_not_have();
  points_that_are_no_numbers();
}
