/* The meshes of the C tests. */
#ifndef HONEYCOMB_TESTS_CAPI_SHAPES_H
#define HONEYCOMB_TESTS_CAPI_SHAPES_H

#include "check.h"

static const int32_t kCubeSizes[] = {4, 4, 4, 4, 4, 4};
static const int64_t kCubeOffsets[] = {0, 4, 8, 12, 16, 20, 24};
static const int32_t kCubeVertices[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
static const float kCubePoints[] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};

static inline hc_polygons cube(void) {
  hc_polygons polygons = {.struct_size = sizeof(hc_polygons)};
  polygons.vertex_count = 8;
  polygons.face_count = 6;
  polygons.face_sizes = kCubeSizes;
  polygons.face_vertices = kCubeVertices;
  polygons.face_vertex_count = 24;
  return polygons;
}

#endif
