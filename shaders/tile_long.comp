#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_ARB_gpu_shader_int64 : require
#extension GL_EXT_scalar_block_layout : require
// tile_buffer.comp for CPUs with shaderInt64 and scalarBlockLayout: two numbers a store, and as many of these at once as
// two points have. Lavapipe takes a turn of a loop for each lane and instruction, and a third of that for each value.
#define LONG_STORES
uint64_t longOf(vec2 p) { return packUint2x32(floatBitsToUint(p)); }
#include "tile_slices.glsl"
